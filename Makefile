# mpmlab: `make deps figures` runs everything, `make deps test` checks everything.
#   make CC=clang          another compiler          make ARCH=              portable build
#   make OMP=              no threads                make BUILD=build/x      another folder
#   make WERROR=-Werror    warnings are errors, as in make lint and .ci/run

VERSION = 0.9
CC     = gcc
BUILD  = build
ARCH   = -march=native
OMP    = -fopenmp
JOBS   = $(shell nproc)
DIMS   = 1 2 3
SAN    =
WERROR ?=

OPT    = -O3 $(ARCH) -ffp-contract=fast -fno-math-errno -fno-trapping-math
WARN   = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla -Wstrict-prototypes \
         -Wmissing-prototypes -Wno-psabi $(WERROR) $(if $(OMP),,-Wno-unknown-pragmas)
CFLAGS = -std=gnu11 -g -I. $(OPT) $(OMP) $(SAN) $(WARN)
LDLIBS = -lnetpbm -lgsl -lgslcblas -ljansson -lz -lm

comma  = ,
paren  = (
ROW_ROOMS   = common methods problems fem_ref
STUDY_ROOMS = studies plots
# $(call sources,ROOM): its C files, folders below it included; an empty room is a fault.
sources = $(or $(shell find $(1) -name '*.c' | LC_ALL=C sort),$(error $(1): no C file))
FREE   = $(call sources,common/base) $(call sources,studies)
DIMMED = $(foreach r,common/contract common/core common/run methods,$(call sources,$(r)))
problem_sources = $(shell sed -n 's/^PROBLEM$(paren)\([a-z_0-9]*\), $(1).*/problems\/\1.c/p' problems/problems.def)
PROBLEMS_1 = $(call problem_sources,1)
PROBLEMS_2 = $(call problem_sources,[01]$(comma) 1)
PROBLEMS_3 = $(call problem_sources,[01]$(comma) [01]$(comma) 1)
FEM_2      = $(filter-out fem_ref/mesh_space.c,$(call sources,fem_ref))
FEM_3      = $(filter-out fem_ref/mesh.c,$(call sources,fem_ref))

objects = $(patsubst %.c,$(BUILD)/d$(1)/%.o,$(DIMMED) $(PROBLEMS_$(1)) $(FEM_$(1)))
FREE_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(FREE))
BASE_OBJECTS = $(filter $(BUILD)/common/base/%,$(FREE_OBJECTS))

.PHONY: help all deps deps-extra test quick figures bench rank san lint mutants faults install uninstall builds repeat memcheck \
  coverage objects fuzz fuzzers clean force
.DELETE_ON_ERROR:
.SECONDARY:

all: $(BUILD)/mpmlab ## the program, build/mpmlab

# The targets that carry a text after two #, in the order of this file.
help:
	@sed -nE 's/^([a-z -]+):[^#]*## (.*)/\1|\2/p' $(firstword $(MAKEFILE_LIST)) | \
	  while IFS='|' read -r name text; do printf '%-12s %s\n' "$$name" "$$text"; done

# $(call sum,ROOM ...): a shell command that prints the checksum of all files of these rooms but .md, names included.
sum = for room in $(1); do \
  find $$room -type f | grep -q . || { echo "$$room: an empty room" >&2; exit 1; }; done; \
  find $(1) -type f ! -name '*.md' | LC_ALL=C sort | xargs cksum | cksum | cut -d' ' -f1

# What this build is, for --version, the journals and the sidecars; rewritten only when it changes. Rows depend on
# FACT_SOURCES, which is part of a journal's key; FACT_STUDIES is what judges and draws them.
$(BUILD)/facts.h: force
	@mkdir -p $(BUILD)
	@sources=$$($(call sum,$(ROW_ROOMS))) && studies=$$($(call sum,$(STUDY_ROOMS))) && \
	printf '#define FACT_%s "%s"\n' VERSION "$$(git describe --always --dirty --tags 2>/dev/null | sed 's/^/$(VERSION), commit /' | grep . || echo $(VERSION))" \
	  COMPILER "$$($(CC) --version | head -n 1)" FLAGS "$(strip $(OPT) $(OMP) $(SAN))" \
	  SOURCES "$$sources" STUDIES "$$studies" > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

$(BUILD)/mpmlab: $(FREE_OBJECTS) $(DIMS:%=$(BUILD)/d%/engine.o)
	$(LINK)

# One short line per file; V=1 shows the commands. Every object carries a list of its headers (.d).
SHOW    = $(if $(V),,@$(if $(findstring s,$(firstword -$(MAKEFLAGS))),,echo "$(1) $(@:$(BUILD)/%=%)";))
LINK    = $(call SHOW,LD) mkdir -p $(@D) && $(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)
COMPILE = $(call SHOW,CC) mkdir -p $(@D) && $(CC) $(CFLAGS) -MMD -MP -c -o $@ $<
DEPENDS = $(shell find $(BUILD) -name '*.d' 2>/dev/null)

$(BUILD)/studies/%.o: studies/%.c Makefile | $(BUILD)/facts.h
	$(COMPILE) -I$(BUILD)

$(BUILD)/common/base/%.o: common/base/%.c Makefile
	$(COMPILE)

# One object per dimension; all but its Engine is hidden, so that the dimensions can share names.
define dimension
$(BUILD)/d$(1)/%.o: %.c Makefile
	$$(COMPILE) -DDIM=$(1)
$(BUILD)/d$(1)/engine.o: $(call objects,$(1))
	$$(call SHOW,LD)ld -r -o $$@.all $$^
	@objcopy --keep-global-symbol=engine_$(1)d $$@.all $$@
	@rm $$@.all
endef
$(foreach d,1 2 3,$(eval $(call dimension,$(d))))

# make figures QUICK=--quick: all figures from short runs, in minutes, without verdicts
QUICK =

figures: ## all studies, claims and build/out/index.html (11 minutes on 2 cores; with QUICK=--quick 2)
	@$(MAKE) --no-print-directory -j$(JOBS) all
	$(BUILD)/mpmlab study all $(QUICK) --jobs $(JOBS)
	$(if $(QUICK),,$(BUILD)/mpmlab claims && bash tests/tools/reach_table.sh $(BUILD)/out >$(BUILD)/out/reach.md)

# The tests write below build/ only; CUnit's summary comes last.
UNIT_TESTS  = $(patsubst %,$(BUILD)/tests/%,claims core_3d core_2d tools core_1d scenes wls fem) # longest first
FUZZ_OBJECTS = $(patsubst %,$(BUILD)/tests/fuzz/%.o,fuzz_run fuzz_sweep fuzz_files fuzz_tools)
CORE_DIMS   = 1 2 3
TEXTBOOK    = $(patsubst %,textbook/%,textbook textbook_cells textbook_filter textbook_make)
# $(call tests_of,PROGRAM): its files in tests/tests.def. Every test file must have a line there.
tests_of = $(or $(shell sed -nE 's/^([a-z_0-9\/]+):(.*) $(1)( .*)?$$/\1/p' tests/tests.def),$(error tests/tests.def: no test of $(1)))
UNLISTED = $(filter-out $(shell sed -nE 's/^([a-z_0-9\/]+):.*/tests\/\1.c/p' tests/tests.def),$(wildcard tests/*/test_*.c))
TEST_OBJECTS = $(filter-out $(BUILD)/studies/cli/main.o, $(FREE_OBJECTS)) $(DIMS:%=$(BUILD)/d%/engine.o)

$(BUILD)/tests/%.o: tests/%.c Makefile
	$(COMPILE)

$(BUILD)/tests/fuzz/test_fuzz_corpus.o: CFLAGS += -DFOUND='"$(CURDIR)/tests/fuzz/found"'
$(BUILD)/d2/tests/core/test_peers.o: CFLAGS += -DPEERS='"$(CURDIR)/tests/data/peers"'
$(DIMS:%=$(BUILD)/d%/tests/problems/test_scan.o): CFLAGS += -DSCANS='"$(CURDIR)/tests/data/scans"'
$(BUILD)/tests/tools: $(patsubst %,$(BUILD)/tests/%.o,$(call tests_of,tools) check) $(FUZZ_OBJECTS) $(TEST_OBJECTS)
	$(LINK) -lcunit
$(BUILD)/tests/claims: $(patsubst %,$(BUILD)/tests/%.o,$(call tests_of,claims) studies/trial studies/trial_files check) $(TEST_OBJECTS)
	$(LINK) -lcunit

# Tests of one dimension see its objects before their names are hidden.
define dimension_tests
$(BUILD)/tests/$(1): $(patsubst %,$(BUILD)/d$(2)/tests/%.o,$(call tests_of,$(1)) fixture $(TEXTBOOK)) \
  $(BUILD)/tests/check.o $(BASE_OBJECTS) $(call objects,$(2))
	$(if $(UNLISTED),$$(error not in tests/tests.def: $(UNLISTED)))$$(LINK) -lcunit
endef
$(foreach d,$(CORE_DIMS),$(eval $(call dimension_tests,core_$(d)d,$(d))))
$(foreach p,fem wls scenes,$(eval $(call dimension_tests,$(p),2)))

# CUnit programs and scripts run together, the longest first, one more than JOBS, since cluster.sh and page.sh mostly wait.
# A script's output is printed when it ends, that of the programs after all, so that CUnit's summaries come last.
AT_ONCE     = @$(MAKE) --no-print-directory --output-sync=target -j$(shell expr $(JOBS) + 1)
QUICK_TESTS = cli wrong_inputs sweep
SHELL_TESTS = cluster page example faults resume $(QUICK_TESTS) install
RUN_SHELL   = $(SHELL_TESTS:%=run-%)
RUN_UNIT    = $(UNIT_TESTS:$(BUILD)/tests/%=run-%)
SUMMARIES   = @cat $(UNIT_TESTS:$(BUILD)/tests/%=$(BUILD)/tests/run/%/log)

test: ## every test (2 minutes on 2 cores)
	@$(MAKE) --no-print-directory -j$(JOBS) all $(UNIT_TESTS)
	$(AT_ONCE) run-cluster run-page $(RUN_UNIT) $(RUN_SHELL)
	bash tests/tools/reach_table.sh --check README.md $(BUILD)/out
	$(SUMMARIES)

# The program's own tests, for sanitizers. Of the program `claims`, which judges every page many times, only one test.
quick: ## the tests of the program itself, without installation and examples
	@$(MAKE) --no-print-directory -j$(JOBS) all $(UNIT_TESTS)
	$(AT_ONCE) ONLY_claims='claims on whole' $(RUN_UNIT) $(QUICK_TESTS:%=run-%)
	$(SUMMARIES)

.PHONY: $(RUN_SHELL) $(RUN_UNIT)
$(RUN_SHELL): run-%:
	bash $(wildcard tests/*/$*.sh) $(if $(filter example,$*),$(BUILD)/example,$(if $(filter install,$*),$(BUILD),$(BUILD)/mpmlab) $(BUILD)/tests)
$(RUN_UNIT): run-%:
	@mkdir -p $(BUILD)/tests/run/$* && cd $(BUILD)/tests/run/$* && \
	  $(if $(ONLY_$*),ONLY='$(ONLY_$*)') OMP_WAIT_POLICY=passive $(CURDIR)/$(BUILD)/tests/$* >log 2>&1 || { cat log; exit 1; }

# Speed (figure T-3): an AVX2 build beside the own one, whose instructions valgrind can count.
bench: all $(BUILD)/tests/bench $(BUILD)/tests/palette ## speed: figure T-3, and instructions if valgrind is installed (10 minutes)
	@$(MAKE) -s BUILD=$(BUILD)/avx2 ARCH=-march=x86-64-v3 all
	BUILD=$(BUILD) bash tests/tools/bench.sh

$(BUILD)/tests/bench: $(patsubst %,$(BUILD)/d2/tests/%.o,tools/bench tools/bare_loops $(TEXTBOOK)) \
  $(BASE_OBJECTS) $(call objects,2)
	$(LINK)

$(BUILD)/tests/palette: $(BUILD)/d2/tests/tools/palette.o $(TEST_OBJECTS)
	$(LINK)

# Seeded faults in all parts of the program, a line each in tests/tools/mutants.list: the tests must see each.
mutants: ## seeded faults, each of which a test must see (12 minutes)
	JOBS=$(JOBS) bash tests/tools/mutants.sh $(BUILD)/mutants

# Does a second run of the speed-against-error study rank the methods as the first did?
rank: all ## does a second run rank the methods by speed as the first did?
	bash tests/tools/rank.sh $(BUILD)/mpmlab $(BUILD)/tests

lint: ## conventions, warnings of gcc and clang, public names (10 minutes)
	BUILD=$(BUILD)/lint bash tests/tools/lint.sh

# The same tests under the address and undefined-behaviour sanitizers, which end a program at what they find.
san: ## fuzzing for seconds, then the tests under sanitizers (20 minutes)
	$(MAKE) fuzz SECONDS=2
	$(MAKE) BUILD=$(BUILD)/san ARCH= OPT='-O1 -fno-omit-frame-pointer' \
	  SAN='-fsanitize=address,undefined -fno-sanitize-recover=undefined' quick

# Long checks; each ends in a line of counts.
builds repeat memcheck coverage: ## portable builds; results twice; valgrind; lines that tests reach (up to hours)
	bash tests/tools/$@.sh $(BUILD)/$@

# All faults, a hundred kills among them (minutes).
faults: all ## a full and a read-only disk, a hundred kills (7 minutes)
	bash tests/cli/faults.sh $(BUILD)/mpmlab $(BUILD)/tests 100 long

# Bytes that break a property of what reads input: SECONDS for each; corpora stay in build/fuzz.
FUZZERS = run set case journal table append sweep
SECONDS = 60

fuzz: ## broken inputs, SECONDS for each reader
	SECONDS_EACH=$(SECONDS) bash tests/tools/fuzz.sh $(BUILD)/fuzz $(FUZZERS)

# make fuzzers BUILD=... CC=clang SAN=...: the programs alone (fuzz.sh asks for them)
fuzzers: all $(FUZZERS:%=$(BUILD)/tests/fuzz_%)

$(BUILD)/tests/fuzz/fuzz_main_%.o: tests/fuzz/fuzz_main.c Makefile
	$(COMPILE) -DFUZZ=fuzz_$*

$(FUZZERS:%=$(BUILD)/tests/fuzz_%): $(BUILD)/tests/fuzz_%: $(BUILD)/tests/fuzz/fuzz_main_%.o $(FUZZ_OBJECTS) $(TEST_OBJECTS)
	$(LINK) -fsanitize=fuzzer

# Every source compiled, for lint.
objects: all $(UNIT_TESTS) $(BUILD)/tests/bench $(BUILD)/tests/palette $(FUZZERS:%=$(BUILD)/tests/fuzz/fuzz_main_%.o) ## every source compiled, for lint

# The program looks for its plots beside itself, in ../share.
PREFIX  = /usr/local
INSTALL = $(DESTDIR)$(PREFIX)
SHARED  = $(INSTALL)/share/mpmlab
MANUALS = $(INSTALL)/share/man/man1
WORDS   = $(INSTALL)/share/bash-completion/completions

install: all ## to PREFIX (/usr/local)
	install -D -m 755 $(BUILD)/mpmlab "$(INSTALL)/bin/mpmlab"
	install -d "$(SHARED)/plots" "$(MANUALS)" "$(WORDS)"
	for room in . w07 w11 own hard; do install -d "$(SHARED)/plots/$$room" && \
	  install -m 644 plots/$$room/*.gp "$(SHARED)/plots/$$room" || exit 1; done
	install -m 644 plots/page.html "$(SHARED)/plots"
	$(BUILD)/mpmlab --man > "$(MANUALS)/mpmlab.1"
	$(BUILD)/mpmlab --completion > "$(WORDS)/mpmlab"

uninstall: ## the reverse
	rm -f "$(INSTALL)/bin/mpmlab" "$(MANUALS)/mpmlab.1" "$(WORDS)/mpmlab"
	rm -rf "$(SHARED)"

deps: ## packages that the program and its tests need (apt)
	@bash tests/tools/deps.sh gcc make binutils libc6-dev libgsl-dev libjansson-dev zlib1g-dev libnetpbm-dev \
	  libcunit1-dev gnuplot-nox fonts-dejavu-core man-db $(if $(findstring clang,$(CC)),clang libomp-dev)

deps-extra: ## packages for lint, san, fuzz, memcheck
	@bash tests/tools/deps.sh -o clang clang-tidy clang-format cppcheck valgrind shellcheck libclang-rt-dev \
	  libomp-dev python3-vtk9 python3-numpy chromium chromium-driver curl parallel slurm-wlm munge ccache

clean: ## remove the build folder
	rm -rf $(BUILD)

-include $(DEPENDS)
$(DEPENDS): ; # written by the compiler; never made from sources of their own

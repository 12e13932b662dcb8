# mpmlab: `make deps figures` runs everything, `make deps test` checks everything.
#   make CC=clang          another compiler          make ARCH=              portable build
#   make OMP=              no threads                make BUILD=build/x      another folder

CC     = gcc
BUILD  = build
ARCH   = -march=native
OMP    = -fopenmp
JOBS   = $(shell nproc)
DIMS   = 1 2
SAN    =

OPT    = -O3 $(ARCH) -ffp-contract=fast -fno-math-errno -fno-trapping-math
WARN   = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wvla -Wstrict-prototypes \
         -Wmissing-prototypes -Wno-psabi -Werror $(if $(OMP),,-Wno-unknown-pragmas)
CFLAGS = -std=gnu11 -g $(OPT) $(OMP) $(SAN) $(WARN)
LDLIBS = -lgsl -lgslcblas -ljansson -lz -lm

comma  = ,
paren  = (
FREE   = $(patsubst %,common/%.c,fault file info row spec table vtk_file) \
         methods/wls_squares.c $(wildcard studies/*.c)
DIMMED = $(filter-out $(FREE), $(wildcard common/*.c)) $(wildcard methods/*.c)
problem_sources = $(shell sed -n 's/^PROBLEM$(paren)\([a-z_0-9]*\), $(1).*/problems\/\1.c/p' problems/problems.def)
PROBLEMS_1 = $(call problem_sources,1)
PROBLEMS_2 = $(call problem_sources,[01]$(comma) 1)
PROBLEMS_3 = $(call problem_sources,[01]$(comma) [01]$(comma) 1)
FEM_2      = $(wildcard fem_ref/*.c)
HEADERS    = $(wildcard */*.h) $(wildcard */*.def)

objects = $(patsubst %.c,$(BUILD)/d$(1)/%.o,$(DIMMED) $(PROBLEMS_$(1)) $(FEM_$(1)))
FREE_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(FREE))

.PHONY: all deps deps-extra test quick figures bench rank san lint mutants faults install uninstall builds repeat memcheck \
  coverage fuzz fuzzers clean force
.DELETE_ON_ERROR:
.SECONDARY:

all: $(BUILD)/mpmlab

# What this build is, for --version, the journals and the sidecars; rewritten only when it changes.
$(BUILD)/facts.h: force
	@mkdir -p $(BUILD)
	@printf '#define FACT_VERSION "%s"\n#define FACT_COMPILER "%s"\n#define FACT_FLAGS "%s"\n#define FACT_SOURCES "%s"\n' \
	  "$$(git describe --always --dirty --tags 2>/dev/null || echo unknown)" "$$($(CC) --version | head -n 1)" \
	  "$(strip $(OPT) $(OMP) $(SAN))" \
	  "$$(cat $(sort $(wildcard common/* methods/* problems/* fem_ref/*)) | cksum | cut -d' ' -f1)" > $@.new
	@cmp -s $@.new $@ && rm $@.new || mv $@.new $@

$(BUILD)/mpmlab: $(FREE_OBJECTS) $(DIMS:%=$(BUILD)/d%/engine.o)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/studies/%.o: studies/%.c $(HEADERS) $(BUILD)/facts.h Makefile
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -I$(BUILD) -c -o $@ $<

$(BUILD)/common/%.o: common/%.c $(HEADERS) Makefile
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -c -o $@ $<

$(BUILD)/methods/%.o: methods/%.c $(HEADERS) Makefile
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -c -o $@ $<

# One object a dimension; all but its Engine is hidden, so that the dimensions can share names.
define dimension
$(BUILD)/d$(1)/%.o: %.c $(HEADERS) Makefile
	@mkdir -p $$(@D)
	$(CC) $(CFLAGS) -DDIM=$(1) -c -o $$@ $$<
$(BUILD)/d$(1)/engine.o: $(call objects,$(1))
	ld -r -o $$@.all $$^
	objcopy --keep-global-symbol=engine_$(1)d $$@.all $$@
	rm $$@.all
endef
$(foreach d,1 2 3,$(eval $(call dimension,$(d))))

figures:
	@$(MAKE) --no-print-directory -j$(JOBS) all
	$(BUILD)/mpmlab study all --jobs $(JOBS)
	$(BUILD)/mpmlab claims

# The tests write below build/ only; CUnit's summary comes last.
CLI_TEST    = bash tests/cli.sh $(BUILD)/mpmlab $(BUILD)/tests
SWEEP_TEST  = bash tests/sweep.sh $(BUILD)/mpmlab $(BUILD)/tests
UNIT_TESTS  = $(BUILD)/tests/tools $(CORE_DIMS:%=$(BUILD)/tests/core_%d) $(BUILD)/tests/fem \
              $(BUILD)/tests/wls $(BUILD)/tests/scenes
WRONG_TEST  = bash tests/wrong_inputs.sh $(BUILD)/mpmlab $(BUILD)/tests
FAULT_TEST  = bash tests/faults.sh $(BUILD)/mpmlab $(BUILD)/tests
FUZZ_OBJECTS = $(patsubst %,$(BUILD)/tests/%.o,fuzz_run fuzz_sweep fuzz_files fuzz_tools)
CORE_DIMS   = 1 2 3
CORE_3      = main_3d rig twin twin_filter twin_make \
              $(patsubst %,test_%,twin shapes material exact remedies)
CORE_1      = $(filter-out main_3d,$(CORE_3)) main_dim test_contract test_wls_symbols test_column \
              $(patsubst %,test_%,invariants hard order dynamics spots rules status methods)
CORE_2      = $(CORE_1)
FEM_TESTS   = test_fem test_fem_scenes test_mesh test_ring
WLS_TESTS   = test_wls test_wls_runs test_wls_hard test_ge_wls test_axis_mms test_vortex
SCENE_TESTS = test_disk_plate test_snapshot
TEST_OBJECTS = $(filter-out $(BUILD)/studies/main.o, $(FREE_OBJECTS)) $(DIMS:%=$(BUILD)/d%/engine.o)

$(BUILD)/tests/%.o: tests/%.c $(HEADERS) Makefile
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -c -o $@ $<

$(BUILD)/tests/test_found.o: CFLAGS += -DFOUND='"$(CURDIR)/tests/found"'
$(BUILD)/tests/tools: $(patsubst %,$(BUILD)/tests/%.o,test_tools test_files test_study test_found check) \
  $(FUZZ_OBJECTS) $(TEST_OBJECTS)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS) -lcunit

# Tests of one dimension see its objects before their names are hidden.
define dimension_tests
$(BUILD)/tests/core_$(1)d: $(CORE_$(1):%=$(BUILD)/d$(1)/tests/%.o) $(BUILD)/tests/check.o \
  $(filter $(BUILD)/common/%,$(FREE_OBJECTS)) $(call objects,$(1))
	$(CC) $(CFLAGS) -o $$@ $$^ $(LDLIBS) -lcunit
endef
$(foreach d,$(CORE_DIMS),$(eval $(call dimension_tests,$(d))))

$(BUILD)/tests/fem: $(FEM_TESTS:%=$(BUILD)/d2/tests/%.o)
$(BUILD)/tests/wls: $(WLS_TESTS:%=$(BUILD)/d2/tests/%.o)
$(BUILD)/tests/scenes: $(SCENE_TESTS:%=$(BUILD)/d2/tests/%.o)
$(BUILD)/tests/fem $(BUILD)/tests/wls $(BUILD)/tests/scenes: $(BUILD)/tests/check.o \
  $(filter $(BUILD)/common/%,$(FREE_OBJECTS)) $(call objects,2)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS) -lcunit

RUN_UNITS = for t in $(UNIT_TESTS); do \
  (cd $(BUILD)/tests && OMP_WAIT_POLICY=passive $(CURDIR)/$$t) || exit 1; done

test:
	@$(MAKE) --no-print-directory -j$(JOBS) all $(UNIT_TESTS)
	$(CLI_TEST)
	$(SWEEP_TEST)
	bash tests/example.sh $(BUILD)/example
	$(WRONG_TEST)
	$(FAULT_TEST)
	bash tests/install.sh $(BUILD) $(BUILD)/tests
	bash tests/cluster.sh $(BUILD)/mpmlab $(BUILD)/tests
	bash tests/page.sh $(BUILD)/mpmlab $(BUILD)/tests
	@$(RUN_UNITS)

# Those of the program's own code, for sanitizers.
quick:
	@$(MAKE) --no-print-directory -j$(JOBS) all $(UNIT_TESTS)
	$(CLI_TEST)
	$(SWEEP_TEST)
	$(WRONG_TEST)
	@$(RUN_UNITS)

# Speed (figure T-3): an AVX2 build beside the own one, whose instructions valgrind can count.
bench: all $(BUILD)/tests/bench
	@$(MAKE) -s BUILD=$(BUILD)/avx2 ARCH=-march=x86-64-v3 all
	BUILD=$(BUILD) bash tests/bench.sh

$(BUILD)/tests/bench: $(patsubst %,$(BUILD)/d2/tests/%.o,bench twin twin_filter twin_make) \
  $(filter $(BUILD)/common/%,$(FREE_OBJECTS)) $(call objects,2)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

# Twenty-odd seeded faults in the mathematics: the tests must see each.
mutants:
	JOBS=$(JOBS) bash tests/mutants.sh $(BUILD)/mutants

# Does a second run of the speed-against-error study rank the methods as the first did?
rank: all
	bash tests/rank.sh $(BUILD)/mpmlab $(BUILD)/tests

lint:
	BUILD=$(BUILD)/lint bash tests/lint.sh

# The same tests under the address and undefined-behaviour sanitizers.
san:
	$(MAKE) fuzz SECONDS=2
	$(MAKE) BUILD=$(BUILD)/san ARCH= OPT='-O1 -fno-omit-frame-pointer' \
	  SAN=-fsanitize=address,undefined quick

# What takes minutes, each ending in a line of counts.
builds repeat memcheck coverage:
	bash tests/$@.sh $(BUILD)/$@

# All faults, a hundred kills among them (minutes).
faults: all
	$(FAULT_TEST) 100 long

# Bytes that break a property of what reads input: SECONDS for each; corpora stay in build/fuzz.
FUZZERS = run set case journal table append sweep
SECONDS = 60

fuzz:
	SECONDS_EACH=$(SECONDS) bash tests/fuzz.sh $(BUILD)/fuzz $(FUZZERS)

# make fuzzers BUILD=... CC=clang SAN=...: the programs alone (fuzz.sh asks for them)
fuzzers: all $(FUZZERS:%=$(BUILD)/tests/fuzz_%)

$(BUILD)/tests/fuzz_main_%.o: tests/fuzz_main.c $(HEADERS) Makefile
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -DFUZZ=fuzz_$* -c -o $@ $<

$(FUZZERS:%=$(BUILD)/tests/fuzz_%): $(BUILD)/tests/fuzz_%: $(BUILD)/tests/fuzz_main_%.o $(FUZZ_OBJECTS) $(TEST_OBJECTS)
	$(CC) $(CFLAGS) -fsanitize=fuzzer -o $@ $^ $(LDLIBS)

# The program looks for its plots beside itself, in ../share.
PREFIX  = /usr/local
INSTALL = $(DESTDIR)$(PREFIX)
SHARED  = $(INSTALL)/share/mpmlab
MANUALS = $(INSTALL)/share/man/man1
WORDS   = $(INSTALL)/share/bash-completion/completions

install: all
	install -D -m 755 $(BUILD)/mpmlab "$(INSTALL)/bin/mpmlab"
	install -d "$(SHARED)/plots" "$(MANUALS)" "$(WORDS)"
	install -m 644 plots/*.gp plots/page.html "$(SHARED)/plots"
	$(BUILD)/mpmlab --man > "$(MANUALS)/mpmlab.1"
	$(BUILD)/mpmlab --completion > "$(WORDS)/mpmlab"

uninstall:
	rm -f "$(INSTALL)/bin/mpmlab" "$(MANUALS)/mpmlab.1" "$(WORDS)/mpmlab"
	rm -rf "$(SHARED)"

deps:
	@bash tests/deps.sh gcc make binutils libc6-dev libgsl-dev libjansson-dev zlib1g-dev \
	  libcunit1-dev gnuplot-nox fonts-dejavu-core

deps-extra:
	@bash tests/deps.sh clang clang-tidy clang-format cppcheck valgrind shellcheck libclang-rt-14-dev \
	  libomp-14-dev python3-vtk9 python3-numpy chromium chromium-driver curl parallel slurm-wlm munge

clean:
	rm -rf $(BUILD)

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
FREE   = $(patsubst %,common/%.c,fault file info row spec table) \
         $(wildcard studies/*.c)
DIMMED = $(filter-out $(FREE), $(wildcard common/*.c)) $(wildcard methods/*.c)
problem_sources = $(shell sed -n 's/^PROBLEM$(paren)\([a-z_0-9]*\), $(1).*/problems\/\1.c/p' problems/problems.def)
PROBLEMS_1 = $(call problem_sources,1)
PROBLEMS_2 = $(call problem_sources,[01]$(comma) 1)
PROBLEMS_3 = $(call problem_sources,[01]$(comma) [01]$(comma) 1)
FEM_2      = $(wildcard fem_ref/*.c)
HEADERS    = $(wildcard */*.h) $(wildcard */*.def)

objects = $(patsubst %.c,$(BUILD)/d$(1)/%.o,$(DIMMED) $(PROBLEMS_$(1)) $(FEM_$(1)))
FREE_OBJECTS = $(patsubst %.c,$(BUILD)/%.o,$(FREE))

.PHONY: all deps deps-extra test figures bench san lint mutants fuzz clean force
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
UNIT_TESTS  = $(BUILD)/tests/tools $(CORE_DIMS:%=$(BUILD)/tests/core_%d) $(BUILD)/tests/fem
CORE_DIMS   = 1 2 3
CORE_3      = main_3d rig twin twin_make $(patsubst %,test_%,twin shapes material exact)
CORE_1      = $(filter-out main_3d,$(CORE_3)) main_dim test_contract \
              $(patsubst %,test_%,invariants order dynamics spots rules status methods)
CORE_2      = $(CORE_1)
FEM_TESTS   = test_fem test_fem_scenes test_mesh test_ring
TEST_OBJECTS = $(filter-out $(BUILD)/studies/main.o, $(FREE_OBJECTS)) $(DIMS:%=$(BUILD)/d%/engine.o)

$(BUILD)/tests/%.o: tests/%.c $(HEADERS) Makefile
	@mkdir -p $(@D)
	$(CC) $(CFLAGS) -c -o $@ $<

$(BUILD)/tests/tools: $(patsubst %,$(BUILD)/tests/%.o,test_tools test_files test_study check) $(TEST_OBJECTS)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS) -lcunit

# Tests of one dimension see its objects before their names are hidden.
define dimension_tests
$(BUILD)/tests/core_$(1)d: $(CORE_$(1):%=$(BUILD)/d$(1)/tests/%.o) $(BUILD)/tests/check.o \
  $(filter $(BUILD)/common/%,$(FREE_OBJECTS)) $(call objects,$(1))
	$(CC) $(CFLAGS) -o $$@ $$^ $(LDLIBS) -lcunit
endef
$(foreach d,$(CORE_DIMS),$(eval $(call dimension_tests,$(d))))

$(BUILD)/tests/fem: $(FEM_TESTS:%=$(BUILD)/d2/tests/%.o) $(BUILD)/tests/check.o \
  $(filter $(BUILD)/common/%,$(FREE_OBJECTS)) $(call objects,2)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS) -lcunit

test:
	@$(MAKE) --no-print-directory -j$(JOBS) all $(UNIT_TESTS)
	$(CLI_TEST)
	bash tests/example.sh $(BUILD)/example
	@for t in $(UNIT_TESTS); do (cd $(BUILD)/tests && OMP_WAIT_POLICY=passive $(CURDIR)/$$t) || exit 1; done

# Speed (figure T-3): an AVX2 build beside the own one, whose instructions valgrind can count.
bench: all $(BUILD)/tests/bench
	@$(MAKE) -s BUILD=$(BUILD)/avx2 ARCH=-march=x86-64-v3 all
	BUILD=$(BUILD) bash tests/bench.sh

$(BUILD)/tests/bench: $(patsubst %,$(BUILD)/d2/tests/%.o,bench twin twin_make) \
  $(filter $(BUILD)/common/%,$(FREE_OBJECTS)) $(call objects,2)
	$(CC) $(CFLAGS) -o $@ $^ $(LDLIBS)

# Twenty-odd seeded faults in the mathematics: the tests must see each.
mutants:
	JOBS=$(JOBS) bash tests/mutants.sh $(BUILD)/mutants

lint:
	BUILD=$(BUILD)/lint bash tests/lint.sh

# The same tests under the address and undefined-behaviour sanitizers.
san:
	$(MAKE) BUILD=$(BUILD)/san ARCH= OPT='-O1 -fno-omit-frame-pointer' \
	  SAN=-fsanitize=address,undefined test

deps:
	@bash tests/deps.sh gcc make binutils libc6-dev libgsl-dev libjansson-dev zlib1g-dev \
	  libcunit1-dev gnuplot-nox fonts-dejavu-core

deps-extra:
	@bash tests/deps.sh clang clang-tidy clang-format cppcheck valgrind libclang-rt-14-dev libomp-14-dev

clean:
	rm -rf $(BUILD)

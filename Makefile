# Winnow. `make run` shows a fluidized bed, `make check` proves the code, `make help` lists the rest.
CC       = gcc
WARN     = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wmissing-prototypes -Wno-missing-field-initializers $(if $(findstring clang,$(CC)),-Wno-pass-failed) $(WERROR)
WERROR   = -Werror
STD      = -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -fopenmp -Isrc
TUNE     = -march=native
# Beds that a run settles are kept here, not in the user's own cache.
export XDG_CACHE_HOME := $(abspath $B)/cache
MATH     = -fno-math-errno -fno-trapping-math
FAST     = -O3 $(TUNE) $(MATH) $(WIDE)
WIDE     = $(if $(filter x86_64,$(shell uname -m)),-mprefer-vector-width=512)
# What the checks left out would find, the address sanitizer finds at the access.
SANITIZE = -O2 -g1 $(TUNE) $(MATH) -fsanitize=address,undefined \
           -fno-sanitize=null,object-size,pointer-overflow -fno-sanitize-recover=all -fno-omit-frame-pointer
OPT      = $(FAST)
B        = build
LIGHTLY  = -O1
# Debian has HDF5 in a folder of its own, which pkg-config knows.
HDF5    := $(shell pkg-config --libs hdf5 2>/dev/null || echo -lhdf5)
LIBS     = -lconfig -lgsl -lgslcblas $(HDF5) -lz -lm
# Test programs are many, and gold links them in a third of the time.
LINK    := $(if $(shell command -v ld.gold),-fuse-ld=gold)

# Built into build/winnow-mpi only: see `distributed` below.
RANKS := src/distributed/ranks
SRC   := $(filter-out $(RANKS)/%,$(wildcard src/commands.c src/run_command.c src/*/*.c src/*/*/*.c))
OBJ   := $(SRC:%.c=$B/%.o) $B/src/tell/equation_index_rows.o $B/src/output/pictures/programs.o $B/src/report/page_parts.o
TESTS := $(patsubst tests/%.c,$B/tests/%,$(wildcard tests/test_*.c))
PATCHES := $(wildcard chapters/solutions/*.patch)
STEPS := $(patsubst chapters/steps/%.c,$B/steps/%,$(wildcard chapters/steps/*.c))
BENCH := $(patsubst tests/%.c,$B/tests/%,$(wildcard tests/bench/*.c))
FUZZ_SECONDS = 60
FUZZ_SEED    = 1
# All cores, unless make was told how many.
CORES  = $(if $(findstring -j,$(MAKEFLAGS)),,-j$(shell nproc))

# A short run waits for the disk thirty times, longer than it computes. Where memory
# has a folder with 2 GB left, from which programs may be run, a check writes there.
IN_MEMORY = $(shell grep -qs ' /dev/shm .*noexec' /proc/mounts || df -Pk /dev/shm 2>/dev/null | \
            awk '$$4 > 2e6 && $$6 == "/dev/shm" { print "TMPDIR=/dev/shm" }')

all: $B/winnow

run: ## install what is missing, build, run the Mueller fluidized bed (a minute or two)
	sh .ci/install run
	$(MAKE) $(CORES) $B/winnow WERROR=
	$B/winnow run cases/mueller-bed.cfg -o out/mueller-bed -s output.end=0.8

check: ## install what is missing, build, run every test
	sh .ci/install check
	$(MAKE) $(CORES) $B/winnow
	OMP_NUM_THREADS=1 $(IN_MEMORY) $(MAKE) $(CORES) -k --output-sync checks

check-slow: ## what check has no time for: every test under sanitizers, every command of the book (three quarters of an hour)
	sh .ci/install check
	OMP_NUM_THREADS=1 $(MAKE) $(CORES) -k --output-sync slow
slow: sanitized solutions pages commands-slow faults-slow kills-slow pairs-slow parcels-slow style-slow \
      cylinder-slow steps-slow bare-slow view-slow
	@echo "all slow checks hold"
cylinder-slow: $B/winnow
	@sh tests/table.sh $B tests/tables/cylinder.txt
bare-slow: $B/winnow
	@sh tests/bare.sh $B
view-slow: $B/winnow
	@sh tests/table.sh $B tests/tables/view.txt
	@sh tests/table.sh $B tests/tables/pages.txt
style-slow: $B/winnow
	@sh tests/style.sh $B long
faults-slow: $B/winnow
	@sh tests/table.sh $B tests/tables/faults.txt long
commands-slow: $B/winnow $B/tests/test_impacts $(STEPS)
	@sh tests/commands.sh $B whole

# Side by side, what takes longest first; with -k all that is wrong is said. (What waits for
# a program begins when all is compiled that waits for none: so the program is there before.)
checks: results pairs solutions-today facts style faults parcels kills steps-check cli free study \
        vtk tools commands text
	@echo "all checks hold"
# What this shows only sanitizers can see: check-slow runs it.
NEEDS_SANITIZERS = $B/tests/test_crafted.facts
facts: $(filter-out $(NEEDS_SANITIZERS),$(TESTS:=.facts))
	@echo "$(words $^) programs: $$(cat $^ | wc -l) facts hold"
# Without a process for each fact, which doubles what a small one takes.
SANITIZED = CK_FORK=no $(MAKE) facts NEEDS_SANITIZERS= B=$B/san OPT="$(SANITIZE)" LIGHTLY=-O0 WERROR=
sanitized:
	@+$(SANITIZED) TESTS="$(patsubst $B/%,$B/san/%,$(TESTS))"
	@+$(MAKE) replay B=$B/san OPT="$(SANITIZE)" LIGHTLY=-O0 WERROR=
style: $B/winnow
	@sh tests/style.sh $B
cli: $B/winnow
	@sh tests/table.sh $B tests/tables/cli.txt
	@sh tests/table.sh $B tests/tables/advice.txt
	@sh tests/table.sh $B tests/tables/report.txt
kills: $B/winnow
	@sh tests/table.sh $B tests/tables/resume.txt
	@sh tests/kills.sh $B/winnow
kills-slow: $B/winnow
	@sh tests/kills.sh $B/winnow 40
free: $B/winnow
	@LIBS="$(LIBS)" sh tests/free.sh $B
parcels: $B/winnow
	@sh tests/table.sh $B tests/tables/parcels.txt
	@sh tests/table.sh $B tests/tables/stress.txt
	@sh tests/table.sh $B tests/tables/clumps.txt
parcels-slow: $B/winnow
	@sh tests/table.sh $B tests/tables/parcels.txt long
	@sh tests/table.sh $B tests/tables/clumps.txt long
faults: $B/winnow
	@sh tests/table.sh $B tests/tables/faults.txt
study: $B/winnow
	@sh tests/table.sh $B tests/tables/study.txt
pairs: $B/winnow
	@sh tests/pairs.sh $B/winnow
pairs-slow: $B/winnow
	@for seed in 1 2 3; do sh tests/pairs.sh $B/winnow all $$seed || exit; done
vtk: $B/winnow $B/tests/test_vtk
	@sh tests/vtk.sh $B
tools:
	@mkdir -p $B && sh tests/table.sh $B tests/tables/book.txt
	@sh tests/table.sh $B tests/tables/integration.txt
steps-check: $B/winnow $(STEPS) $(STEPS:$B/%=$B/san/%)
	@sh tests/table.sh $B tests/tables/steps.txt
steps-slow: $(STEPS:$B/%=$B/san/%)
	@sh tests/table.sh $B tests/tables/steps.txt long
commands: $B/winnow $(STEPS)
	@sh tests/commands.sh $B
solutions: $(PATCHES:=.tried)
# A tenth a day is built and run, as of the commands of the book; all of them apply.
TODAY = $(shell ls $(PATCHES) | awk -v day=$$(($$(date +%s) / 86400)) 'NR % 10 == day % 10')
solutions-today: $(TODAY:=.tried)
	@for patch in $(PATCHES); do patch -fsp1 --dry-run -i $$patch >/dev/null || { echo "FAILED $$patch"; exit 1; }; done
chapters/solutions/%.tried: tests
	@sh chapters/tools/solutions.sh $B $(@:.tried=)
results text pages: $B/winnow
	@sh chapters/tools/check.sh $B/winnow $@

steps: $(STEPS) ## the thirteen steps to a fluidized bed: build/steps/01-bounce and on
$B/steps/%: chapters/steps/%.c chapters/steps/steps.h
	@$(COMPILE_STEP)
$B/san/steps/%: chapters/steps/%.c chapters/steps/steps.h
	@$(COMPILE_STEP) -g1 -fsanitize=address,undefined -fno-sanitize-recover=all
COMPILE_STEP = mkdir -p $(@D) && echo "compile $<" && \
               $(CC) -std=c11 -O2 -ffp-contract=off $(WARN) -o $@ $< -lm

validate: $B/winnow ## long runs against measurements and papers (hours, then a day; goes on where it was interrupted)
	for script in tests/validate/*.sh; do sh $$script $B/winnow || exit 1; done
	$(MAKE) validate-bed
validate-bed: $B/winnow ## of them the bed of resolved grains, 1.7 million cells (8 hours of a processor for each of 4)
	WIDTH=8 CELLS=12 END=100 sh tests/validate/resolved-bed.sh $B/winnow 4 6 8 11

fuzz: ## broken input for FUZZ_SECONDS (60) from FUZZ_SEED (1), under sanitizers
	$(MAKE) $(CORES) $B/san/tests/fuzz B=$B/san OPT="$(SANITIZE)" WERROR=
	OMP_NUM_THREADS=1 $B/san/tests/fuzz search $(FUZZ_SEED) $(FUZZ_SECONDS) $B/fuzz tests/data/fuzz
# What was once found, and the scenes that the search begins with.
replay: $B/tests/fuzz
	@OMP_NUM_THREADS=1 $< replay tests/data/fuzz/*

PREFIX  = /usr/local
# The manual page and the completion are the program's own words.
$B/winnow.1 $B/winnow.bash: $B/winnow src/manual.awk
	@$B/winnow --help | awk -v version="$$($B/winnow --version)" -f src/manual.awk >$B/winnow.1
	@{ $B/winnow --help; $B/winnow list; } | awk -v shell=bash -f src/manual.awk >$B/winnow.bash
IN = $(DESTDIR)$(PREFIX)
SHARE = $(IN)/share
install: $B/winnow.1 ## program, cases, manual page and completion, into PREFIX (/usr/local)
	@mkdir -p $(IN)/bin $(SHARE)/winnow $(SHARE)/man/man1 $(SHARE)/bash-completion/completions
	cp $B/winnow $(IN)/bin/winnow
	cp -R cases $(SHARE)/winnow
	cp $B/winnow.1 $(SHARE)/man/man1/winnow.1
	cp $B/winnow.bash $(SHARE)/bash-completion/completions/winnow
uninstall: ## what make install put there
	rm -f $(IN)/bin/winnow $(SHARE)/man/man1/winnow.1 $(SHARE)/bash-completion/completions/winnow
	rm -rf $(SHARE)/winnow

weave: ## refresh what the chapters quote from source and results
	sh chapters/tools/weave.sh
	sh chapters/tools/ledger.sh

figures: $B/winnow $B/tests/test_impacts $(BENCH) ## remake slow results and figures, and say what moved (an hour or two)
	@sh chapters/tools/figures.sh $B/winnow

gallery: $B/winnow ## the moving pictures of chapters/gallery.md (ten minutes or less); asks for ParaView, xvfb and webp
	@sh figures/gallery.sh $B

bench: ## ours beside LAMMPS, LIGGGHTS and others, where installed (half an hour)
	sh .ci/install run
	$(MAKE) $(CORES) $(BENCH) WERROR=
	for subject in tests/bench/*.sh; do sh $$subject $B/tests/bench || exit; done
	sh tests/table.sh $B tests/tables/study.txt timed

book: $B/winnow $(STEPS) ## the chapters as pages: build/book/index.html
	sh .ci/install book
	sh tests/table.sh $B tests/tables/steps.txt beside | grep '|' >$B/steps-beside.txt
	sh chapters/tools/book.sh $B/book
	sh chapters/tools/browser.sh $B/book
	sh tests/live.sh $B

pdf: ## the course as one PDF, build/course.pdf; asks for pandoc and Chromium
	sh chapters/tools/book.sh $B/book.plain plain
	sh chapters/tools/pdf.sh $B/book.plain $B/course.pdf

help: ## this list
	@sed -n 's/^\([a-z-]*\):.*## /make \1: /p' Makefile

clean: ## forget everything built
	rm -rf $B

# --- past one machine: LAMMPS moves the particles, PETSc solves; by hand only ---
distributed: ## install what is missing and build build/winnow-mpi, for several machines (mpirun)
	sh .ci/install distributed
	$(MAKE) $(CORES) $B/winnow $B/winnow-mpi WERROR=
check-distributed: ## the tests of build/winnow-mpi, where its packages can be had (three minutes)
	@if sh .ci/install distributed; then $(MAKE) $(CORES) ranks-check WERROR=; \
	else echo "skipped: the packages of build/winnow-mpi cannot be had"; fi
ranks-check: $B/winnow $B/winnow-mpi $B/tests/ranks/compare
	@sh tests/table.sh $B tests/tables/distributed.txt
# Flags of the headers of others, in which ours find much to warn of.
MPI_CFLAGS = $(patsubst -I%,-isystem %,$(filter -I% -D%,$(shell pkg-config --cflags petsc liblammps 2>/dev/null))) -D_DEFAULT_SOURCE
MPI_OBJ := $(patsubst %.c,$B/%.o,$(wildcard $(RANKS)/*.c))
$(MPI_OBJ): CC = mpicc
$(MPI_OBJ): STD += $(filter-out -D_FORTIFY_SOURCE=2,$(MPI_CFLAGS))
$B/winnow-mpi: $(MPI_OBJ) $B/tests/winnow_main.o $B/libwinnow.a
	@echo "link $@"
	@mpicc $(OPT) -fopenmp -o $@ $^ $$(pkg-config --libs petsc liblammps) $(LIBS)
-include $(MPI_OBJ:.o=.d)
$B/tests/ranks/%.o: STD += $(filter-out -D_FORTIFY_SOURCE=2,$(MPI_CFLAGS))
$B/tests/ranks/%: $B/tests/ranks/%.o $B/libwinnow.a
	@mpicc $(OPT) -fopenmp -o $@ $^ $$(pkg-config --libs liblammps) $(LIBS)

tests: $(TESTS)
$B/winnow: $B/src/main.o $B/libwinnow.a
	@echo "link $@"
	@$(CC) $(OPT) -fopenmp -o $@ $^ $(LIBS)
$B/libwinnow.a: $(OBJ)
	@rm -f $@; ar rcs $@ $^
# In one line, not in a page of the compiler's.
$B/packages:
	@sh .ci/install build
	@mkdir -p $(@D)
	@touch $@
$B/%.o: %.c | $B/packages
	@mkdir -p $(@D)
	@echo "compile $<"
	@$(CC) $(STD) $(OPT) $(LIGHT) $(WARN) -MMD -MP -c -o $@ $<
$B/src/output/checkpoint/%.o $B/tests/test_crafted.o: STD += $(shell pkg-config --cflags hdf5 2>/dev/null)
# What takes longer to optimise than to run.
$B/tests/%.o $B/src/case/%.o $B/src/tell/%.o: LIGHT = $(LIGHTLY)
$B/tests/bench/%.o: LIGHT =
# The book's table of equations, for `winnow explain KEY`.
$B/src/tell/equation_index_rows.c: chapters/equations.md chapters/tools/rows.awk
	@mkdir -p $(@D)
	@awk -f chapters/tools/rows.awk $< >$@.new && mv $@.new $@
$B/src/tell/equation_index_rows.o: $B/src/tell/equation_index_rows.c src/tell/check.h
	@$(CC) $(STD) $(OPT) $(LIGHT) $(WARN) -c -o $@ $<
# The programs of the pictures as lines of C; page.gp where they load it.
$B/src/output/pictures/programs.c: $(wildcard src/output/pictures/*.gp) src/output/pictures/picture.h
	@mkdir -p $(@D)
	@( echo '#include "output/pictures/picture.h"'; cd $(<D); for name in bed flow frames study; do \
	    echo "const char *const picture_$$name[] = {"; \
	    sed -e "/^load 'page.gp'/{r page.gp" -e 'd;}' $$name.gp | \
	    sed -e '/SPDX/d' -e 's/[\\"]/\\&/g' -e 's/.*/"&",/'; echo '0};'; \
	done; ) >$@.new && mv $@.new $@
$B/src/output/pictures/programs.o: $B/src/output/pictures/programs.c
	@$(CC) $(STD) $(OPT) $(LIGHT) $(WARN) -c -o $@ $<
# The page of a report and, where they are installed, its libraries.
JS    = /usr/share/javascript
PLOTS = $(JS)/dygraphs/dygraph.min
SCENE = $(JS)/three/three.min.js
PARTS = page_html=src/report/page.html page_css=src/report/page.css page_js=src/report/page.js \
        page_add_js=src/report/page_add.js page_study_js=src/report/page_study.js page_plots_css=$(PLOTS).css page_plots_js=$(PLOTS).js page_scene_js=$(SCENE)
$B/src/report/page_parts.c: $(wildcard src/report/p*.* $(PLOTS).css $(PLOTS).js $(SCENE))
	@mkdir -p $(@D)
	@LC_ALL=C awk -f src/report/parts.awk $(PARTS) >$@.new && mv $@.new $@
$B/src/report/page_parts.o: $B/src/report/page_parts.c
	@$(CC) $(STD) $(OPT) $(LIGHT) $(WARN) -c -o $@ $<
# This test counts allocations.
$B/tests/test_effects: WRAP = -Wl,--wrap=alloc_zeroed,--wrap=alloc_doubles,--wrap=alloc_ints
$B/tests/%: $B/tests/%.o $B/libwinnow.a
	@$(CC) $(OPT) $(LINK) -fopenmp -o $@ $(filter %.o,$^) $(filter %.a,$^) $(WRAP) -lcheck -lsubunit -lrt -lpthread $(LIBS)
# Run anew each time: cases and data may have changed, too.
$B/tests/%.facts: $B/tests/% always
	@sh tests/run.sh $<
# The program within a test: its main by another name.
$B/tests/winnow_main.o: $B/src/main.o
	@mkdir -p $(@D)
	@objcopy --redefine-sym main=winnow_main $< $@
$B/tests/fuzz $B/tests/test_crafted: $B/tests/winnow_main.o

.PHONY: install uninstall distributed check-distributed ranks-check all run check checks check-slow slow facts sanitized style faults kills kills-slow pairs study \
        steps steps-check steps-slow cli free vtk tools commands faults-slow pairs-slow \
        parcels parcels-slow commands-slow style-slow cylinder-slow bare-slow view-slow solutions solutions-today results text pages \
        validate validate-bed bench figures gallery fuzz replay weave book pdf help clean tests always
.SECONDARY:
-include $(OBJ:.o=.d) $(TESTS:=.d) $(BENCH:=.d) $B/tests/fuzz.d $B/src/main.d

# Winnow. `make run` shows a fluidized bed, `make check` proves the code, `make help` lists the rest.
CC       = gcc
WARN     = -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wmissing-prototypes -Werror
STD      = -std=c11 -D_POSIX_C_SOURCE=200809L -ffp-contract=off -fopenmp -Isrc
FAST     = -O3 -march=native -fno-math-errno -fno-trapping-math -mprefer-vector-width=512
SANITIZE = -O1 -g -fsanitize=address,undefined -fno-omit-frame-pointer
OPT      = $(FAST)
B        = build
LIBS     = -lconfig -lgsl -lgslcblas -lz -lm

SRC   := $(filter-out src/main.c,$(wildcard src/*/*.c))
OBJ   := $(SRC:%.c=$B/%.o)
TESTS := $(patsubst tests/%.c,$B/tests/%,$(wildcard tests/test_*.c))

all: $B/winnow

$B/winnow: $B/src/main.o $B/libwinnow.a
	$(CC) $(OPT) -fopenmp -o $@ $^ $(LIBS)
$B/libwinnow.a: $(OBJ)
	@rm -f $@; ar rcs $@ $^
$B/%.o: %.c
	@mkdir -p $(@D)
	$(CC) $(STD) $(OPT) $(WARN) -MMD -c -o $@ $<
$B/tests/%: $B/tests/%.o $B/libwinnow.a
	$(CC) $(OPT) -fopenmp -o $@ $^ -lcheck -lsubunit -lrt -lpthread $(LIBS)

check: $(TESTS)
	@for t in $(TESTS); do $$t || exit 1; done

clean:
	rm -rf build
.PHONY: all check clean
.SECONDARY:
-include $(OBJ:.o=.d) $(B)/src/main.d

/* state.h -- visiting all that decides the next step.
 * Chapter "Nothing is lost".
 *
 * A part of a simulation has one function, xxx_state, that visits each of its
 * numbers and arrays by name and unit. The same visit saves the part and loads
 * it again. A count that an array depends on is visited before the array; the
 * part that loads it then allocates what it needs. */
#ifndef BASE_STATE_H
#define BASE_STATE_H

#include <stddef.h>

enum state_type { STATE_REAL, STATE_WHOLE, STATE_LONG };
enum { STATE_PATH = 256 };

/* One array of a visit: rows of `width` numbers side by side. */
struct state_array {
    const char *path; /* "/fluid/p" */
    const char *unit; /* "Pa"; "-" for a pure number */
    enum state_type type;
    void *values; /* double, int or long */
    long rows;
    int width;
};

struct state {
    int loading; /* [-] 1: the visited arrays receive what was saved */
    int failed;  /* [-] 1, after a message: nothing more is visited */
    /* Saves or loads one array. Non-zero after a message. */
    int (*visit)(void *store, const struct state_array *a);
    void *store;           /* of visit; borrowed */
    char path[STATE_PATH]; /* of the part at hand */
    long most; /* [-] entries that the store has room for; 0: not known */
    const char *file;   /* that has it, for messages; borrowed; NULL: none */
    const char *remedy; /* of a file that is refused; borrowed */
};

/* Parts are nested; the names within one are distinct. */
void state_begin(struct state *s, const char *part);
void state_begin_number(struct state *s, const char *part, int number);
void state_end(struct state *s);

/* Arrays of n rows. NULL, of what the case never needs, is passed over, and so
 * is one of no rows. */
void state_reals(struct state *s, const char *name, const char *unit, double *x,
                 long n, int width);
void state_wholes(struct state *s, const char *name, const char *unit, int *x,
                  long n, int width);

/* A member of each of n structs of `stride` bytes, of which the first has it
 * at x. */
void state_reals_of(struct state *s, const char *name, const char *unit,
                    double *x, size_t stride, long n, int width);
void state_wholes_of(struct state *s, const char *name, const char *unit,
                     int *x, size_t stride, long n, int width);

/* Single numbers. */
void state_real(struct state *s, const char *name, const char *unit, double *x);
void state_whole(struct state *s, const char *name, const char *unit, int *x);
void state_long(struct state *s, const char *name, const char *unit, long *x);

/* n numbers of one unit, saved as one array in this order. */
void state_several(struct state *s, const char *name, const char *unit,
                   double *const x[], int n);

/* A whole number from 0 to `max`; a saved one beyond it, or beyond what the
 * store can have in an array, is refused. */
void state_count(struct state *s, const char *name, int *n, int max);

/* Indices from `least` to `most`; others are refused, for a file need not be
 * ours, whatever its checksum says. */
void state_indices(struct state *s, const char *name, int *x, long n, int least,
                   int most);
void state_indices_of(struct state *s, const char *name, int *x, size_t stride,
                      long n, int least, int most);

/* Refuses what was loaded, after a message, unless it holds. */
void state_demand(struct state *s, int holds, const char *what);

/* Prints what is wrong with what was saved, and the remedy. Returns 1. */
int state_wrong(const struct state *s, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* 1 if none is below the one before, and these are the first and the last. */
int state_rises(const int *x, long n, int first, int last);
#endif

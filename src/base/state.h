/* state.h -- visiting all that decides the next step.
 * Chapter "Nothing is lost".
 *
 * A part of a simulation has one function, xxx_state, that visits each of its
 * numbers and arrays by name and unit. The same visit saves the part and loads
 * it again, so what is saved and what is loaded cannot differ:
 *
 *     void fluid_state(struct fluid *fl, struct state *s)
 *     {
 *         state_begin(s, "fluid");
 *         state_real(s, "t", "s", &fl->t);
 *         state_reals(s, "p", "Pa", fl->p, fl->mesh->n_cells, 1);
 *         state_end(s);
 *     }
 *
 * A count that an array depends on is visited before the array; when it is
 * loaded, the part then allocates what it needs.
 */
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
};

/* Parts are nested; the names within one are distinct. */
void state_begin(struct state *s, const char *part);
void state_begin_number(struct state *s, const char *part, int number);
void state_end(struct state *s);

/* Arrays of n rows. NULL, an array that the case does not need, is passed over
 * (it must be NULL again when the state is loaded), and so is one of no rows.
 */
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

/* A whole number from 0 to `max`; a saved one beyond it is refused. */
void state_count(struct state *s, const char *name, int *n, int max);

#endif

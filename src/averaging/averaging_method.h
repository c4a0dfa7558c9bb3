/* averaging_method.h -- the descriptor of an averaging method.
 * Chapter "Averaging".
 *
 * It is included by the methods (pcm.c, kernel.c, ...) and by the list of them;
 * all other files include averaging.h.
 */
#ifndef AVERAGING_AVERAGING_METHOD_H
#define AVERAGING_AVERAGING_METHOD_H

struct averaging_options;
struct averaging_report;
struct cell_of_particle;

/* One row of the table of methods. state is the result of create, which returns
 * NULL after a message that names the wrong option. h is borrowed. */
struct averaging_method {
    const char *name, *cite, *what;
    const char *function;    /* the function that computes its weights */
    int needs_bandwidth;     /* 1: requires options.bandwidth */
    double reach_b, reach_d; /* [-] radius of the neighbourhood of a cell, in
                                bandwidths and in diameters */
    void *(*create)(const struct cell_of_particle *h,
                    const struct averaging_options *o);
    void (*free)(void *state);
    void (*bind)(void *state, struct averaging_report *r); /* or NULL */
    void (*spread)(void *state, int m, const double *q, double *field,
                   struct averaging_report *r);
    void (*gather)(void *state, int m, const double *field, double *q,
                   struct averaging_report *r);
    double (*capped_fraction)(const void *state, int i); /* or NULL: 1 */
    /* The variant for polyhedral meshes; NULL if the same functions work there.
     */
    const struct averaging_method *polyhedral;
};

#endif

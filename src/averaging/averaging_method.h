/* averaging_method.h -- the descriptor of an averaging method.
 * Chapter "Averaging".
 *
 * It is included by the methods (pcm.c, kernel.c, ...) and by the list of them;
 * all other files include averaging.h.
 */
#ifndef AVERAGING_AVERAGING_METHOD_H
#define AVERAGING_AVERAGING_METHOD_H

#include "base/model.h"

struct averaging_options;
struct averaging_report;
struct cell_of_particle;

/* One row of the table of methods. state is the result of create, which returns
 * NULL after a message that names the wrong option. h is borrowed. */
struct averaging_method {
    MODEL_MEMBERS;           /* base/model.h */
    int needs_bandwidth;     /* 1: requires options.bandwidth */
    double reach_b, reach_d; /* [-] radius of the neighbourhood of a cell, in
                                bandwidths and in diameters */
    double uniform_widths;   /* [-] bandwidth over the width of the largest cell
                                from which on the field of a uniform bed is
                                uniform to about 2 %; 0: any */
    double gaussian;         /* [-] b of the Gaussian exp(-r^2 / b^2) with the
                                same variance, over the bandwidth; 0: none */
    int has_own_grid;        /* 1: has a grid of its own, with cells of a
                             bandwidth */
    const struct key *own_keys; /* of its tables, the one whose numbers are in
                                   options.own (base/model.h); NULL: none */
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

/* Keys of several methods: the bandwidth, and delta_05 in its place. */
extern const struct key averaging_bandwidth_keys[];
extern const struct key averaging_delta_keys[];

#endif

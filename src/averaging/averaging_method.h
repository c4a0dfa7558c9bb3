/* averaging_method.h -- what a method of averaging consists of.  Chapter 8.
 *
 * For the files that are methods (pcm.c, kernel.c, ...) and for the
 * lists of them; who only averages uses averaging.h.
 */
#ifndef AVERAGING_METHOD_H
#define AVERAGING_METHOD_H

struct averaging_options;
struct averaging_report;
struct hosts;

/* One row of the table of methods. state is what create made, NULL after a
 * message that says which option is wrong. The hosts are borrowed. */
struct averaging_method {
    const char *name, *cite, *what;
    const char *function;    /* where its weights are computed */
    int wide;                /* 1: asks for options.bandwidth */
    double reach_b, reach_d; /* [-] as far as so many bandwidths and diameters
                                the cells around each are kept */
    void *(*create)(const struct hosts *h, const struct averaging_options *o);
    void (*free)(void *state);
    void (*bind)(void *state, struct averaging_report *r); /* or NULL */
    void (*spread)(void *state, int m, const double *q, double *field,
                   struct averaging_report *r);
    void (*gather)(void *state, int m, const double *field, double *q,
                   struct averaging_report *r);
    double (*share)(const void *state, int i); /* or NULL: 1 */
    /* What takes its place where the mesh is no box; or NULL: itself. */
    const struct averaging_method *elsewhere;
};

#endif

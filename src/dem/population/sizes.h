/* sizes.h -- distributions of particle diameters.
 * Chapter "Insertion, removal and energy".
 *
 * A distribution of diameters d is described by its partial moments, the mean
 * of d^k over all particles, in which those larger than x are counted as zero:
 *
 *   M_k(x) = int_0^x d^k f(d) dd,     f(d) dd the share of the particles
 *
 * M_0 is the share by number below x, M_3(x) / M_3(infinity) the share by mass.
 * A diameter is drawn with one random number 0 <= p < 1: the x of M_0(x) = p.
 */
#ifndef DEM_POPULATION_SIZES_H
#define DEM_POPULATION_SIZES_H

#include "base/model.h"

struct sizes;
struct sizes_options;

/* One kind of distribution. */
struct sizes_law {
    MODEL_MEMBERS;              /* base/model.h */
    const struct key *own_keys; /* of these the one whose numbers are in
                                   options.own (base/model.h); NULL: none */
    /* What is wrong with the options, as the end of a sentence; or NULL. */
    const char *(*wrong)(const struct sizes_options *o);
    void (*shape)(struct sizes *s, const struct sizes_options *o);
    double (*quantile)(const struct sizes *s, double p);
    double (*moment)(const struct sizes *s, int k, double x);
};

/* All of them, ended by NULL; NULL for an unknown name. */
extern const struct sizes_law sizes_discrete, sizes_table;
extern const struct sizes_law *const sizes_laws[];
const struct sizes_law *sizes_law_named(const char *name);

/* The options of a case; 0 if not set. */
struct sizes_options {
    const struct sizes_law *law;
    double mean, deviation;    /* [m] normal, before the cut-offs */
    double median;             /* [m] lognormal, before the cut-offs */
    double ratio;              /* [-] lognormal: its 84 % quantile over it */
    double min, max;           /* [m] cut-offs; of uniform the ends */
    double own[MODEL_NUMBERS]; /* of the keys that the law alone reads */
    int by_mass; /* 1: the shares are of the mass, not of the number
                    of particles */
    int n;       /* [-] discrete, table: points */
    const double (*point)[2]; /* [m] d; [-] discrete: its share, of any sum;
                                 table: the share below d, from 0 to 1 */
};

/* As a case writes them. */
struct sizes_setup {
    const char *name, *by;   /* by: "number" or "mass" */
    struct sizes_options of; /* without by_mass, own and points */
    struct key_series points;
};

/* What is wrong with them, as the end of a sentence; NULL if nothing. */
const char *sizes_wrong(const struct sizes_options *o);

/* o has nothing wrong, and what it points to is copied. */
struct sizes *sizes_create(const struct sizes_options *o);

/* The diameter [m] below which the share p of the particles is. */
double sizes_quantile(const struct sizes *s, double p);

/* M_k(x) [m^k], k >= 0. */
double sizes_moment_below(const struct sizes *s, int k, double x);
double sizes_moment(const struct sizes *s, int k);

/* The smallest and the largest diameter there may be [m]; 0, HUGE_VAL. */
double sizes_min(const struct sizes *s);
double sizes_max(const struct sizes *s);

#endif

/* case_scales.h -- lengths, times and speeds that follow from a case.
 *
 * `winnow check` prints them, and a run is refused if its step does not resolve
 * the impacts of its particles.
 */
#ifndef CASE_CHECKS_CASE_SCALES_H
#define CASE_CHECKS_CASE_SCALES_H

#include "case/settings.h"

/* A member is 0 where the case has no such thing. */
struct case_scales {
    int cells, particles;
    double S_c;        /* [m] S_c = V_c^(1/3), of the mean cell [SX15 10] */
    double d, d_most;  /* [m] smallest and largest diameter */
    double across;     /* [-] diameter of a parcel over that of its grains */
    double volume;     /* [m^3] of the particles of a bed */
    double density;    /* [kg/m^3] of the particles */
    double dt, dem_dt; /* [s] of the loop, of the particles */
    int dem_steps;     /* [-] in one step of the loop */
    double inlet;      /* [m/s] largest superficial velocity of an inlet, or the
                          mean one of a periodic flow */
    double up;         /* [m/s] of that the part against the fall of grains */
    double impact;     /* [m/s] speed of collisions that is assumed */
    double end;        /* [s] */
};
struct case_scales case_scales_of(const struct settings *s);

/* Into the mesh, normal to a patch on the whole, with length 1. */
void case_scales_inward(const struct mesh *m, const struct patch *p,
                        double e[3]);

/* particles.step = "auto": 1, or 0 if the case has a number or no particles. */
int case_scales_is_auto(const struct settings *s);

/* Then the suggested step becomes that of the case, of which the fluid's step
 * is a whole number. 0, or 2 after a message. */
int case_scales_auto_step(struct settings *s);

/* Whether the machine has the memory that the averaging takes, besides all
 * else. 0, or 2 after a message. */
int case_scales_check_memory(const struct settings *s,
                             const struct case_scales *k);

/* Whether a run can begin: the memory, and a particle step that resolves the
 * impacts, unless particles.unsafe_step is set. 0, or 2 after a message. */
int case_scales_check(const struct settings *s);

/* Of the smallest particle of one material in an impact on an equal one. */
struct case_limits {
    int material;     /* [-] its number */
    double d;         /* [m] */
    double density;   /* [kg/m^3] */
    double rayleigh;  /* [s] T_R [LS 5.11]; HUGE_VAL: the law has none */
    double contact;   /* [s] duration of an impact */
    double suggested; /* [s] */
    double longest;   /* [s] that still resolves the impact */
};

/* Of material number m, for impacts at v [m/s]; d = 0 if no particle is of
 * it. */
struct case_limits case_scales_limits(const struct settings *s, int m,
                                      double v);

/* The one that allows the shortest step; d = 0 if there is no particle. */
struct case_limits case_scales_tightest(const struct settings *s, double v);

/* The largest velocity that the case gives a sphere, at the start or when it is
 * inserted [m/s]. */
double case_scales_initial_speed(const struct settings *s);

/* The name of a material. */
const char *case_scales_name(const struct settings *s, int m);

/* About the time of one core, without settling [s]; the same of a case with
 * these scales; flow: 1 if it has a fluid. */
double case_scales_seconds(const struct settings *s);
double case_scales_cost(const struct case_scales *k, int flow);

#endif

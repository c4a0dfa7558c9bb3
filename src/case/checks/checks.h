/* checks.h -- the checks of a case, and the scales that follow from it. */
#ifndef CASE_CHECKS_CHECKS_H
#define CASE_CHECKS_CHECKS_H

#include "case/models.h"
#include "case/settings.h"

/* --- validate: a case as a whole.
 *
 * Each key alone has been checked against its row; here a case is checked as a
 * whole: something to compute, every side of the box described once, an outlet
 * for what flows in, a contact law with the constants it asks for, a bed that
 * fits into the box. */

/* 0, or 2 after one message. */
int validate_case(struct settings *s);

/* --- output check: what a case says in the group output, checked. */

/* 0 if the case asks for what there is; else 2 after a message. */
int output_check(const struct settings *s);

/* --- model choice: which models a case chooses, and what these ask for. */

/* 1 if the case chooses this model, by a word, a group or in a list. Of a kind
 * whose key belongs to other models one of these must be chosen. */
int model_choice_is_on(const struct settings *s, const struct kind *kind,
                       const struct model *m);

/* 0 if the model that the case chooses of a kind reads the key; else 2, after a
 * message with those that do. */
int model_choice_refuse_unread(const struct settings *s, const char *kind,
                               const char *path);

/* For validate_case: a model has the keys that it cannot do without. 0, or 2
 * after one message. */
int model_choice_check(const struct settings *s);

/* --- case memory: what a case needs, and whether the machine has it.
 *
 * It is counted before anything is made, from the numbers of cells and of
 * particles: a case that cannot fit is refused at once, before the machine
 * begins to swap. */

/* About what cells and particles take [byte]. */
double case_memory_bytes(const struct settings *s);

/* 0; or 2 after a message if these and `more` [byte] beside them are beyond
 * what the machine has, or the particles beyond what can be numbered. */
int case_memory_check(const struct settings *s, double more);

/* Whether the machine can list this many pairs of particles, which this key
 * [m] asks for: 0, or 2 after a message. */
int case_memory_check_pairs(const struct settings *s, const char *key,
                            double pairs);

/* --- case scales: lengths, times and speeds that follow from a case.
 *
 * `winnow check` prints them, and a run is refused if its step does not
 * resolve the impacts of its particles. */

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
    double way;        /* [m] through the mesh from an inlet */
    double jet;        /* [m/s] the fastest in an inlet that is not even */
    double changes;    /* [m/s] of inlet in the run, from rest, ups and downs */
    double square;     /* [-] mean square of inlet over that of the largest */
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

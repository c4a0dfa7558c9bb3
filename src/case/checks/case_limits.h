/* case_limits.h -- how long a particle step each material of a case allows. */
#ifndef CASE_CHECKS_CASE_LIMITS_H
#define CASE_CHECKS_CASE_LIMITS_H

#include "case/population/case_population.h"
#include "case/settings.h"

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

/* 1 if particles.list chooses a method without contacts: particles pass through
 * each other, and no impact has to be resolved. */
int case_limits_no_contacts(const struct settings *s);

/* Of material number m, for impacts at v [m/s]; d = 0 if no particle is of
 * it. */
struct case_limits case_limits_of(const struct settings *s, int m, double v);

/* The one that allows the shortest step; d = 0 if there is no particle. */
struct case_limits case_limits_tightest(const struct settings *s, double v);

/* The largest velocity that the case gives a sphere, at the start or when it is
 * inserted [m/s]. */
double case_limits_initial_speed(const struct settings *s);

/* The name of a material. */
const char *case_limits_name(const struct settings *s, int m);

#endif

/* contact.h -- the force between two touching spheres.
 * Chapter "Particles and contact".
 *
 * n points from particle j to particle i, delta = R_i + R_j - |x_i - x_j| is
 * the overlap. On particle i act
 *
 *   F_n = (elastic(delta) - eta_n v_n) n                       [LS 4.4, 4.7]
 *   F_t = -k_t xi - eta_t v_t,   |F_t| <= mu |F_n|             [LS 4.8]
 *
 * and on particle j their negatives. v is the relative velocity of the two
 * surfaces at the contact, xi the displacement of the tangential spring, v_t
 * added up since they first touched. A law defines elastic, eta_n, k_t and
 * eta_t; everything else is the same for all laws (reference.c). A wall is a
 * sphere of infinite mass and radius, of the material of the walls
 * (materials.h).
 */
#ifndef DEM_CONTACT_H
#define DEM_CONTACT_H

#include <math.h>

#include "base/model.h"

/* The material of grains and walls. */
struct material {
    double young;              /* [Pa] E; law "hertz" */
    double poisson;            /* [-] nu; law "hertz" */
    double stiffness;          /* [N/m] k; law "linear" */
    double tangential;         /* [-] k_t / k of law "linear"; 0: 2/7 */
    double restitution;        /* [-] e; 0: critical damping [LS 4.11, 4.12] */
    double friction;           /* [-] mu */
    double rolling;            /* [-] mu_r: resists M <= mu_r R* F_n; 0: none */
    double charge;             /* [C] of a sphere (electrostatic.h) */
    double own[MODEL_NUMBERS]; /* of the keys that the law alone reads */
};

/* The properties of a pair of materials (materials.h). */
struct material_pair {
    const struct material *of[2]; /* each one's elastic constants */
    double stiffness;             /* [N/m] k; law "linear" */
    double tangential;            /* [-] k_t / k of law "linear"; 0: 2/7 */
    double restitution;           /* [-] e */
    double friction;              /* [-] mu */
    double rolling;               /* [-] mu_r */
};

/* The constants of a law in the loop, computed once. */
struct contact_constants {
    double normal;             /* linear: k [N/m]; hertz: E* [Pa] */
    double tangential;         /* linear: k_t [N/m]; hertz: G* [Pa] */
    double damping_n;          /* [-] damping ratio, normal */
    double damping_t;          /* [-] eta_t / eta_n */
    double friction;           /* [-] mu */
    double rolling;            /* [-] mu_r */
    double own[MODEL_NUMBERS]; /* what the law makes of its own keys */
};

/* The response of a law to one contact. */
struct contact_response {
    double elastic;      /* [N] */
    double stored;       /* [J] by the elastic force: its integral over delta */
    double eta_n, eta_t; /* [kg/s] */
    double k_t;          /* [N/m] */
};

/* A law is one function of the overlap delta [m], R* [m] and m* [kg]. The
 * vector loops inline it (fast/sweep.c), and the reference loop calls
 * it (reference.c). */
typedef struct contact_response
contact_respond(const struct contact_constants *k, double delta, double R_star,
                double m_star);
#define CONTACT_INLINE static inline __attribute__((always_inline, unused))

struct contact_law {
    MODEL_MEMBERS; /* base/model.h */
    /* Of these the table of its own keys (base/model.h), numbers of a material:
     * "particles.grains.NAME", whose values are in material.own. Where there
     * are rows "particles.materials.NAME" too, other materials have their own,
     * and else that of the grains. */
    const struct key *own_keys;
    struct contact_constants (*constants)(const struct material_pair *p);
    /* Duration [s] of a head-on impact at v [m/s]; R* [m], m* [kg]. With a
     * restitution of 1 that without any damping, also of a law that damps by
     * keys of its own: the step is chosen by it. */
    double (*duration)(const struct material *m, double R_star, double m_star,
                       double v);
    /* Rayleigh's time [s] of a sphere of radius r [m] and density rho [kg/m^3],
     * in which a wave goes round it [LS 5.11]; HUGE_VAL for a law that has no
     * elastic waves. */
    double (*wave_time)(const struct material *m, double r, double rho);
    contact_respond *respond;
};

/* All laws, ended by NULL; contact_law_named: NULL for an unknown name. */
extern const struct contact_law *const contact_laws[];
const struct contact_law *contact_law_named(const char *name);

/* Damping ratio zeta with which a linear oscillator has the fraction e of its
 * speed after half a period: -ln e / sqrt(pi^2 + ln^2 e) [LS 4.4]; 1 at e = 0.
 */
double contact_damping_ratio(double e);

/* --- rolling: rolling friction of a contact. Chapter "Materials, rolling and
 * cohesion".
 *
 * The elastic-plastic model with a dashpot, type C of [Ai11]: a spring whose
 * angle theta grows by the relative rotation of the two, and which slips like
 * the tangential one where its moment is more than mu_r R* |F_n|:
 *
 *   M = -k_r theta - C_r w_t,   |M| <= mu_r R* |F_n|
 *   k_r = k_t R*^2,   C_r = 2 zeta_r sqrt(I_r k_r),
 *   1/I_r = 1/(I_i + m_i R_i^2) + 1/(I_j + m_j R_j^2)
 *
 * w_t is omega_i - omega_j without its part along n; it and M are the same in
 * a rotating frame of reference. Where it slips, the spring is reduced until
 * its moment is no more than the limit, as with sliding friction; in [Ai11]
 * the dashpot is dropped there. A constant moment against w_t would need no
 * theta, but a sphere would never come to rest: the moment would change its
 * sign in every step. */

/* [-] zeta_r: the oscillation ends after a few periods; with three times this
 * ratio the dashpots of six neighbours would reverse the rotation of a sphere
 * within a step. */
static const double rolling_damping_ratio = 0.3;

/* The moment [N m] on particle i; theta is moved on by dt [s] and cut back
 * where it slips. w: omega_i - omega_j [rad/s]; limit: mu_r R* |F_n| [N m]. */
static inline void rolling_moment(double M[3], double theta[3],
                                  const double w[3], const double n[3],
                                  double k_r, double C_r, double limit,
                                  double dt)
{
    const double spin = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
    const double normal = theta[0] * n[0] + theta[1] * n[1] + theta[2] * n[2];
    double size = 0.0, elastic2 = 0.0;

    for (int a = 0; a < 3; a++) {
        const double w_t = w[a] - spin * n[a];
        theta[a] += w_t * dt - normal * n[a];
        M[a] = -k_r * theta[a] - C_r * w_t;
        size += M[a] * M[a];
        elastic2 += k_r * theta[a] * k_r * theta[a];
    }
    size = sqrt(size);
    if (size <= limit) return;
    for (int a = 0; a < 3; a++) {
        M[a] *= limit / size;
        if (elastic2 > limit * limit) theta[a] = -M[a] / k_r;
    }
}

/* --- limits: limits of the particle step. Chapter "Time steps".
 *
 * Two measures of the response time of a grain: the duration of an impact, and
 * the Rayleigh time in which a surface wave travels over a sphere [LS 5.11]. A
 * step must be a small part of either. */

/* T_R = pi r sqrt(rho / G) / (0.1631 nu + 0.8766) [s] [LS 5.11]; r [m], rho
 * [kg/m^3], G [Pa]. */
double limits_rayleigh(double r, double rho, double G, double nu);

/* Duration [s] of the impact of two equal spheres, the shortest that spheres
 * of at least d [m] and rho [kg/m^3] can have; relative speed v [m/s]. */
double limits_contact_time(const struct contact_law *law,
                           const struct material *m, double d, double rho,
                           double v);

/* The suggested step [s]: 1/25 of the contact time, and at most 1/10 of the
 * Rayleigh time where the law has one, which holds for any speed. With 25 steps
 * a contact a rebound has e to 0.013 with Hertz's law, and with the linear one
 * to 0.021 where e >= 0.7 and to 0.037 below, in the worst phase of the step
 * (test_limits); and a sphere amid twelve others, whose springs act on it
 * together, still has about 25 steps in a period of its fastest oscillation. */
double limits_step(const struct contact_law *law, const struct material *m,
                   double d, double rho, double v);

/* The longest step [s] that still resolves a contact: 1/15 of its time; and in
 * which none moves by more than d/2, so that none is past another one before
 * the two have met. (In the suggested step by 0.3 d.) In both the contact time
 * is at most 5/3 of that without damping, a limit that is reached at e = 0.015.
 */
double limits_longest_step(const struct contact_law *law,
                           const struct material *m, double d, double rho,
                           double v);

#endif

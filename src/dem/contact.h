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
    /* Duration [s] of a head-on impact at v [m/s]; R* [m], m* [kg]. */
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

#endif

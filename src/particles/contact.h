/* contact.h -- what two spheres do to each other when they touch.  Chapter 2.
 *
 * n points from j to i, delta is the overlap, v the velocity of the surface of
 * i relative to that of j at the contact [LS 4.8]:
 *
 *   v   = v_i - v_j - (R_i w_i + R_j w_j) x n
 *   F_n = (elastic(delta) - eta_n v.n) n
 *   F_t = -k_t s - eta_t v_t,    |F_t| <= mu |F_n|
 *   T_i = -R_i n x F_t,  T_j = -R_j n x F_t                        [LS 4.16]
 *
 * s, the tangential spring, is the history of the contact: v_t added up while
 * it lasts, turned with n, and cut back where the cap holds. A law says what
 * elastic, eta_n, k_t and eta_t are; a wall is a sphere of infinite radius and
 * mass.
 */
#ifndef CONTACT_H
#define CONTACT_H

/* The material of all spheres and of the walls. */
struct material {
    double density;     /* [kg/m^3] */
    double young;       /* [Pa] Hertz */
    double poisson;     /* [-] Hertz */
    double stiffness;   /* [N/m] linear */
    double restitution; /* [-] e, in (0, 1] */
    double friction;    /* [-] mu */
};

/* What a law keeps of the material. */
struct contact_constants {
    double E;       /* [Pa] effective Young's modulus E* */
    double G;       /* [Pa] effective shear modulus G* */
    double k;       /* [N/m] */
    double damping; /* [-] eta = damping sqrt(stiffness m*) */
    double friction;
};

/* The springs and dashpots of one contact at one moment. */
struct springs {
    double elastic; /* [N] normal elastic force */
    double eta_n;   /* [kg/s] */
    double k_t;     /* [N/m] */
    double eta_t;   /* [kg/s] */
};

struct pair_list;
struct particles;
struct strip_forces;

/* One law. pairs and walls add the forces of a strip of the list and keep the
 * history; period holds the box lengths of periodic directions, else 0. */
struct contact_law {
    const char *name; /* as a case spells it */
    const char *cite;
    const char *what;
    struct contact_constants (*constants)(const struct material *m);
    void (*pairs)(const struct contact_constants *c, double dt,
                  const struct particles *ps, struct pair_list *list, int strip,
                  struct strip_forces *f);
    void (*pairs_periodic)(const struct contact_constants *c, double dt,
                           const struct particles *ps, struct pair_list *list,
                           int strip, struct strip_forces *f);
    void (*walls)(const struct contact_constants *c, double dt,
                  const struct particles *ps, struct pair_list *list, int strip,
                  struct strip_forces *f);
    /* Length of a head-on collision of two spheres of diameter d [m] at speed
     * v [m/s]. */
    double (*time)(const struct material *m, double d, double v);
};

/* All laws, ended by NULL; NULL for an unknown name. */
extern const struct contact_law *const contact_laws[];
const struct contact_law *contact_law_named(const char *name);
extern const struct contact_law contact_linear, contact_hertz;

/* --- equations of the linear law ---------------------------------------- */

/* m_i m_j / (m_i + m_j) [kg]. */
double contact_effective_mass(double m_i, double m_j);

/* eta of the spring-dashpot that gives restitution e [kg/s] [LS 4.4]. */
double contact_linear_damping(double k, double e, double m_i, double m_j);

/* Length of its collision [s] [LS 4.4]. */
double contact_linear_time(double k, double e, double m_i, double m_j);

/* --- equations of Hertz and Mindlin -------------------------------------- */

/* E* [Pa]: 1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j  [LS 4.9]. */
double contact_effective_young(double E_i, double E_j, double nu_i,
                               double nu_j);

/* G* [Pa]: 1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j, after Mindlin; LS prints
 * another sum under [LS 4.10]. */
double contact_effective_shear(double E_i, double E_j, double nu_i,
                               double nu_j);

/* k_n = (4/3) E* sqrt(R*) [N/m^1.5] [LS 4.9]. */
double contact_hertz_stiffness(double E, double R);

/* Elastic part of F_n, k_n delta^1.5 [N] [LS 4.7]. */
double contact_hertz_force(double E, double R, double delta);

/* k_t = 8 G* sqrt(R* delta) [N/m] [LS 4.10]. */
double contact_mindlin_stiffness(double G, double R, double delta);

/* Length of an elastic collision [s] and its largest overlap [m], of effective
 * mass m at relative speed v. */
double contact_hertz_time(double E, double R, double m, double v);
double contact_hertz_overlap(double E, double R, double m, double v);

/* damping of contact_constants for restitution e, from -ln e / sqrt(ln^2 e +
 * pi^2); times 2 for the linear spring, 2 sqrt(5/6) for Hertz's. */
double contact_damping_ratio(double e);

#endif

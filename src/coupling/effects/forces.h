/* forces.h -- the formulas of the effects, which tests and `winnow eval` ask as
 * well.  Chapters "Further forces", "Agitation" and "The coupled loop". */
#ifndef COUPLING_EFFECTS_FORCES_H
#define COUPLING_EFFECTS_FORCES_H

/* Forces and torque of the fluid on a particle in a shear, or that spins. */

/* Saffman's lift in a shear.
 *
 *   Re_G = d^2 |curl u| / nu                                        [LS 5.5]
 *   F = 1.615 mu d |w| sqrt(Re_G),  along w x curl u                [LS 5.6]
 *
 * w = u - v. 1.615 is 6.46/4 of Saffman's correction of 1968; LS rounds it to
 * 1.61. In the vector form F = 1.615 d^2 sqrt(rho mu/|curl u|) w x curl u. It
 * holds for Re << sqrt(Re_G) << 1; Mei's factor (1992) carries it to Re = 100
 * and 0.005 < alpha < 0.4, alpha = d |curl u|/(2 |w|). */

/* Re_G [-] of a shear G [1/s] [LS 5.5]. */
double saffman_reynolds(double d, double nu, double G);

/* The force [N] with the printed coefficient 1.61 [LS 5.6]. */
double saffman_force(double mu, double d, double u_r, double Re_G);

/* Mei's factor [-]. */
double saffman_factor(double Re, double alpha);

/* The force F [N] on a sphere of diameter d [m] for a slip w [m/s] and a curl
 * [1/s], in a fluid of rho [kg/m^3] and mu [Pa s]. */
void saffman_lift(double rho, double mu, double d, const double w[3],
                  const double curl[3], double F[3]);

/* Forces and torque of the fluid on a particle that spins.
 *
 *   F = (1/2) rho A C_LR |w| w x Omega / |Omega|                    [LS 5.7]
 *
 * with w = u - v, A = pi d^2/4 and Omega = omega - curl u/2, the spin against
 * that of the fluid. LS writes |v - u| (v - u) for the size, and the direction
 * in words. C_LR = d |Omega|/|w| of Rubinow and Keller (1961) at small Re, as
 * the limit of Oesterle and Bui Dinh (1998), to Re = 140.
 *
 *   T = -(1/2) rho (d/2)^5 C_R |Omega| Omega
 *   C_R = 64 pi/Re_r to Re_r = 32, 12.9/sqrt(Re_r) + 128.4/Re_r above
 *
 * with Re_r = rho d^2 |Omega|/mu; the first is the exact T = -pi mu d^3 Omega,
 * the second Dennis, Singh and Ingham (1980), to Re_r = 1000. */

/* C_LR [-] for Re of the slip and Re_r of the spin. */
double spin_lift_coefficient(double Re, double Re_r);

/* The force [N] for a spin normal to the slip u_r [m/s] [LS 5.7]; it turns with
 * the slip. */
double spin_force(double rho, double C_LR, double d, double u_r);

/* F [N] for a slip w [m/s] and a spin Omega [rad/s] against the fluid's. */
void spin_lift(double rho, double mu, double d, const double w[3],
               const double Omega[3], double F[3]);

/* C_R Re_r [-] of the torque: 64 pi in slow rotation. */
double spin_torque_factor(double Re_r);

/* The rate [1/s] at which the torque slows a sphere of density rho_s. */
double spin_decay_rate(double rho, double mu, double d, double rho_s,
                       double Omega);

/* Basset's history force [LS 5.4].
 *
 *   F = (3/2) d^2 sqrt(pi rho mu) H,
 *   H = int_0^t w'(s)/sqrt(t - s) ds + w(0)/sqrt(t)
 *
 * with w = u - v at the particle and w' along its path. The kernel is a sum of
 * exponentials,
 *
 *   1/sqrt(t) = sum_k c_k exp(-s_k t),   dt <= t <= 1e6 dt,
 *
 * the trapezium rule for (1/sqrt(pi)) int exp(y/2 - t e^y) dy with spacing
 * pi^2/ln(2/tol). Each term needs one vector a particle, whose past decays by a
 * factor a step: neither memory nor work grow with time. The last step, in
 * which the kernel is singular, and the one before are integrated exactly for a
 * w that is linear in each step. */

enum { BASSET_TERMS = 64 }; /* at most */

struct basset_kernel {
    int n;                  /* [-] terms */
    double c[BASSET_TERMS]; /* [1/sqrt(s)] */
    double s[BASSET_TERMS]; /* [1/s] */
};

/* The terms for steps of dt [s] and a largest relative error `tolerance` [-],
 * from 2e-5 (51 terms) to 0.1 (10). */
struct basset_kernel basset_kernel_create(double dt, double tolerance);

/* The sum at time t [s]: about 1/sqrt(t). */
double basset_kernel_value(const struct basset_kernel *k, double t);

/* (3/2) d^2 sqrt(pi rho mu) [kg/sqrt(s)]. */
double basset_coefficient(double rho, double mu, double d);

/* The force [N] after a time t [s] of the constant rate dw/dt [m/s^2], from
 * w = 0 [LS 5.4]. */
double basset_force(double rho, double mu, double d, double t, double rate);

/* The liquid between two particles that are close.
 *
 *   F = 6 pi mu R*^2 (1/z - 1/z_out) dz/dt,   R* = R_i R_j/(R_i + R_j)  [Cox67]
 *
 * against the change of the gap z, along the line of centres, for z < z_out;
 * R* = R at a wall. With the last term it begins at zero; at larger gaps it is
 * part of the drag. Below z_min, the height of the roughness, the gap counts as
 * z_min; for surfaces in contact the contact law has the damping. There is no
 * force on the liquid: the forces on the two are opposite. */

/* The coefficient [kg/s] for a gap z [m] of 0 or more. */
double lubrication_coefficient(double mu, double R_star, double z, double z_min,
                               double z_out);

/* The random part of the drag.
 *
 * The fluctuations that the averaging removes act on each particle as a random
 * force: its drag coefficient is C_d + C' [EW18 32], and C' is a correlated
 * signal,
 *
 *   C'(t + dt) = a C'(t) + b sqrt(1 - a^2) w,   a = exp(-dt / T),   [EW18 33]
 *
 * with normal numbers w [EW18 34] and b = sigma(C_d). With a from dt it is
 * exact for any step: an Ornstein-Uhlenbeck process of the time T. */

/* The correlation a [-] after a step, and T [s] from a [EW18 37]. */
double stochastic_drag_memory(double dt, double T);
double stochastic_drag_time(double a, double dt);

/* C' after a step [EW18 33]. */
double stochastic_drag_step(double a, double b, double C, double w);

/* Mean and variance of C' that are to be expected n steps after it was C
 * [EW18 35, 36]; the document prints a^(n dt) for a^n. */
double stochastic_drag_mean(double a, double n, double C);
double stochastic_drag_variance(double a, double b, double n);

/* sigma(C_d) [-] at Re_p [-]: low at Re_low and high at Re_high, held beyond,
 * between them a power of Re_p, or linear where that is asked for or low is 0.
 */
struct stochastic_drag_sigma {
    double low, high;
    double Re_low, Re_high;
    int linear;
};
double stochastic_drag_sigma(const struct stochastic_drag_sigma *s, double Re);

/* Exponential moving averages of the averaged fields.
 *
 *   d<eps>/dt = (eps - <eps>) / b_t                            [SX15 11-13]
 *   <eps>^n = (1 - alpha) eps^n + alpha <eps>^(n-1)            [SX15 14] */

struct time_average {
    int n;          /* [-] cells */
    double alpha;   /* [-] weight of the past in one step */
    double *eps;    /* [-] mean fluid fraction */
    double *eps_us; /* [m/s] mean of eps_s u_s, 3 a cell */
};

/* alpha = 1 / (1 + dt / b_t) [-] [SX15 14]. */
double time_average_weight(double dt, double b_t);

/* mean = (1 - alpha) now + alpha mean for n values [SX15 14]. */
void time_average_update(double alpha, int n, const double *now, double *mean);

/* --- particle stress ------------------------------------------------------ */

/* The stress tau [Pa] of solids of the fraction eps_s that do not meet.
 *
 *   harris-crighton  tau = P eps_s^beta / (eps_cp - eps_s)        [Snider01]
 *   lun              tau = P eps_s (1 + 2 (1 + e) eps_s g_0),     [Lun84]
 *                    P = rho_s Theta, g_0 = 0.6 / (1 - (eps_s / eps_cp)^(1/3))
 */
struct particle_stress_law {
    int lun;         /* [-] 1: of Lun */
    double exponent; /* [-] beta */
    double packing;  /* [-] eps_cp */
    double e;        /* [-] restitution */
};

/* tau [Pa], its slope d tau / d eps_s [Pa], and the fraction [-] that has it;
 * P [Pa]. */
double particle_stress(const struct particle_stress_law *law, double P,
                       double eps_s);
double particle_stress_slope(const struct particle_stress_law *law, double P,
                             double eps_s);
double particle_stress_fraction(const struct particle_stress_law *law, double P,
                                double tau);

/* Where the particles are as a step begins, for what stands for collisions, and
 * the packing [-]. */
struct hats;
struct simulation;
const struct hats *particle_stress_places(const struct simulation *sim,
                                          double *packing);

/* The rate [1/s] at which collisions of restitution e take the fluctuations
 * away, half of that of their square [Haff83, ORourke10]; and at which elastic
 * ones make them alike in all directions, p/mu of a dilute gas of spheres
 * [ORourke12]. eps_s per diameter [1/m], Theta [m^2/s^2]. */
double collision_damping_rate(double e, double eps_per_d, double g_0,
                              double Theta);
double collision_isotropy_rate(double eps_per_d, double g_0, double Theta);

#endif

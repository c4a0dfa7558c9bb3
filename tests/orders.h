/* orders.h -- by which order in the step each force of the fluid is computed:
 * one scene a force, each with a solution that is not the program's. For
 * tests/test_orders.c and figures/22/22-orders.c.
 *
 * A sphere of 0.1 mm in water, 2.65 times as dense unless the scene says
 * otherwise, for two of its relaxation times.
 */
#ifndef ORDERS_H
#define ORDERS_H

#include <complex.h>
#undef I /* a moment of inertia, to those who include this */

#include "coupling/effects/forces.h"
#include "dem/dem_method.h"
#include "spheres.h"
#include "suspension.h"

/* What a flight ends with: velocity, spin, place. */
enum { ORDERS_ALONG, ORDERS_ACROSS, ORDERS_SPIN, ORDERS_X, ORDERS_Y, ORDERS_Q };

/* A sphere in a fluid that does not feel it. The stream swings along x with
 * the amplitude U, or is a steady sine of y with that amplitude. */
struct orders_flight {
    struct scene s;
    double T;           /* [s] */
    double U;           /* [m/s] */
    double v[2], omega; /* [m/s], [1/s] of the sphere at first */
    int profile;        /* 1: the sine of y */
    int compared;       /* by orders_miss, one of the above */
};

static inline struct orders_flight orders_flight(void)
{
    struct orders_flight o = {.s = air, .U = 1e-2, .T = 3e-3};

    o.s.one_way = o.s.substeps = o.s.n = o.s.dem_steps = 1;
    o.s.averaging = "pcm";
    o.s.drag = "schiller-naumann";
    o.s.relaxation = SLIP_INTEGRATION_EXPONENTIAL;
    o.s.pressure_gradient = 0;
    o.s.rho = 1000.0;
    o.s.mu = 1e-3;
    o.s.rho_s = 2650.0;
    o.s.d = 1e-4;
    return o;
}

/* What of the stream the sphere meets: velocity, curl, Laplacian. */
struct orders_stream {
    double u, curl, lap; /* [m/s], [1/s], [1/(m s)] */
};

/* Over a third of a period, so that no derivative is zero in the end. */
static inline double orders_swing(const struct orders_flight *o, double t)
{
    return o->U * sin(2.0 * t / o->T);
}

/* As the cells have it: differences over their width h. */
static inline double orders_profile(const struct orders_flight *o, double y)
{
    return o->U * sin(2.0 * M_PI * y / o->s.size);
}

static inline struct orders_stream orders_stream(const struct orders_flight *o,
                                                 double t, double y)
{
    const double h = o->s.size / o->s.cells;

    if (!o->profile) return (struct orders_stream){.u = orders_swing(o, t)};
    const double up = orders_profile(o, y + h), u = orders_profile(o, y);
    const double down = orders_profile(o, y - h);
    return (struct orders_stream){u, -(up - down) / (2.0 * h),
                                  (up - 2.0 * u + down) / (h * h)};
}

/* The sum of the forces [LS 5.8], but for the history, in the stream at y. */
static inline void orders_slope(const struct orders_flight *o, double t,
                                double y, const double q[ORDERS_Q],
                                double dq[ORDERS_Q])
{
    const struct scene *const s = &o->s;
    const struct orders_stream at = orders_stream(o, t, y);
    const double V = M_PI / 6.0 * gsl_pow_3(s->d);
    const double w[3] = {at.u - q[0], -q[1], 0.0};
    const double curl[3] = {0.0, 0.0, at.curl};
    const double Omega[3] = {0.0, 0.0, q[2] - 0.5 * at.curl};
    const double Re = s->rho * hypot(w[0], w[1]) * s->d / s->mu;
    const double k = 3.0 * M_PI * s->mu * s->d * (1.0 + 0.15 * pow(Re, 0.687));
    const double du =
        o->profile ? 0.0 : 2.0 * o->U / o->T * cos(2.0 * t / o->T);
    const double m = V * (s->rho_s + s->virtual_mass * s->rho);
    double lift[3] = {0.0}, magnus[3] = {0.0};

    if (s->saffman) saffman_lift(s->rho, s->mu, s->d, w, curl, lift);
    if (s->magnus) spin_lift(s->rho, s->mu, s->d, w, Omega, magnus);
    dq[0] = (k * w[0] + lift[0] + magnus[0] +
             V * s->rho * du * (s->virtual_mass + s->pressure_gradient) +
             V * s->mu * at.lap * s->viscous_stress) /
            m;
    dq[1] = (k * w[1] + lift[1] + magnus[1]) / m;
    dq[2] = s->fluid_torque ? -Omega[2] * spin_decay_rate(s->rho, s->mu, s->d,
                                                          s->rho_s, Omega[2])
                            : 0.0;
    dq[3] = q[0];
    dq[4] = q[1];
}

/* Runge and Kutta's rule. */
static inline void orders_integrate(const struct orders_flight *o, double y,
                                    double q[ORDERS_Q], int n)
{
    static const double at[4] = {0.0, 0.5, 0.5, 1.0};
    static const double weight[4] = {1.0, 2.0, 2.0, 1.0};
    const double h = o->T / n;

    for (int i = 0; i < n; i++) {
        double dq[ORDERS_Q] = {0.0}, sum[ORDERS_Q] = {0.0};
        for (int r = 0; r < 4; r++) {
            double p[ORDERS_Q];
            for (int k = 0; k < ORDERS_Q; k++)
                p[k] = q[k] + at[r] * h * dq[k];
            orders_slope(o, (i + at[r]) * h, y, p, dq);
            for (int k = 0; k < ORDERS_Q; k++)
                sum[k] += weight[r] / 6.0 * dq[k];
        }
        for (int k = 0; k < ORDERS_Q; k++)
            q[k] += h * sum[k];
    }
}

/* Sets the stream of the time t, and what drives it to that of the next step.
 */
static inline void orders_drive(struct simulation *sim,
                                const struct orders_flight *o, double t)
{
    const struct mesh *const m = sim->mesh;
    const double rate =
        (orders_swing(o, t + sim->dt) - orders_swing(o, t)) / sim->dt;

    for (int c = 0; c < m->n_cells; c++)
        sim->fluid->u[3 * c] = orders_stream(o, t, m->centre[3 * c + 1]).u;
    for (int f = 0; f < m->n_faces; f++)
        sim->fluid->phi[f] = sim->fluid->u[3 * m->owner[f]] * mesh_S(m, f)[0];
    sim->fluid->options.mean_gradient[0] = o->profile ? 0.0 : -o->s.rho * rate;
    sim->fluid->mean_gradient[0] = sim->fluid->options.mean_gradient[0];
}

/* What there is after T in so many steps, and what there should be. */
static inline void orders_fly(const struct orders_flight *given, int steps,
                              double found[ORDERS_Q], double exact[ORDERS_Q])
{
    struct orders_flight o = *given;
    o.s.dt = o.T / steps;
    struct simulation *const sim = build(&o.s);
    struct particles *const ps = sim->particles;
    const int host = mesh_cell_at(sim->mesh, ps->x[0], ps->y[0], ps->z[0]);
    const double y = sim->mesh->centre[3 * host + 1];

    ps->y[0] = y;
    ps->vx[0] = o.v[0];
    ps->vy[0] = o.v[1];
    ps->vz[0] = 0.0;
    ps->wz[0] = o.omega;
    memcpy(exact, (double[ORDERS_Q]){o.v[0], o.v[1], o.omega, ps->x[0], y},
           ORDERS_Q * sizeof *exact);
    memset(sim->fluid->u, 0, 3 * (size_t)sim->mesh->n_cells * sizeof(double));
    orders_drive(sim, &o, 0.0);
    coupling_start(sim);
    for (int n = 0; n < steps; n++) {
        orders_drive(sim, &o, n * o.s.dt);
        run(sim, 1);
    }
    orders_integrate(&o, y, exact, 4000);
    memcpy(
        found,
        (double[ORDERS_Q]){ps->vx[0], ps->vy[0], ps->wz[0], ps->x[0], ps->y[0]},
        ORDERS_Q * sizeof *found);
    discard(sim);
}

/* The error of what is compared, relative to it. */
static inline double orders_miss(const struct orders_flight *o, int steps)
{
    double found[ORDERS_Q], exact[ORDERS_Q];

    orders_fly(o, steps, found, exact);
    return fabs(found[o->compared] / exact[o->compared] - 1.0);
}

/* --- one scene a force ---------------------------------------------------- */

static inline double orders_drag(int steps)
{
    const struct orders_flight o = orders_flight();
    return orders_miss(&o, steps);
}

static inline double orders_pressure(int steps)
{
    struct orders_flight o = orders_flight();
    o.s.pressure_gradient = 1;
    return orders_miss(&o, steps);
}

static inline double orders_virtual_mass(int steps)
{
    struct orders_flight o = orders_flight();
    o.s.virtual_mass = 0.5;
    return orders_miss(&o, steps);
}

/* Thrown along a steady profile. */
static inline double orders_stress(int steps)
{
    struct orders_flight o = orders_flight();
    o.profile = o.s.viscous_stress = 1;
    o.s.size = 6.0 * o.s.d; /* the force is 6 % of the drag */
    return orders_miss(&o, steps);
}

static inline double orders_saffman(int steps)
{
    struct orders_flight o = orders_flight();
    o.profile = o.s.saffman = 1;
    o.U = 0.1;
    o.compared = ORDERS_ACROSS;
    return orders_miss(&o, steps);
}

static inline double orders_magnus(int steps)
{
    struct orders_flight o = orders_flight();
    o.s.magnus = 1;
    o.omega = 1000.0;
    o.compared = ORDERS_ACROSS;
    return orders_miss(&o, steps);
}

/* At Re_r of 1000, where the torque is not proportional to the spin. */
static inline double orders_torque(int steps)
{
    struct orders_flight o = orders_flight();
    o.s.fluid_torque = 1;
    o.U = 0.0;
    o.omega = 1e5;
    o.T = 1e-4;
    o.compared = ORDERS_SPIN;
    return orders_miss(&o, steps);
}

/* --- history ----------------------------------------------------------------
 */

/* exp(x^2) erfc(x) = (2/sqrt(pi)) int_0^inf exp(-s^2 - 2 x s) ds, Re x > 0, by
 * Simpson's rule. */
static inline double complex orders_scaled_erfc(double complex x)
{
    const int n = 2000;
    const double h = 8.0 / n;
    double complex sum = 1.0;

    for (int i = 1; i <= n; i++) {
        const double s = i * h;
        sum += (i == n ? 1.0 : i % 2 ? 4.0 : 2.0) * cexp(-s * s - 2.0 * x * s);
    }
    return M_2_SQRTPI * sum * h / 3.0;
}

/* Slip over that at t = 0 of a sphere of the mass m that is thrown into a fluid
 * at rest, with Stokes' drag k, added mass m_a and history: of W = 1/(s + B
 * sqrt(s) + 1), t over (m + m_a)/k, B = pi d^2 (3/2) sqrt(rho mu)/sqrt((m +
 * m_a) k). With the mass m m_f/(m + m_f) it is the slip between spheres and a
 * fluid of the mass m_f each, alone in a box. */
static inline double orders_thrown(double rho, double mu, double d, double m,
                                   double m_a, double t)
{
    const double k = 3.0 * M_PI * mu * d;
    const double B = 1.5 * M_PI * d * d * sqrt(rho * mu) / sqrt((m + m_a) * k);
    const double complex root = csqrt(B * B - 4.0);
    const double complex z1 = 0.5 * (-B + root), z2 = 0.5 * (-B - root);
    const double r = sqrt(t * k / (m + m_a));

    return creal(
        (z1 * orders_scaled_erfc(-z1 * r) - z2 * orders_scaled_erfc(-z2 * r)) /
        (z1 - z2));
}

/* Spheres, one in each cell so that the fields are the same everywhere, thrown
 * with one velocity into a fluid at rest: the slip after two relaxation times
 * over that at first. Re of 1e-7: Stokes' drag to 1e-5. */
static inline double orders_relax(const struct scene *given, double ratio,
                                  int steps)
{
    struct scene s = *given;
    const double V = M_PI / 6.0 * gsl_pow_3(s.d), u = 1e-9;

    s.rho_s = ratio * s.rho;
    const double m = s.rho_s * V;
    const double m_f = gsl_pow_3(s.size) / s.n * s.rho - s.rho * V;
    const double m_r = s.one_way ? m : m * m_f / (m + m_f);
    const double T =
        2.0 * (m_r + s.virtual_mass * s.rho * V) / (3.0 * M_PI * s.mu * s.d);
    s.dt = T / steps;
    struct simulation *const sim = build(&s);
    struct particles *const ps = sim->particles;
    for (int i = 0; i < s.n; i++) {
        ps->vx[i] = u;
        ps->vy[i] = ps->vz[i] = 0.0;
    }
    memset(sim->fluid->u, 0, 3 * (size_t)sim->mesh->n_cells * sizeof(double));
    memset(sim->fluid->phi, 0, (size_t)sim->mesh->n_faces * sizeof(double));
    coupling_start(sim);
    run(sim, steps);
    const double slip = (ps->vx[0] - sim->fluid->u[0]) / u;
    const double exact = s.basset > 0.0
                             ? orders_thrown(s.rho, s.mu, s.d, m_r,
                                             s.virtual_mass * s.rho * V, T)
                             : exp(-2.0);
    discard(sim);
    return fabs(slip / exact - 1.0);
}

static inline struct scene orders_spheres(int two_way)
{
    struct scene s = orders_flight().s;

    s.n = 64;
    s.cells = 4;
    s.size = 6e-4;
    s.one_way = !two_way;
    s.rho = 1000.0;
    s.virtual_mass = 0.5;
    s.basset = 2e-5;
    return s;
}

static inline double orders_history(int steps)
{
    const struct scene s = orders_spheres(0);
    return orders_relax(&s, 2.65, steps);
}

static inline double orders_history_coupled(int steps)
{
    const struct scene s = orders_spheres(1);
    return orders_relax(&s, 0.3, steps);
}

static inline double orders_mass_coupled(int steps)
{
    struct scene s = orders_spheres(1);
    s.basset = 0.0;
    return orders_relax(&s, 2.65, steps);
}

/* --- lubrication ---------------------------------------------------------- */

/* Two spheres that approach in honey: dz/dt = -v, m* dv/dt = -c(z) v; the gap
 * they have left when they have lost half of their speed, over the exact one.
 * The step is that of the particles. */
static inline double orders_lubrication(int steps)
{
    const double d = 1e-3, mu = 0.1, z_min = 1e-6, z_out = 1e-4, T = 2e-4;
    const double numbers[] = {z_min, z_out};
    const struct attraction_scene scene = {.viscosity = mu};
    const struct attraction a =
        effect_named("lubrication")->attraction(numbers, &scene);
    struct dem_options o = spheres_options(&contact_linear, T / steps, 0.01);
    struct particles *const ps = particles_create(2);
    struct dem_report r;
    double z = z_out, v = 0.4, m;

    o.attractions = &a;
    o.n_attractions = 1;
    spheres_add(ps, 0.0, 0.0, 0.0, d);
    spheres_add(ps, d + z, 0.0, 0.0, d);
    ps->vx[0] = 0.5 * v;
    ps->vx[1] = -0.5 * v;
    m = 0.5 * ps->m[0];
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, steps, &r), 0);
    const int i = spheres_place(ps, 0), j = spheres_place(ps, 1);
    const double found = ps->x[j] - ps->x[i] - d;
    dem_free(dem);
    particles_free(ps);
    const int n = 20000;
    const double h = T / n;
    for (int k = 0; k < n; k++) { /* the midpoint rule */
        const double c = lubrication_coefficient(mu, 0.25 * d, z, z_min, z_out);
        const double z_m = z - 0.5 * h * v, v_m = v - 0.5 * h * c * v / m;
        z -= h * v_m;
        v -= h * lubrication_coefficient(mu, 0.25 * d, z_m, z_min, z_out) *
             v_m / m;
    }
    return fabs(found / z - 1.0);
}

/* --- all of them -----------------------------------------------------------
 */

static const struct {
    const char *what;
    double (*miss)(int steps);
    int steps; /* of the coarse run; the fine one has four times as many */
} orders_all[] = {
    {"drag", orders_drag, 20},
    {"pressure gradient", orders_pressure, 20},
    {"viscous stress", orders_stress, 20},
    {"virtual mass", orders_virtual_mass, 20},
    {"history", orders_history, 20},
    {"Saffman's lift", orders_saffman, 20},
    {"Magnus's lift", orders_magnus, 20},
    {"torque", orders_torque, 20},
    {"lubrication", orders_lubrication, 200},
    {"virtual mass, two-way", orders_mass_coupled, 20},
    {"history, two-way", orders_history_coupled, 20},
};
enum { ORDERS = sizeof orders_all / sizeof orders_all[0] };

#endif

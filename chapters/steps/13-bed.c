/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 13: the coupled bed.
 *
 * The grains of step 5 move in the air of step 12. In each step of the air
 *   1. averaging gives eps, the flux of the solids s = eps_s u_s, and the drag
 *      on the air per volume, f - K u with f = sum k u_p / V_c          (10.2)
 *   2. the air moves, and of air and grains div(q + s) = 0 (5.7) [XS11 2.7]
 *   3. the force on a grain is the drag k (u_f - u_p) (10.1), and the force of
 *      the pressure on its volume, -V_p grad p                           (5.3)
 *   4. the grains move, in many steps of their own, for contacts are short.
 * Both directions use the same weights, so that momentum is conserved (8.4).
 * Once the air carries the bed, the pressure drop varies about its weight. A
 * sieve at the outlet keeps the grains in the slot.
 *
 *     build/steps/13-bed [U=0.4] [end=2] [e=0.5] */
#include "steps.h"

enum { N = 300, W = 18, CELLS = W * 67 }; /* grains, cells: W in a row */
static int NX, NY;                        /* those without the ghosts */
static const double g = 9.81;             /* [m/s^2] gravity */
static const double k_n = 100.0;          /* [N/m] stiffness of the contact */
static const double k_t = 2.0 / 7.0 * 100.0; /* [N/m] along the floor */
static const double dt_s = 1e-5;             /* [s] step of the grains */
static double e = 0.9, zeta;                 /* [-] restitution, damping */
static double friction = 0.1;                /* [-] friction */
static double pressure = 1.0; /* 0: without its force on grains */
static double cells = 8, dx;  /* across, [m] width of a cell */
static const double box[2] = {16e-3, 64e-3}; /* [m] */
static const double side = 1.0;     /* 1: fluid slips along walls; -1: not */
static const double depth = 1.5e-3; /* [m] of the box, across */
static const double rho_f = 1.2;    /* [kg/m^3] */
static const double mu = 1.8e-5;    /* [Pa s] of air */
static const double D = 1.5e-5;     /* [m^2/s] mu / rho_f */
static const double d = 1.2e-3;     /* [m] grain */
static const double V_p = 9.04778684e-10; /* [m^3] its volume */
static double bw = 4.8e-3;                /* [m] bandwidth, b in (8.9) */
static double parts = 24;                 /* steps of the diffusion */
static double U = 1.0;                    /* [m/s] at the inlet */
static double upwind = 1.0;               /* 0: the mean of both cells */
static double sweeps = 60;                /* for the pressure, in a step */

/* One value a cell. The cell before it in direction k is c - next[k]. */
typedef double field[CELLS];
static const int next[2] = {1, W};
static field p, eps;     /* [Pa], [-] in the cell */
static field u[2], q[2]; /* [m/s] u_k on the lower face across k, eps u_k */
static field s[2], f[2]; /* [m/s], [N/m^3] of the grains, in a cell */
static field mob[2]; /* [m^3 s/kg] how q_k follows the slope of p; 0 at walls */
static field K;      /* [kg/(m^3 s)] drag on the air over its u, in a cell */
static double x[2][N + 1], v[2][N + 1], F[2][N + 1]; /* [m], [m/s], [N] */
static double R[N + 1], m[N + 1];                    /* [m], [kg] */
static double w[N + 1], M[N + 1];                    /* [rad/s], [N m] */
static double xi[N][N + 4]; /* [m] springs of pairs, and of four walls */
static double drag[N];      /* [kg/s] k in (10.1) */
static double sum_drop;     /* [Pa s] over the second half of the time */
static double P[2][N];      /* [N] force of the fluid */

const struct number numbers[] = {
    {"U", &U, 0.0, 2.5, 0.1, "air at the inlet [m/s]"},
    {"e", &e, 0.05, 1.0, 0.05, "restitution [-]"},
    {"friction", &friction, 0.0, 1.0, 0.05, "friction, mu in (2.8) [-]"},
    {"pressure", &pressure, 0.0, 1.0, 1.0, "force of the pressure [-]"},
    {"cells", &cells, 4, 12, 1, "cells across [-]"},
    {"bw", &bw, 0.0024, 9.6e-3, 0.0006, "bandwidth [m]"},
    {"parts", &parts, 12, 100, 1, "steps of the diffusion"},
    {"dt", &dt, 5e-5, 5e-4, 5e-5, "time step [s]"},
    {"end", &end, 0.02, 2.0, 0.06, "time at which it ends [s]"},
    {0}};
static double dt = 2e-4, end = 0.5; /* [s] */

void start(void)
{
    zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    NX = (int)cells;
    NY = (int)lround(NX * box[1] / box[0]);
    dx = box[0] / NX;
    for (int i = 0; i < N; i++) { /* rows of twelve */
        R[i] = 0.5 * d;
        m[i] = 1000.0 * V_p;
        x[0][i] = 1.28e-3 * (i % 12 + 0.5 + 0.5 * (i / 12 % 2));
        x[1][i] = 1.11e-3 * (i / 12 + 0.6);
    }
}

static int cell_of(int i) /* the cell of a grain */
{
    if (!(x[0][i] > 0.0 && x[0][i] < box[0] && x[1][i] > 0.0 &&
          x[1][i] < box[1]))
        stop("t = %g s: grain %d has left the box; try a shorter dt\n", t, i);
    return (int)(x[0][i] / dx) + 1 + W * ((int)(x[1][i] / dx) + 1);
}

/* The force of j on i, and the opposite; rx, ry [m] point from j to i. A wall
 * is a grain of the same radius that lies behind it and touches it. */
static void contact(int i, int j, double rx, double ry, double *xi_ij)
{
    const double r = sqrt(rx * rx + ry * ry), nx = rx / r, ny = ry / r;
    const double R_j = j < N ? R[j] : R[i], delta = R[i] + R_j - r; /* (2.1) */
    if (delta <= 0.0) *xi_ij = 0.0;
    if (delta <= 0.0) return;
    const double l_i = r * R[i] / (R[i] + R_j), l_j = r - l_i; /* (2.3) */
    const double m_star = j < N ? m[i] * m[j] / (m[i] + m[j]) : m[i];
    const double eta = 2.0 * zeta * sqrt(k_n * m_star), eta_t = 2.0 / 7.0 * eta;
    const double v_x = v[0][i] - v[0][j], v_y = v[1][i] - v[1][j];
    const double v_n = v_x * nx + v_y * ny; /* (2.2) */
    const double v_t = v_y * nx - v_x * ny - l_i * w[i] - l_j * w[j];
    const double F_n = k_n * delta - eta * v_n;
    *xi_ij += v_t * dt_s;
    double F_t = -k_t * *xi_ij - eta_t * v_t;
    if (fabs(F_t) > friction * fabs(F_n)) {
        F_t = copysign(friction * F_n, F_t);
        if (k_t * fabs(*xi_ij) > fabs(F_t)) *xi_ij = -F_t / k_t;
    }
    F[0][i] += F_n * nx - F_t * ny;
    F[0][j] -= F_n * nx - F_t * ny;
    F[1][i] += F_n * ny + F_t * nx;
    F[1][j] -= F_n * ny + F_t * nx;
    M[i] -= l_i * F_t;
    M[j] -= l_j * F_t;
}

/* Grain i is compared with the grains before it, which are in the grid, and is
 * then put there itself. So each pair is compared once. */
static void forces(void)
{
    static const int around[9] = {0,      -1, 1,     -W,   -W - 1,
                                  -W + 1, W,  W - 1, W + 1};
    int first[CELLS], next_one[N];
    memset(first, -1, sizeof first);
    memset(F, 0, sizeof F);
    memset(M, 0, sizeof M);
    for (int i = 0; i < N; i++) {
        const int c = cell_of(i);
        const double X = x[0][i], Y = x[1][i];
        for (int a = 0; a < 9; a++)
            for (int j = first[c + around[a]]; j >= 0; j = next_one[j])
                contact(i, j, X - x[0][j], Y - x[1][j], &xi[i][j]);
        next_one[i] = first[c];
        first[c] = i;
        contact(i, N, X + R[i], 0.0, &xi[i][N]);
        contact(i, N, X - R[i] - box[0], 0.0, &xi[i][N + 1]);
        contact(i, N, 0.0, Y + R[i], &xi[i][N + 2]);
        contact(i, N, 0.0, Y - R[i] - box[1], &xi[i][N + 3]);
    }
}

/* The ghost cells around the mesh take the values of the cells beside them. */
static void extend(field a)
{
    for (int i = 1; i <= NX; i++) {
        a[i] = a[i + W];
        a[i + W * (NY + 1)] = a[i + W * NY];
    }
    for (int j = 0; j <= NY + 1; j++) {
        a[W * j] = a[W * j + 1];
        a[W * j + NX + 1] = a[W * j + NX];
    }
}

/* (8.8) in small explicit steps: the sum over the cells stays what it is. */
static void diffuse(field a)
{
    const double ratio = 0.25 * bw * bw / ((int)parts * dx * dx);
    field old;
    for (int n = 0; n < (int)parts; n++) {
        extend(a);
        memcpy(old, a, sizeof old);
        for (int j = 1; j <= NY; j++)
            for (int c = W * j + 1; c <= W * j + NX; c++)
                a[c] += ratio * (old[c - 1] + old[c + 1] + old[c - W] +
                                 old[c + W] - 4.0 * old[c]);
    }
    extend(a);
}

/* The velocities on both sides of a wall. Air enters below, leaves above. */
static void walls(void)
{
    for (int i = 1; i <= NX; i++) {
        u[0][i] = side * u[0][i + W];
        u[0][i + W * (NY + 1)] = side * u[0][i + W * NY];
        q[1][i + W] = U * fmin((t + dt) / 0.05, 1.0);
        u[1][i + W] = q[1][i + W] / eps[i + W];
        u[1][i + W * (NY + 2)] = u[1][i + W * (NY + 1)];
        q[1][i + W * (NY + 2)] = q[1][i + W * (NY + 1)];
    }
    for (int j = 1; j <= NY + 1; j++) {
        u[1][W * j] = side * u[1][W * j + 1];
        u[1][W * j + NX + 1] = side * u[1][W * j + NX];
    }
}

/* What flows [m/s] through the lower face of a cell across k, along k, where
 * the velocity is V. */
static double flux(const field a, int c, int k, double V)
{
    const double below = a[c - next[k]], here = a[c];
    return 0.5 * V * (below + here) +
           (D / dx + 0.5 * upwind * fabs(V)) * (below - here);
}

/* What flows [m/s] through a lower face of the cell that has the face of u_k in
 * its middle: the mean of two. */
static double through(int k, field a[2], int c, int l)
{
    return 0.5 * (a[l][c] + a[l][c - next[k]]);
}

/* The flux of the velocity a[k] there, by the flow b. */
static double flux_of(int k, field a[2], field b[2], int c, int l)
{
    return flux(a[k], c, l, through(k, b, c, l));
}

/* 1 / eps on the lower face across k. */
static double inverse(int k, int c)
{
    return 0.5 / eps[c] + 0.5 / eps[c - next[k]];
}

/* The slope of p over q that inertia and drag of a cell need. Half of the way
 * through a face lies in each of its cells, and their mean is 1 / mob (6.6). */
static double slope(int c)
{
    return (rho_f / dt + K[c] / eps[c]) / eps[c];
}

/* [m/s] The flux of the solids through the lower face across k. */
static double solids(int k, int c)
{
    return 0.5 * (s[k][c] + s[k][c - next[k]]);
}

/* Predicts q without p; of air and grains together, until correct(). What the
 * air gains where it is squeezed out of a cell is not convected. */
static void predict(void)
{
    static field old[2], old_q[2];
    memcpy(old, u, sizeof u);
    memcpy(old_q, q, sizeof q);
    for (int k = 0; k < 2; k++)
        for (int j = 1 + k; j <= NY + k; j++)
            for (int c = W * j + 2 - k; c <= W * j + NX; c++) {
                const int b = c - next[k];
                for (int l = 0; l < 2; l++) {
                    const int n = c + next[l];
                    const double gain =
                        through(k, old_q, n, l) - through(k, old_q, c, l);
                    u[k][c] +=
                        dt / dx * inverse(k, c) *
                        (flux_of(k, old, old_q, c, l) -
                         flux_of(k, old, old_q, n, l) + gain * old[k][c]);
                }
                mob[k][c] = 2.0 / (slope(c) + slope(b));
                q[k][c] =
                    mob[k][c] * (rho_f / dt * u[k][c] +
                                 0.5 * (f[k][b] / eps[b] + f[k][c] / eps[c]));
                q[k][c] += solids(k, c);
            }
}

/* Successive over-relaxation: 1.7 times the change that solves the equation of
 * a cell. Where the mobility is 0, p has no effect; it is 0 beyond the outlet.
 */
static void find_pressure(void)
{
    for (int sweep = 0; sweep < (int)sweeps; sweep++)
        for (int j = 1; j <= NY; j++)
            for (int c = W * j + 1; c <= W * j + NX; c++) {
                double sum = 0.0, sum_mob = 0.0;
                for (int k = 0; k < 2; k++) {
                    const int n = c + next[k];
                    sum += mob[k][c] * p[c - next[k]] + mob[k][n] * p[n] -
                           dx * (q[k][n] - q[k][c]);
                    sum_mob += mob[k][c] + mob[k][n];
                }
                if (sum_mob > 0.0) p[c] += 1.7 * (sum / sum_mob - p[c]);
            }
}

static void correct(void)
{
    for (int k = 0; k < 2; k++)
        for (int c = W; c < W * (NY + 2); c++) {
            q[k][c] -= mob[k][c] * (p[c] - p[c - next[k]]) / dx;
            if (mob[k][c] > 0.0) q[k][c] -= solids(k, c);
            u[k][c] = q[k][c] * inverse(k, c);
        }
}

/* The velocity [m/s] of the fluid in a cell. */
static double in_cell(int k, int c)
{
    return 0.5 * (q[k][c] + q[k][c + next[k]]) / eps[c];
}

/* The same at the grains in a cell (8.3). */
static void gather(int k, field u_f)
{
    for (int j = 1; j <= NY; j++)
        for (int c = W * j + 1; c <= W * j + NX; c++)
            u_f[c] = in_cell(k, c);
    diffuse(u_f);
}

/* beta / eps_s [kg/(m^3 s)], drag over volume of the grain and slip. */
static double resistance(double eps_f, double slip)
{
    const double Re = rho_f * d * slip / mu, a = 0.06 * Re; /* (9.2) */
    const double A1 = power(eps_f, 4.14);                   /* (9.11) */
    const double A2 =
        eps_f <= 0.85 ? 0.8 * power(eps_f, 1.28) : power(eps_f, 2.65);
    const double V_r = /* (9.13) [XS11 2.13] */
        0.5 * (A1 - a + sqrt(a * a + 2.0 * a * (2.0 * A2 - A1) + A1 * A1));
    const double root = 0.63 * sqrt(slip) + 4.8 * sqrt(V_r * mu / (rho_f * d));
    return 0.75 * root * root * rho_f * eps_f / (V_r * V_r * d); /* (9.14) */
}

/* (8.6): each grain to the cell of its centre, then all is spread. */
static void average(void)
{
    const double V_c = dx * dx * depth;
    field eps_p, u_f[2];
    for (int c = 0; c < CELLS; c++)
        eps[c] = 1.0;
    memset(s, 0, sizeof s);
    for (int i = 0; i < N; i++) {
        eps[cell_of(i)] -= V_p / V_c;
        for (int k = 0; k < 2; k++)
            s[k][cell_of(i)] += V_p / V_c * v[k][i];
    }
    diffuse(eps);
    for (int c = 0; c < CELLS; c++)
        if (!(eps[c] > 0.0))
            stop("t = %g s: a cell has no air, eps = %.3f\n", t, eps[c]);
    memcpy(eps_p, eps, sizeof eps);
    diffuse(eps_p);
    memset(K, 0, sizeof K);
    memset(f, 0, sizeof f);
    for (int k = 0; k < 2; k++) {
        gather(k, u_f[k]);
        diffuse(s[k]);
    }
    for (int c = W * NY + 1; c <= W * NY + NX; c++)
        s[1][c + W] = -s[1][c]; /* no grain passes the sieve */
    for (int i = 0; i < N; i++) {
        const int c = cell_of(i);
        const double a = u_f[0][c] - v[0][i], b = u_f[1][c] - v[1][i];
        drag[i] = V_p * resistance(eps_p[c], sqrt(a * a + b * b));
        for (int k = 0; k < 2; k++)
            f[k][c] += drag[i] / V_c * v[k][i];
        K[c] += drag[i] / V_c;
    }
    diffuse(K);
    diffuse(f[0]);
    diffuse(f[1]);
}

/* Forces of the air on each grain. p is without the air's own weight, whose
 * buoyancy is added. */
static void forces_of_air(void)
{
    field u_f, grad;
    extend(p);
    for (int c = 1; c <= NX; c++) {
        p[c] = 2.0 * p[c + W] - p[c + 2 * W];
        p[c + W * (NY + 1)] = 0.0;
    }
    for (int k = 0; k < 2; k++) {
        gather(k, u_f);
        for (int j = 1; j <= NY; j++)
            for (int c = W * j + 1; c <= W * j + NX; c++)
                grad[c] = (p[c + next[k]] - p[c - next[k]]) / (2.0 * dx);
        diffuse(grad);
        for (int i = 0; i < N; i++)
            P[k][i] = drag[i] * (u_f[cell_of(i)] - v[k][i]) -
                      V_p * pressure * grad[cell_of(i)] + k * rho_f * V_p * g;
    }
}

/* v moves for a time, usually half a step. */
static void kick(double time)
{
    for (int i = 0; i < N; i++) {
        for (int k = 0; k < 2; k++)
            v[k][i] += ((F[k][i] + P[k][i]) / m[i] - k * g) * time;
        w[i] += M[i] / (0.4 * m[i] * R[i] * R[i]) * time;
    }
}

static void drift(void)
{
    for (int i = 0; i < N; i++)
        for (int k = 0; k < 2; k++)
            x[k][i] += v[k][i] * dt_s;
}

/* [Pa] The mean of p over row j of the cells. */
static double row(int j)
{
    double sum = 0.0;
    for (int c = W * j + 1; c <= W * j + NX; c++)
        sum += p[c] / NX;
    return sum;
}

void step(void)
{
    average();
    walls();
    predict();
    find_pressure();
    correct();
    forces_of_air();
    for (int n = 0; n < lround(dt / dt_s); n++) {
        kick(0.5 * dt_s);
        drift();
        forces();
        kick(0.5 * dt_s);
    }
    const double drop = 1.5 * row(1) - 0.5 * row(2);
    if (t + dt > 0.5 * end) sum_drop += drop * dt;
    point(t + dt, drop);
}

static double weight(void) /* [Pa] less buoyancy, over the ground */
{
    return N * (m[0] - rho_f * V_p) * g / (box[0] * depth);
}

void report(void)
{
    double height = 0.0;
    for (int i = 0; i < N; i++)
        height += x[1][i] / N;
    printf("mean pressure drop = %.4g Pa, weight over ground = %.4g Pa\n",
           sum_drop / (0.5 * end), weight());
    printf("t = %g s: mean height = %.4g m\n", t, height);
}

/* Darker cells have less air. */
void draw(void)
{
    window(box[0], box[1], "16 mm wide; the darker, the less air");
    for (int j = 1; j <= NY; j++)
        for (int i = 1; i <= NX; i++)
            put_square((i - 1) * dx, (j - 1) * dx, dx, 1.0 - eps[i + W * j]);
    for (int i = 0; i < N; i++)
        put_disc(x[0][i], x[1][i], R[i], INK, 0.0);
    plot("time [s]", "pressure drop [Pa]", weight());
    vtk_grains(N, x[0], x[1], R);
}

/* To try: U=0.4. Is the bed lifted? Then U=2: where are the grains? And leave
 * the force of the pressure out, pressure=0: which force has no reaction? */

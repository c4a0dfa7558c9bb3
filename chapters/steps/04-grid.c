/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 4: many grains and a grid of cells.
 *
 * 200 grains fall into a box. Each contact is that of step 3, and acts on both
 * partners with opposite forces (2.1)-(2.4), (2.8). Grains are put into cells
 * at least a diameter wide: one can only touch those of its own cell and of the
 * eight around it. To test all pairs would take long. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 200, NX = 16, NY = 20 }; /* grains, cells of the grid */
static const double pi = 3.14159265358979323846, g = 9.81; /* [m/s^2] */
static const double k = 100.0, k_t = 2.0 / 7.0 * 100.0;    /* [N/m] (2.10) */
static const double e = 0.7, mu = 0.2;         /* [-] restitution, friction */
static const double width = 1.5e-3, dt = 1e-5; /* [m] of a cell, [s] */
/* Entry N is the walls, which do not move. */
static double R[N + 1], m[N + 1], x[N + 1], y[N + 1], vx[N + 1], vy[N + 1];
static double w[N + 1], Fx[N + 1], Fy[N + 1], M[N + 1], zeta;
static double xi[N][N + 3]; /* [m] springs of pairs, and of three walls */
static int first[NX][NY], next[N], compared;

/* The force of j on i; dx, dy [m] point from j to i. A wall is a heavy grain of
 * the same radius that lies behind it and touches it. */
static void contact(int i, int j, double dx, double dy, double *xi_ij)
{
    const double r = sqrt(dx * dx + dy * dy), nx = dx / r, ny = dy / r;
    const double R_j = j < N ? R[j] : R[i], delta = R[i] + R_j - r; /* (2.1) */
    if (delta <= 0.0) *xi_ij = 0.0;
    if (delta <= 0.0) return;
    const double l_i = r * R[i] / (R[i] + R_j), l_j = r - l_i; /* (2.3) */
    const double m_star = j < N ? m[i] * m[j] / (m[i] + m[j]) : m[i];
    const double eta = 2.0 * zeta * sqrt(k * m_star), eta_t = 2.0 / 7.0 * eta;
    const double v_x = vx[i] - vx[j], v_y = vy[i] - vy[j];
    const double v_n = v_x * nx + v_y * ny; /* (2.2) */
    const double v_t = v_y * nx - v_x * ny - l_i * w[i] - l_j * w[j];
    const double F_n = k * delta - eta * v_n;
    *xi_ij += v_t * dt;
    double F_t = -k_t * *xi_ij - eta_t * v_t;
    if (fabs(F_t) > mu * fabs(F_n)) {
        F_t = copysign(mu * F_n, F_t);
        if (k_t * fabs(*xi_ij) > fabs(F_t)) *xi_ij = -F_t / k_t;
    }
    Fx[i] += F_n * nx - F_t * ny;
    Fx[j] -= F_n * nx - F_t * ny;
    Fy[i] += F_n * ny + F_t * nx;
    Fy[j] -= F_n * ny + F_t * nx;
    M[i] -= l_i * F_t;
    M[j] -= l_j * F_t;
}

/* Grain i is compared with the grains before it, which are in the grid, and is
 * then put there itself. So each pair is compared once. */
static void forces(void)
{
    compared = 0;
    for (int c = 0; c < NX * NY; c++)
        first[c % NX][c / NX] = -1;
    for (int i = 0; i <= N; i++)
        Fx[i] = Fy[i] = M[i] = 0.0;
    for (int i = 0; i < N; i++) {
        const int a = (int)(x[i] / width), b = (int)(y[i] / width);
        for (int c = a > 0 ? a - 1 : 0; c <= a + 1 && c < NX; c++)
            for (int d = b > 0 ? b - 1 : 0; d <= b + 1 && d < NY; d++)
                for (int j = first[c][d]; j >= 0; j = next[j], compared++)
                    contact(i, j, x[i] - x[j], y[i] - y[j], &xi[i][j]);
        next[i] = first[a][b];
        first[a][b] = i;
        contact(i, N, 0.0, y[i] + R[i], &xi[i][N]);
        contact(i, N, x[i] + R[i], 0.0, &xi[i][N + 1]);
        contact(i, N, x[i] - NX * width - R[i], 0.0, &xi[i][N + 2]);
    }
}

/* The half kick that ends a step and the one that begins the next are one. */
static void move(double kick)
{
    for (int i = 0; i < N; i++) {
        vx[i] += Fx[i] / m[i] * kick;
        vy[i] += (Fy[i] / m[i] - g) * kick;
        w[i] += M[i] / (0.4 * m[i] * R[i] * R[i]) * kick;
        x[i] += vx[i] * dt;
        y[i] += vy[i] * dt;
    }
}

static FILE *create(const char *program, const char *ending)
{
    char name[1000];
    snprintf(name, sizeof name, "%s%s", program, ending);
    FILE *const file = fopen(name, "w");
    if (file != NULL) return file;
    perror(name);
    exit(4);
}

static void write_vtk(FILE *file)
{
    fprintf(file, "# vtk DataFile Version 3.0\ngrains\nASCII\n");
    fprintf(file, "DATASET POLYDATA\nPOINTS %d double\n", N);
    for (int i = 0; i < N; i++)
        fprintf(file, "%.17g %.17g 0\n", x[i], y[i]);
    fprintf(file, "POINT_DATA %d\nSCALARS d double\nLOOKUP_TABLE default\n", N);
    for (int i = 0; i < N; i++)
        fprintf(file, "%.17g\n", 2.0 * R[i]);
    fclose(file);
}

/* The box in millimetres; darker grains are faster, up to 0.4 m/s. */
static void write_svg(FILE *file)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='500' "
                  "viewBox='-1 -31 26 33' stroke='black' stroke-width='0.1' "
                  "fill='#1f5fa8'>\n<path d='M0-30V0H24V-30' fill='none'/>\n"
                  "<text y='1.5' font-size='1.3' stroke='none'>24 mm</text>\n");
    for (int i = 0; i < N; i++)
        fprintf(file,
                "<circle cx='%.2f' cy='%.2f' r='%.2f' fill-opacity='%.2f'/>\n",
                1e3 * x[i], -1e3 * y[i], 1e3 * R[i],
                0.2 + 2.0 * hypot(vx[i], vy[i]));
    fprintf(file, "</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.05;
    double height = 0.0;
    zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    for (int i = 0; i < N; i++) {
        R[i] = 0.5e-3 + 0.2e-3 * rand() / RAND_MAX;
        m[i] = 1000.0 * 4.0 / 3.0 * pi * R[i] * R[i] * R[i];
        x[i] = 1.65e-3 * (i % 14 + 0.6 + 0.4 * (i / 14 % 2));
        y[i] = 1.65e-3 * (i / 14 + 2.8);
    }
    for (int step = 0; step < lround(t_end / dt); step++) {
        forces();
        move(step == 0 ? 0.5 * dt : dt);
    }
    for (int i = 0; i < N; i++)
        height += y[i] / N;
    printf("t = %g s: compared %d of %d pairs, mean height = %.9g m\n", t_end,
           compared, N * (N - 1) / 2, height);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: cells twice as wide (width 3e-3, NX 8, NY 10). Which number changes,
 * which does not? And in cells of half the width (0.75e-3, 32, 40)? */

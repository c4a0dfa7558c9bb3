/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 5: a heap.
 *
 * A column of grains collapses on a row of grains that do not move. The springs
 * along the contacts (2.8) store the slip of the grains, and so a heap remains.
 * The slope of a triangle is its mean height over the mean distance from its
 * middle. At rest the floor bears the weight. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { N = 246, FLOOR = 56, NX = 50, NY = 16 }; /* grains, cells of the grid */
static const double pi = 3.14159265358979323846, g = 9.81; /* [m/s^2] */
static const double k = 100.0, k_t = 2.0 / 7.0 * 100.0;    /* [N/m] (2.10) */
static const double e = 0.7;                               /* [-] restitution */
static const double width = 1.5e-3, dt = 1e-5; /* [m] of a cell, [s] */
/* Entry N is the walls, the first grains are the floor: they do not move. */
static double R[N + 1], m[N + 1], x[N + 1], y[N + 1], vx[N + 1], vy[N + 1];
static double w[N + 1], Fx[N + 1], Fy[N + 1], M[N + 1], zeta, mu;
static double xi[N][N + 3]; /* [m] springs of pairs, and of three walls */
static int first[NX][NY], next[N];

/* As in step 4. */
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

/* As in step 4. */
static void forces(void)
{
    for (int c = 0; c < NX * NY; c++)
        first[c % NX][c / NX] = -1;
    for (int i = 0; i <= N; i++)
        Fx[i] = Fy[i] = M[i] = 0.0;
    for (int i = 0; i < N; i++) {
        const int a = (int)(x[i] / width), b = (int)(y[i] / width);
        for (int c = a > 0 ? a - 1 : 0; c <= a + 1 && c < NX; c++)
            for (int d = b > 0 ? b - 1 : 0; d <= b + 1 && d < NY; d++)
                for (int j = first[c][d]; j >= 0; j = next[j])
                    contact(i, j, x[i] - x[j], y[i] - y[j], &xi[i][j]);
        next[i] = first[a][b];
        first[a][b] = i;
        contact(i, N, 0.0, y[i] + R[i], &xi[i][N]);
        contact(i, N, x[i] + R[i], 0.0, &xi[i][N + 1]);
        contact(i, N, x[i] - NX * width - R[i], 0.0, &xi[i][N + 2]);
    }
}

static void move(double kick)
{
    for (int i = FLOOR; i < N; i++) {
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

/* In millimetres; the floor is dark. */
static void write_svg(FILE *file)
{
    fprintf(file, "<svg xmlns='http://www.w3.org/2000/svg' width='900' "
                  "viewBox='0 -15 75 16' stroke='black' stroke-width='0.1'>\n"
                  "<text x='58' y='-13' font-size='2'>width 75 mm</text>\n");
    for (int i = 0; i < N; i++)
        fprintf(file, "<circle cx='%.2f' cy='%.2f' r='%.2f' fill='%s'/>\n",
                1e3 * x[i], -1e3 * y[i], 1e3 * R[i],
                i < FLOOR ? "#555" : "#cfe0f3");
    fprintf(file, "</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 0.5;
    double weight = 0.0, borne = 0.0, height = 0.0, distance = 0.0;
    mu = argc > 2 ? atof(argv[2]) : 0.5;
    zeta = -log(e) / sqrt(pi * pi + log(e) * log(e));
    for (int i = 0; i < N; i++) {
        const int a = i - FLOOR, row = a / 16; /* in the column */
        R[i] = 0.5e-3 + 0.2e-3 * rand() / RAND_MAX;
        m[i] = 1000.0 * 4.0 / 3.0 * pi * R[i] * R[i] * R[i];
        x[i] = a < 0 ? 1.33e-3 * (i + 0.5)
                     : 1.45e-3 * (a % 16 + 18 + 0.4 * (row % 2));
        y[i] = a < 0 ? 0.7e-3 : 1.45e-3 * (row + 1.5);
    }
    for (int step = 0; step < lround(t_end / dt); step++) {
        forces();
        move(step == 0 ? 0.5 * dt : dt);
    }
    for (int i = 0; i < N; i++) {
        borne -= i < FLOOR ? Fy[i] : 0.0;
        weight += i < FLOOR ? 0.0 : m[i] * g;
        height += i < FLOOR ? 0.0 : y[i] - 1.2e-3;
        distance += i < FLOOR ? 0.0 : fabs(x[i] - 37.5e-3);
    }
    printf("angle = %.1f degrees\n", 180.0 / pi * atan(height / distance));
    printf("the floor bears %.5g N, weight = %.5g N\n", borne, weight);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: 05-heap 0.5 0 has no friction. Which slope is left, and why any? */

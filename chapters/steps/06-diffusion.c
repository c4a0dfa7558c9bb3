/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 6: diffusion.
 *
 * A puff of smoke spreads in air at rest. Space is now a mesh of cells, each
 * with one value c, and between two neighbours smoke flows from more to less:
 *
 *     dc/dt = D laplacian c                                    [SX15 5a, 5c]
 *
 * What leaves a cell enters its neighbour, and nothing leaves through a wall,
 * so the sum over the cells is constant. After the time t one full cell
 * has become a Gaussian of the bandwidth b = sqrt(4 D t) (8.9) [SX15 6], and
 * the mean square distance from its middle has grown by 4 D t.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NX = 41, NY = 41, I = NX / 2, J = NY / 2 }; /* cells, and the full one */

static const double pi = 3.14159265358979323846;
static const double D = 1.5e-5; /* [m^2/s] diffusivity */
static const double dx = 2e-3;  /* [m] width of a cell */
static const double dt = 0.02;  /* [s]; below dx^2 / (4 D), or it oscillates */

static double c[NX][NY]; /* [-] */

/* The flux [m/s] through the face between two neighbours, from a to b. */
static double flux(double c_a, double c_b)
{
    return D * (c_a - c_b) / dx;
}

static void step(void)
{
    static double gain[NX][NY]; /* [m/s] */

    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++)
            gain[i][j] = 0.0;
    for (int i = 1; i < NX; i++) /* the faces across x */
        for (int j = 0; j < NY; j++) {
            const double f = flux(c[i - 1][j], c[i][j]);
            gain[i - 1][j] -= f;
            gain[i][j] += f;
        }
    for (int i = 0; i < NX; i++) /* the faces across y */
        for (int j = 1; j < NY; j++) {
            const double f = flux(c[i][j - 1], c[i][j]);
            gain[i][j - 1] -= f;
            gain[i][j] += f;
        }
    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++)
            c[i][j] += dt / dx * gain[i][j];
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
    fprintf(file, "# vtk DataFile Version 3.0\nsmoke\nASCII\n");
    fprintf(file, "DATASET STRUCTURED_POINTS\nDIMENSIONS %d %d 1\n", NX + 1,
            NY + 1);
    fprintf(file, "ORIGIN 0 0 0\nSPACING %g %g 1\n", dx, dx);
    fprintf(file, "CELL_DATA %d\nSCALARS c double\nLOOKUP_TABLE default\n",
            NX * NY);
    for (int j = 0; j < NY; j++)
        for (int i = 0; i < NX; i++)
            fprintf(file, "%.9g\n", c[i][j]);
    fclose(file);
}

/* A square for each cell, 10 points wide; the fullest is black. */
static void write_svg(FILE *file)
{
    double top = 0.0;

    for (int i = 0; i < NX * NY; i++)
        top = fmax(top, c[i % NX][i / NX]);
    fprintf(file,
            "<svg xmlns='http://www.w3.org/2000/svg' width='%d' height='%d'>\n"
            "<text x='5' y='%d'>width %g mm; white: c = 0, black: c = "
            "%.2g</text>\n",
            10 * NX, 10 * NY + 24, 10 * NY + 18, 1e3 * NX * dx, top);
    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++) {
            const int grey = (int)(255.0 * (1.0 - c[i][j] / top));
            fprintf(file,
                    "<rect x='%d' y='%d' width='10.5' height='10.5' "
                    "fill='rgb(%d,%d,%d)'/>\n",
                    10 * i, 10 * (NY - 1 - j), grey, grey, grey);
        }
    fprintf(file, "</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 2.0;
    const double b = sqrt(4.0 * D * t_end);
    double sum = 0.0, square = 0.0;

    c[I][J] = 1.0;
    for (int n = 0; n < lround(t_end / dt); n++)
        step();
    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++) {
            const double x = (i - I) * dx, y = (j - J) * dx;
            sum += c[i][j];
            square += c[i][j] * (x * x + y * y);
        }
    printf("t = %g s: sum = %.12g\n", t_end, sum);
    printf("mean square distance = %.6g m^2, exact %.6g\n", square / sum,
           4.0 * D * t_end);
    printf("highest value = %.5g, Gaussian %.5g with b = %.6g m\n", c[I][J],
           dx * dx / (pi * b * b), b);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"));
    return 0;
}

/* To try: let dt be 0.07 s. Why does the chessboard appear, and why is its
 * limit dx^2 / (4 D)? Put the puff into a corner, I = 0 and J = 0: by which
 * factor is the highest value larger, and why? */

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Step 7: advection.
 *
 * The air of step 6 moves, and convects the smoke:
 *
 *     dc/dt + div(u c) = D laplacian c                                [LS 3.13]
 *
 * The velocity is known at the faces: its normal component there is the volume
 * that passes, per area. Which c does the flux have? That of the cell which it
 * comes from: s of (5.9) is 1 or 0, upwind. It never overshoots, but it
 * smears: the mean square distance along x grows not by 2 D t alone but by
 * u dx (1 - u dt / dx) t more. The middle moves by u t.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { NX = 41, NY = 41 }; /* cells */

static const double D = 1.5e-5;          /* [m^2/s] diffusivity */
static const double U = 0.03, V = 0.015; /* [m/s] wind along x and y */
static const double dx = 2e-3;           /* [m] width of a cell */
static const double dt = 0.02;           /* [s] */

static double c[NX][NY];                      /* [-] */
static double ux[NX + 1][NY], uy[NX][NY + 1]; /* [m/s] at left, lower faces */

/* The flux [m/s] through the face between two neighbours, from a to b. */
static double flux(double u, double c_a, double c_b)
{
    return u * (u > 0.0 ? c_a : c_b) + D * (c_a - c_b) / dx;
}

static void step(void)
{
    static double gain[NX][NY]; /* [m/s] */

    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++)
            gain[i][j] = 0.0;
    for (int i = 1; i < NX; i++) /* the faces across x */
        for (int j = 0; j < NY; j++) {
            const double f = flux(ux[i][j], c[i - 1][j], c[i][j]);
            gain[i - 1][j] -= f;
            gain[i][j] += f;
        }
    for (int i = 0; i < NX; i++) /* the faces across y */
        for (int j = 1; j < NY; j++) {
            const double f = flux(uy[i][j], c[i][j - 1], c[i][j]);
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

/* A square for each cell, 10 points wide; the fullest is black. The circle is
 * where the middle should be, with the bandwidth of diffusion alone. */
static void write_svg(FILE *file, double t)
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
    fprintf(file,
            "<circle cx='%.1f' cy='%.1f' r='%.1f' fill='none' stroke='red'/>\n",
            10.0 * (NX / 4 + 0.5 + U * t / dx),
            10.0 * (NY - NY / 3 - 0.5 - V * t / dx),
            10.0 * sqrt(4.0 * D * t) / dx);
    fprintf(file, "</svg>\n");
    fclose(file);
}

int main(int argc, char **argv)
{
    const double t_end = argc > 1 ? atof(argv[1]) : 1.0;
    double sum = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0;

    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++) {
            ux[i][j] = i > 0 ? U : 0.0; /* nothing passes a wall */
            uy[i][j] = j > 0 ? V : 0.0;
        }
    c[NX / 4][NY / 3] = 1.0;
    for (int n = 0; n < lround(t_end / dt); n++)
        step();
    for (int i = 0; i < NX; i++)
        for (int j = 0; j < NY; j++) {
            sum += c[i][j];
            x += c[i][j] * (i - NX / 4) * dx;
            y += c[i][j] * (j - NY / 3) * dx;
            xx += c[i][j] * pow((i - NX / 4) * dx, 2);
            yy += c[i][j] * pow((j - NY / 3) * dx, 2);
        }
    printf("t = %g s: sum = %.12g\n", t_end, sum);
    printf("the middle moved by %.6g, %.6g m, exact %.6g, %.6g\n", x, y,
           U * t_end, V * t_end);
    printf("mean square along x = %.6g m^2, exact for upwind %.6g\n",
           xx - x * x, (2.0 * D + U * (dx - U * dt)) * t_end);
    printf("mean square along y = %.6g m^2, exact for upwind %.6g\n",
           yy - y * y, (2.0 * D + V * (dx - V * dt)) * t_end);
    printf("without the smearing of upwind: %.6g m^2\n", 2.0 * D * t_end);
    write_vtk(create(argv[0], ".vtk"));
    write_svg(create(argv[0], ".svg"), t_end);
    return 0;
}

/* To try: let the face carry the mean of the two cells, the linear scheme with
 * s = 1/2. Is the mean square right now? (An explicit step takes u^2 dt t away
 * from it.) Then take D = 0 with both schemes. Which results are impossible? */

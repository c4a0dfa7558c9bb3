/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The planes x = a, y = b, z = c cut off a corner of the ball. With the centre
 * as origin the divergence of the place is 3, and so the volume is a third of
 * the area of the part of the sphere, less a third of a times the area of the
 * part of the plane x = a, and so on. The area on the sphere is what the
 * theorem of Gauss and Bonnet leaves of 2 pi: the angles at the corners, and
 * the bend of the circles between them.
 *
 * All angles are taken as atan2 of lengths that come from one root: where the
 * sphere nearly touches an edge and terms cancel, their errors then cancel,
 * too.
 */
#include "averaging/more/overlap.h"

#include <gsl/gsl_math.h>

/* Volume of the part x > a of the unit ball: a cap. */
static double cap(double a)
{
    const double h = 1.0 - a; /* height */

    if (a <= -1.0) return 4.0 / 3.0 * M_PI;
    return a < 1.0 ? M_PI / 3.0 * h * h * (3.0 - h) : 0.0;
}

/* The part x > a, y > b. */
static double wedge(double a, double b)
{
    if (a >= 1.0 || b >= 1.0) return 0.0;
    if (a <= -1.0) return cap(b);
    if (b <= -1.0) return cap(a);
    if (a < 0.0) return cap(b) - wedge(-a, b); /* complement of x < a */
    if (b < 0.0) return cap(a) - wedge(a, -b);
    const double w2 = 1.0 - a * a - b * b;
    if (w2 <= 0.0) return 0.0;
    const double w = sqrt(w2); /* the edge ends at z = w and -w */
    const double angle = atan2(w, a * b);
    const double arc_a = 2.0 * atan2(w, b); /* of the circle x = a */
    const double arc_b = 2.0 * atan2(w, a);
    return 2.0 / 3.0 * (angle + a * b * w) -
           0.5 * (a * (1.0 - a * a / 3.0) * arc_a +
                  b * (1.0 - b * b / 3.0) * arc_b);
}

/* The part x > a, y > b, z > c with all three from 0 on and the corner within
 * the ball. */
static double corner(double a, double b, double c)
{
    const double u = sqrt(1.0 - b * b - c * c); /* ends of the three edges */
    const double v = sqrt(1.0 - c * c - a * a);
    const double w = sqrt(1.0 - a * a - b * b);
    const double angles = atan2(u, b * c) + atan2(v, c * a) + atan2(w, a * b);
    const double arc_a = atan2(w, b) - atan2(c, v);
    const double arc_b = atan2(u, c) - atan2(a, w);
    const double arc_c = atan2(v, a) - atan2(b, u);

    return (angles - M_PI + b * c * u + c * a * v + a * b * w) / 3.0 -
           a * b * c -
           0.5 * (a * (1.0 - a * a / 3.0) * arc_a +
                  b * (1.0 - b * b / 3.0) * arc_b +
                  c * (1.0 - c * c / 3.0) * arc_c);
}

double overlap_octant(double a, double b, double c)
{
    if (a >= 1.0 || b >= 1.0 || c >= 1.0) return 0.0;
    if (a <= -1.0) return wedge(b, c);
    if (b <= -1.0) return wedge(c, a);
    if (c <= -1.0) return wedge(a, b);
    if (a < 0.0) return wedge(b, c) - overlap_octant(-a, b, c);
    if (b < 0.0) return wedge(c, a) - overlap_octant(a, -b, c);
    if (c < 0.0) return wedge(a, b) - overlap_octant(a, b, -c);
    return a * a + b * b + c * c < 1.0 ? corner(a, b, c) : 0.0;
}

/* Distance of the nearest and of the farthest point of the box, squared. */
static void distances(const double lo[3], const double hi[3], double *nearest,
                      double *farthest)
{
    *nearest = *farthest = 0.0;
    for (int k = 0; k < 3; k++) {
        const double beside = fmax(0.0, fmax(lo[k], -hi[k]));
        const double end = fmax(fabs(lo[k]), fabs(hi[k]));
        *nearest += beside * beside;
        *farthest += end * end;
    }
}

double overlap_sphere(double R, const double lo[3], const double hi[3])
{
    double nearest, farthest, sum = 0.0;

    distances(lo, hi, &nearest, &farthest);
    if (nearest >= R * R) return 0.0;
    if (farthest <= R * R)
        return (hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]);
    for (int k = 0; k < 8; k++) {
        const int far = (k & 1) + (k >> 1 & 1) + (k >> 2 & 1);
        const double part = overlap_octant((k & 1 ? hi[0] : lo[0]) / R,
                                           (k & 2 ? hi[1] : lo[1]) / R,
                                           (k & 4 ? hi[2] : lo[2]) / R);
        sum += far % 2 ? -part : part;
    }
    return fmax(0.0, sum) * R * R * R; /* rounding of 1e-16 around nothing */
}

double overlap_cube(double R, const double lo[3], const double hi[3])
{
    double volume = 1.0;

    for (int k = 0; k < 3; k++)
        volume *= fmax(0.0, fmin(hi[k], R) - fmax(lo[k], -R));
    return volume;
}

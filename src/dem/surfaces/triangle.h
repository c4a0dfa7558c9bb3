/* triangle.h -- a point and a triangle.  Chapter "Walls". */
#ifndef DEM_SURFACES_TRIANGLE_H
#define DEM_SURFACES_TRIANGLE_H

/* The point q of the triangle that is nearest to y [m]. The triangle has an
 * area. */
void triangle_nearest(const double corner[3][3], const double y[3],
                      double q[3]);

/* Unit normal, by the right hand from corner to corner; 0 if it has no area. */
void triangle_normal(const double corner[3][3], double n[3]);

/* 1 if the way from a to b leads through the triangle; a way that begins or
 * ends on it does not. */
int triangle_crossed(const double corner[3][3], const double a[3],
                     const double b[3]);

#endif

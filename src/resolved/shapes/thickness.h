/* thickness.h -- how thin a body of triangles is.
 * Chapter "Resolving the grains".
 *
 * At a point of the surface the body is as thick as the way along the inward
 * normal until it leaves the body.
 */
#ifndef RESOLVED_SHAPES_THICKNESS_H
#define RESOLVED_SHAPES_THICKNESS_H

/* A tenth of the surface is where the body is thinner than this [m]. The
 * triangles have areas, their normals point outward. */
double thickness_of(int n, double (*corner)[3][3]);

#endif

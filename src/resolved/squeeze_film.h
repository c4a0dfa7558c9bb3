/* squeeze_film.h -- the fluid that is squeezed out of gaps narrower than a
 * cell. Chapter "Resolving the grains".
 *
 * Between two surfaces at the distance z, 0 < z < reach, that part at the speed
 * g (negative: approach),
 *
 *   F = -6 pi mu R*^2 (1/max(z, z_min) - 1/reach) g,  R* = R_1 R_2/(R_1 + R_2)
 *
 * [Cox67], at a wall R* = R. The second term takes away what the mesh resolves,
 * so that the force begins at 0 [BVM17]. There it begins at two cells; with
 * friction by distance the mesh has nine tenths of the force at a gap of one
 * cell, and what it has grows no more below three quarters. z_min is the
 * roughness of the surfaces, at which they touch.
 */
#ifndef RESOLVED_SQUEEZE_FILM_H
#define RESOLVED_SQUEEZE_FILM_H

#include "resolved/solid_bodies.h"

/* reach over the width of a cell [-]. */
extern const double squeeze_film_cells;

/* F / -g [kg/s]. */
double squeeze_film_coefficient(double mu, double R_star, double z,
                                double z_min, double reach);

/* The speed [m/s] of parting after dt [s] of two bodies of the reduced mass m
 * [kg] that part at g and are z [m] apart. */
double squeeze_film_velocity(const struct squeeze_film *l, double R_star,
                             double m, double z, double g, double dt);

/* Changes the velocities of all bodies by the forces of a time dt [s]. */
void squeeze_film_act(struct solid_bodies *b, double dt);

#endif

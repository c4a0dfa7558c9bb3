/* bodies_record.h -- what is written of the bodies.
 *
 * bodies.csv: with each row of history.csv a row for each body, its place,
 * velocity, spin, and the force and torque of the fluid in the last step; and
 * the quaternion of its orientation, if one of them is a clump or a surface.
 * bodies.pvd: the same, to look at. Sums in history.csv.
 */
#ifndef RECORD_BODIES_RECORD_H
#define RECORD_BODIES_RECORD_H

#include "record/recorder_part.h"
#include "resolved/solid_bodies.h"

/* The bodies of a simulation, alone or among particles; NULL: none. */
const struct solid_bodies *bodies_record_of(const struct simulation *sim);

extern const struct recorder_part bodies_record;

#endif

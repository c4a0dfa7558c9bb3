/* bodies_record.h -- what is written of the bodies.
 *
 * bodies.csv: with each row of history.csv a row for each body, its place,
 * velocity, spin, and the force and torque of the fluid in the last step.
 * bodies.pvd: the same, to look at. Sums in history.csv.
 */
#ifndef CASE_RESOLVED_BODIES_RECORD_H
#define CASE_RESOLVED_BODIES_RECORD_H

#include "case/recorder_part.h"

extern const struct recorder_part bodies_record;

#endif

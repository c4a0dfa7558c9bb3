/* bodies_record.h -- what is written of the bodies.
 *
 * bodies.csv: with each row of history.csv a row for each body, its place,
 * velocity, spin, and the force and torque of the fluid in the last step.
 * bodies.pvd: the same, to look at. Sums in history.csv.
 */
#ifndef CASE_RESOLVED_BODIES_RECORD_H
#define CASE_RESOLVED_BODIES_RECORD_H

#include "case/history.h"
#include "output/folder.h"
#include "output/summary.h"

extern const struct history_column bodies_record_columns[];

/* The functions of struct case_part. */
void *bodies_record_create(const struct simulation *sim, struct folder *folder);
void bodies_record_free(void *record);
int bodies_record_add_row(void *record);
int bodies_record_add_fields(void *record, double t);
void bodies_record_summarize(const void *record, struct summary *f);
void bodies_record_print(const void *record);

#endif

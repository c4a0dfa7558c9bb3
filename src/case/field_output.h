/* field_output.h -- the files that ParaView shows, written from a snapshot. */
#ifndef CASE_FIELD_OUTPUT_H
#define CASE_FIELD_OUTPUT_H

#include "coupling/simulation.h"
#include "output/folder.h"
#include "case/snapshot.h"

struct field_output;
struct outline;

/* The collections of the phases that there are; NULL after a message. */
struct field_output *field_output_create(const struct simulation *sim,
                                         struct folder *folder);
void field_output_free(struct field_output *p);

/* Non-zero after a message. */
int field_output_add(struct field_output *p, const struct snapshot *s);

/* The time of the last one [s]; -1 before the first. */
double field_output_last(const struct field_output *p);

/* The surfaces as last written; NULL if there are none. */
const struct outline *field_output_walls(const struct field_output *p);

#endif

/* probes.h -- the sensors that a case puts into the box. */
#ifndef CASE_PROBES_H
#define CASE_PROBES_H

#include "output/folder.h"
#include "case/settings.h"
#include "case/snapshot.h"

struct probes;

/* One column of DIR/probes.csv for each group of output.probes, whose points
 * validate.c has found to be inside; no file if there is none. NULL after a
 * message. The snapshot is what they read. */
struct probes *probes_create(const struct settings *s,
                             const struct simulation *sim,
                             const struct snapshot *snapshot,
                             struct folder *folder);
void probes_free(struct probes *p);

/* The rows so far (state.h). */
void probes_state(struct probes *p, struct state *s);

/* A row for the snapshot as it is now; non-zero after a message. */
int probes_add(struct probes *p);

#endif

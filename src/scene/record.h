/* record.h -- everything that a run writes.
 *
 * DIR/history.csv and DIR/probes.csv a row at a time, DIR/fluid.pvd and
 * DIR/particles.pvd with their files a picture at a time, DIR/profiles/ at the
 * end, DIR/summary.json at the beginning and at the end.
 */
#ifndef RECORD_H
#define RECORD_H

#include "exchange/simulation.h"
#include "output/folder.h"
#include "scene/settings.h"

struct record;

/* Begins anew in the folder: first a summary that says "running", then what is
 * written from the start. NULL after a message: the folder cannot be written.
 * Simulation and folder are borrowed. */
struct record *record_create(const struct settings *s,
                             const struct simulation *sim,
                             struct folder *folder);
void record_free(struct record *r);

/* Looks at the simulation at its present time: adds to the profiles, and does
 * what is due of the history and the pictures. Non-zero after a message if
 * writing failed. */
int record_look(struct record *r);

/* The last good state, in a picture of its own if it has none yet. */
int record_last_state(struct record *r);

/* How the summary of a run that could not write says so. */
#define RECORD_NOT_WRITTEN "output could not be written"
enum { RECORD_NOT_WRITTEN_CODE = 4 };

/* Profiles, picture and summary; reason: "done", "interrupted", what broke
 * down. Non-zero after a message. */
int record_finish(struct record *r, const char *reason, int exit_code);

/* What it all amounts to, on stdout. */
void record_report(const struct record *r);

#endif

/* recorder.h -- the recorder: all output of a run.
 *
 * It writes DIR/history.csv and DIR/probes.csv row by row, DIR/fluid.pvd and
 * DIR/particles.pvd with their files picture by picture, DIR/profiles/ at the
 * end, and DIR/summary.json at the beginning and at the end.
 */
#ifndef RECORD_RECORDER_H
#define RECORD_RECORDER_H

#include "record/recorder_part.h"

struct recorder;

/* Begins anew in the folder, or, to resume a run, opens what is there. NULL
 * after a message: the folder cannot be written. Simulation and folder are
 * borrowed. */
struct recorder *recorder_create(const struct recording *of,
                                 const struct simulation *sim,
                                 struct folder *folder, int resume);
void recorder_free(struct recorder *r);

/* All that was written and summed up so far (state.h): what was written later
 * is cut off. */
void recorder_state(struct recorder *r, struct state *s);

/* Writes a summary that says "running"; non-zero after a message. */
int recorder_begin(const struct recorder *r);

/* Samples the simulation at its present time: adds to the profiles, and writes
 * the rows and field files that are due. Non-zero after a message if writing
 * failed. */
int recorder_sample(struct recorder *r);

/* Writes the state at the end as a row, if no row is due there. It is called
 * after the state has been saved, because a run that is continued to a later
 * end has no such row. The row does not count in means over the run, because it
 * stands for a shorter time than the others. A simulation of several processes
 * has none. */
int recorder_last_row(struct recorder *r);

/* Writes the last good state as a picture, if it has none yet. */
int recorder_last_state(struct recorder *r);

/* How the summary of a run that could not write says so. */
#define RECORDER_NOT_WRITTEN "output could not be written"
enum { RECORDER_NOT_WRITTEN_CODE = 4 };

/* Writes profiles, picture and summary; reason: "done", "interrupted", or what
 * broke down. Non-zero after a message. */
int recorder_finish(struct recorder *r, const char *reason, int exit_code);

/* Prints a summary on stdout. */
void recorder_print(const struct recorder *r);

/* --- progress: messages of a run.
 *
 * On a terminal one line that is drawn over and over, a bar with the simulated
 * time and the time left; elsewhere a line at every tenth; quiet: nothing. All
 * of it on stderr. */

enum progress_style { PROGRESS_QUIET, PROGRESS_LINES, PROGRESS_BAR };

enum { PROGRESS_TEXT = 128 };

struct progress {
    enum progress_style style;
    double first, end; /* [s] simulated time at the beginning and at the end */
    double began;      /* [s] wall clock */
    double drawn;      /* [s] wall clock of the last drawing of the bar */
    int tenths;        /* [-] lines: tenths reported so far */
};

/* Begins now, at simulated time `first`. The style follows from whether stderr
 * is a terminal, unless quiet. */
void progress_init(struct progress *p, double first, double end, int quiet);

/* To be called after each step, at simulated time t; draws when it is due. */
void progress_show(struct progress *p, double t);

/* Ends the line of the bar, so that a message may follow. */
void progress_end(struct progress *p);

/* The line for simulated time t after `elapsed` seconds of wall clock. */
void progress_line(const struct progress *p, double t, double elapsed,
                   char text[PROGRESS_TEXT]);

#endif

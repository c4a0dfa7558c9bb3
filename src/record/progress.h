/* progress.h -- progress messages of a run.
 *
 * On a terminal one line that is drawn over and over, a bar with the simulated
 * time and the time left; elsewhere a line at every tenth; quiet: nothing. All
 * of it on stderr.
 */
#ifndef RECORD_PROGRESS_H
#define RECORD_PROGRESS_H

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

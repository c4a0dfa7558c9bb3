/* gnuplot.h -- runs a gnuplot script.
 *
 * gnuplot takes "<name" and "|name" for commands to be run by a shell, wherever
 * it expects the name of a file. So no name that somebody else has chosen
 * reaches it: it runs within the folder, on names of our own.
 */
#ifndef GNUPLOT_H
#define GNUPLOT_H

struct gnuplot {
    const char *folder; /* where to run; whatever the user called it */
    /* Plain names, as seen from there. */
    const char *script; /* what to run */
    const char *above;  /* what the script knows as DIR */
    const char *png;    /* what it shall draw */
    const char *log;    /* what it says goes here */
};

/* Runs `gnuplot -c SCRIPT ABOVE FILE` there, where FILE becomes PNG when it is
 * whole. Non-zero after a message that says what to do, also when there is no
 * gnuplot. */
int gnuplot_draw(const struct gnuplot *g);

#endif

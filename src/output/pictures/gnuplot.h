/* gnuplot.h -- runs a gnuplot script.
 *
 * gnuplot takes "<name" and "|name" for commands to be run by a shell, wherever
 * it expects the name of a file. So no name that a user has chosen is passed to
 * it: it runs within the folder, with names chosen here.
 */
#ifndef OUTPUT_PICTURES_GNUPLOT_H
#define OUTPUT_PICTURES_GNUPLOT_H

/* The first line of the log, by which it is known. */
#define GNUPLOT_SAYS "What gnuplot says:\n"

struct gnuplot {
    const char *folder; /* folder to run in */
    /* Plain names, relative to the folder. */
    const char *script; /* name of the script */
    const char *above;  /* name of DIR in the script */
    const char *png;    /* name of the picture */
    const char *log;    /* file for its messages */
};

/* Runs `gnuplot -c SCRIPT ABOVE FILE` there; FILE is renamed to PNG when it is
 * complete. Non-zero after a message that says what to do, also if gnuplot is
 * not installed. */
int gnuplot_draw(const struct gnuplot *g);

#endif

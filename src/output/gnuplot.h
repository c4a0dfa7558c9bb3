/* gnuplot.h -- runs a gnuplot script. */
#ifndef GNUPLOT_H
#define GNUPLOT_H

/* Runs `gnuplot -c SCRIPT DIR FILE`, where FILE becomes PNG when it is whole;
 * what gnuplot says goes to the file LOG. Non-zero after a message that says
 * what to do, also when there is no gnuplot. */
int gnuplot_draw(const char *script, const char *dir, const char *png,
                 const char *log);

#endif

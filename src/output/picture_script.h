/* picture_script.h -- the gnuplot script of a bed's picture, line by line.
 *
 * Goes behind the numbers of a run (picture.c), which it names without
 * defining. Ended by NULL.
 */
#ifndef OUTPUT_PICTURE_SCRIPT_H
#define OUTPUT_PICTURE_SCRIPT_H

extern const char *const picture_script[];

#endif

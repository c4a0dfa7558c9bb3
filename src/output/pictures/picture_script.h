/* picture_script.h -- the gnuplot script of a bed's picture, line by line.
 *
 * It follows the definitions of the numbers of a run (picture.c) that it uses.
 * Ended by NULL.
 */
#ifndef OUTPUT_PICTURES_PICTURE_SCRIPT_H
#define OUTPUT_PICTURES_PICTURE_SCRIPT_H

extern const char *const picture_script[];

#endif

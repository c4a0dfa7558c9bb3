/* animation.h -- a moving picture of the particles, drawn by gnuplot.
 *
 * For readers without ParaView: DIR/bed.gif shows the particles along z,
 * coloured by speed, at the times of the field output. The frames are left in
 * DIR/frames with the script frames/bed.gp, which may be changed and run again:
 *
 *     cd DIR/frames && gnuplot bed.gp
 */
#ifndef OUTPUT_PICTURES_ANIMATION_H
#define OUTPUT_PICTURES_ANIMATION_H

#include "base/state.h"
#include "output/pictures/picture.h"

struct animation;

/* A folder for the frames; NULL after a message. The folder is borrowed. */
struct animation *animation_create(struct folder *folder);
void animation_free(struct animation *a);

/* Writes the particles of a picture as the next frame; non-zero after a
 * message. */
int animation_add(struct animation *a, const struct picture *p);

/* The frames so far (state.h). */
void animation_state(struct animation *a, struct state *s);

/* Writes the script and lets gnuplot draw DIR/bed.gif; p gives title and box.
 * Non-zero after a message if the script cannot be written; without gnuplot a
 * message says what to do, and the run is done all the same. */
int animation_draw(const struct animation *a, const struct picture *p);

#endif

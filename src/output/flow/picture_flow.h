/* picture_flow.h -- the picture of a flow without particles: its files and
 * script, with the names of those of picture.h. */
#ifndef OUTPUT_FLOW_PICTURE_FLOW_H
#define OUTPUT_FLOW_PICTURE_FLOW_H

#include "output/pictures/picture.h"

int picture_flow_fits(const struct picture *p);

/* Non-zero after a message. */
int picture_flow_write(struct folder *folder, const struct picture *p);

#endif

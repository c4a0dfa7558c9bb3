/* section.h -- where the surfaces cut the plane of a picture. */
#ifndef OUTPUT_SURFACES_SECTION_H
#define OUTPUT_SURFACES_SECTION_H

#include "output/surfaces/outline.h"

#include <stdio.h>

/* Writes a segment "x y" for each polygon that crosses the plane z [m], each
 * followed by an empty line, with a number's shortest text. */
void section_write(FILE *out, const struct outline *o, double z);

#endif

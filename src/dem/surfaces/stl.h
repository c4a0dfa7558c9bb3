/* stl.h -- triangles from an STL file.
 * Chapter "Walls".
 *
 * Text ("solid ... facet ... endsolid", any number of solids) or binary (80
 * bytes of anything, the number of triangles, 50 bytes each). The length tells
 * which: a file that is as long as its binary head announces is binary, even if
 * it begins with "solid". The normals in the file are not used.
 */
#ifndef DEM_SURFACES_STL_H
#define DEM_SURFACES_STL_H

#include "base/file.h"

struct stl {
    int n;
    double (*corner)[3][3]; /* [m] if that is the unit of the file */
    int dropped;            /* [-] triangles without an area, left out */
};

/* Non-zero after one message with the file and the line (or, of a binary file,
 * the number of the triangle): it cannot be read, or is no STL, or has no
 * triangle. Release with stl_release. */
int stl_read(const char *path, struct stl *s);
int stl_parse(const struct input *file, struct stl *s);
void stl_release(struct stl *s);

#endif

/* vtk_read.h -- reads back the files of output/vtk.h, whoever wrote them.
 *
 * A folder may come from a stranger: nothing outside of it is opened, no link
 * is followed, and every size is checked before memory is taken. What is
 * malformed is not there.
 */
#ifndef REPORT_VTK_READ_H
#define REPORT_VTK_READ_H

#include <stddef.h>

/* The whole of the file "a" or "a/b" of an open folder, ended by a zero byte;
 * NULL if it is not an ordinary file there. To be freed. */
char *vtk_read_text(int folder, const char *name, size_t *length);

struct vtk_read {
    char *text; /* all of the file; the head is a string */
    size_t length;
    const char *data; /* where offsets are counted from */
};

/* 0, or non-zero if it is no such file. */
int vtk_read_open(struct vtk_read *f, int folder, const char *name);
void vtk_read_close(struct vtk_read *f);

/* The numbers of an array, to be freed, and how many there are of them; NULL if
 * it is not there, is malformed or has another number of components. */
double *vtk_read_array(const struct vtk_read *f, const char *name,
                       int components, size_t *n);

/* Polygons or cells, lists of points. */
struct vtk_shapes {
    double *x, *corner, *end; /* [m] points, theirs, and where each ends */
    size_t n_x, n_corner, n;
};
int vtk_read_shapes(struct vtk_shapes *s, const struct vtk_read *f);
void vtk_read_shapes_free(struct vtk_shapes *s);
/* Corner q of shape i; NULL if it has no more. */
const double *vtk_read_corner(const struct vtk_shapes *s, size_t i, size_t q);

#endif

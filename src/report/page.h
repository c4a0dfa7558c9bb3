/* page.h -- report.html while it is written: what is put into it, and what was
 * left out.
 *
 * All that comes from a folder is text of hidden elements, escaped by
 * base/text; the script of the page reads it there.
 */
#ifndef REPORT_PAGE_H
#define REPORT_PAGE_H

#include <stddef.h>
#include <stdio.h>

#include "base/text.h"

struct page {
    FILE *out;
    int folder;        /* descriptor of the folder of the present run */
    long most;         /* [byte] of the page, up to the end of this run */
    struct texts left; /* what is not in the page, in words */
};

/* How much of the budget is left [byte]. */
long page_room(const struct page *p);

/* n numbers as whole ones of 16 bit from the lowest to the highest, 65535 for
 * what is no number. */
struct page_numbers {
    const char *series, *name;
    double time; /* [s] */
    size_t n;
    const double *value;
    const char *more; /* further attributes, "" if none */
};
void page_put_numbers(struct page *p, const struct page_numbers *of);

/* `winnow report` of n folders: writes dir[0]/report.html. 0, or the exit code
 * after a message. */
int report_pages(int n, const char *const *dir);

/* The states of a run: particles, bodies, surfaces, slices of the fluid. */
void page_put_scene(struct page *p);

/* The parts that the build makes of files: lines, ended by NULL. */
extern const char *const page_html[],
    *const page_css[], *const page_add_js[],
                           *const page_js[], *const page_study_js[],
                                                 *const page_plots_css[],
                                                     *const page_plots_js[],
                                                         *const page_scene_js[];

/* Writes one of these parts. */
void page_put_program(FILE *out, const char *const *line);

/* --- vtk read: reads back the files of output/vtk.h, whoever wrote them.
 *
 * A folder may come from a stranger: nothing outside of it is opened, no link
 * is followed, and every size is checked before memory is taken. What is
 * malformed is not there. */

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

/* --- plane: slices through the middle of a mesh, from its file.
 *
 * A slice is a raster: each point of it shows the cell whose box contains it,
 * of several the one with the nearest centre. */

/* Points of a raster along the longer side; slices: across x, y and z in the
 * middle, then at a quarter and at three quarters of a side of four cells. */
enum { PLANE_MOST = 96, PLANES = 9 };

struct plane {
    int n[2];                   /* [-] points; 0: there is no such slice */
    double low[3], high[3], at; /* [m] */
    int cells;                  /* [-] of the mesh */
    int *cell;                  /* of each point; -1: none */
};

/* Non-zero if the file has not so many cells. */
int plane_make(struct plane plane[PLANES], const struct vtk_read *f,
               size_t cells);
void plane_free(struct plane plane[PLANES]);

#endif

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

/* The lines of a text, `of` bytes, in a hidden element <pre data-name>. */
void page_put_text(struct page *p, const char *name, const char *text);

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

/* The states of a run: particles, bodies, surfaces, slices of the fluid. */
void page_put_scene(struct page *p);

/* The parts that the build makes of files: lines, ended by NULL. */
extern const char *const page_html[],
    *const page_css[], *const page_js[], *const page_plots_css[],
                                             *const page_plots_js[],
                                                 *const page_scene_js[];

#endif

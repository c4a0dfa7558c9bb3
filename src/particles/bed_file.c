/* SPDX-License-Identifier: GPL-3.0-or-later */
/* bed_file.c -- a settled bed as a file.
 *
 * Text: a line that says what this is, a line with everything the bed depends
 * on, then id and position of each sphere in hexadecimal numbers, which are
 * exact. A file is only read if its second line is the one we would write.
 */
#include <stdio.h>
#include <string.h>

#include "base/file.h"
#include "particles/bed.h"

static const char *const first_line = "winnow settled bed 1\n";

enum { LINE = 1024 };

static void describe(char line[LINE], const struct bed_options *b,
                     const struct dem_options *o)
{
    const struct material *const m = &o->material;

    snprintf(line, LINE,
             "count %d diameter %.17g density %.17g seed %d jitter %.17g "
             "gravity %.17g %.17g %.17g settle %.17g box %.17g %.17g %.17g "
             "%.17g %.17g %.17g periodic %d %d %d law %s step %.17g young "
             "%.17g poisson %.17g stiffness %.17g restitution %.17g friction "
             "%.17g\n",
             b->count, b->diameter, b->density, b->seed, b->jitter,
             b->gravity[0], b->gravity[1], b->gravity[2], b->settle, o->low[0],
             o->low[1], o->low[2], o->high[0], o->high[1], o->high[2],
             o->periodic[0], o->periodic[1], o->periodic[2], o->law->name,
             o->step, m->young, m->poisson, m->stiffness, m->restitution,
             m->friction);
}

int bed_write(const char *path, const struct particles *ps,
              const struct bed_options *b, const struct dem_options *o)
{
    struct file *const file = file_create(path);
    char line[LINE];

    if (file == NULL) return 1;
    FILE *const out = file_stream(file);
    describe(line, b, o);
    fprintf(out, "%s%s", first_line, line);
    for (int i = 0; i < ps->n; i++)
        fprintf(out, "%d %a %a %a\n", ps->id[i], ps->x[i], ps->y[i], ps->z[i]);
    return file_commit(file);
}

static int wrong(const char *path, const char *what)
{
    fprintf(stderr, "winnow: %s: %s; remove the file to make the bed anew\n",
            path, what);
    return 2;
}

static int read_spheres(FILE *in, struct particles *ps,
                        const struct bed_options *b)
{
    for (int k = 0; k < b->count; k++) {
        int id;
        double x[3];
        if (fscanf(in, "%d %la %la %la\n", &id, &x[0], &x[1], &x[2]) != 4)
            return 1;
        ps->id[particles_add(ps, x, b->diameter, b->density)] = id;
    }
    return fgetc(in) != EOF;
}

int bed_read(const char *path, struct particles *ps,
             const struct bed_options *b, const struct dem_options *o)
{
    FILE *const in = fopen(path, "r");
    char line[LINE], expected[LINE];
    int code = 0;

    if (in == NULL) return 1;
    describe(expected, b, o);
    if (fgets(line, LINE, in) == NULL || strcmp(line, first_line) != 0)
        code = wrong(path, "not a settled bed");
    else if (fgets(line, LINE, in) == NULL || strcmp(line, expected) != 0)
        code = wrong(path, "this bed was made for another case");
    else if (read_spheres(in, ps, b) != 0)
        code = wrong(path, "the file is damaged");
    fclose(in);
    return code;
}

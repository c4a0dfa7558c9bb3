/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/pictures/animation.h"

#include "base/alloc.h"
#include "base/file.h"
#include "output/pictures/gnuplot.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct animation {
    struct folder *folder;
    int n;        /* [-] frames so far */
    int capacity; /* [-] of time */
    double *time; /* [s] of each frame */
    double fast; /* [m/s] largest usual speed of any frame: one scale for all */
};

/* clang-format off */
static const char *const script[] = {
"dir = ARGC > 0 ? ARG1 : '..'",
"gif = ARGC > 1 ? ARG2 : dir.'/bed.gif'",
"tall = 600.0",
"wide = tall * (x1 - x0) / (y1 - y0)",
"if (wide > 900) { wide = 900.0; tall = wide * (y1 - y0) / (x1 - x0) }",
"page = wide + 190.0",
"if (page < 7 * strlen(title) + 40) { page = 7.0 * strlen(title) + 40 }   # room for the title",
"set terminal gif animate optimize delay 8 loop 0 size page, tall + 130 background '#ffffff'",
"set output gif",
"unit = (y1 - y0 < 1 && x1 - x0 < 1) ? 1e-3 : 1.0",
"mm = unit < 1 ? 'mm' : 'm'",
"set xrange [x0 / unit : x1 / unit]",
"set yrange [y0 / unit : y1 / unit]",
"set xlabel 'x ['.mm.']'; set ylabel 'y ['.mm.']'",
"set tics out nomirror",
"unset key",
"left = 0.5 * (page - wide)",
"set lmargin at screen left / page; set rmargin at screen (left + wide) / page",
"set bmargin at screen 60.0 / (tall + 130); set tmargin at screen (tall + 60.0) / (tall + 130)",
"set palette defined (0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', 7 '#addc30', 8 '#fde725')",
"set cbrange [0 : fast]",
"set cblabel 'particle speed [m/s]'",
"least = 2.5 * (y1 - y0) / tall        # a lone particle would not be seen",
"do for [i = 1:words(times)] {",
"    set title sprintf(\"%s\\nt = %s s\", title, word(times, i)) noenhanced",
"    plot sprintf('frame_%05d.txt', i) \\",
"        using ($1 / unit):($2 / unit):(($3 > least ? $3 : least) / unit):4 \\",
"        with circles linecolor palette fillstyle solid 1 border linecolor rgb '#ffffff'",
"}",
"unset output",
NULL};
/* clang-format on */

struct animation *animation_create(struct folder *folder)
{
    struct animation *const a = alloc_zeroed(1, sizeof *a);

    a->folder = folder;
    if (folder_make(folder, "frames") == 0) return a;
    animation_free(a);
    return NULL;
}

void animation_free(struct animation *a)
{
    if (a == NULL) return;
    free(a->time);
    free(a);
}

/* Room for n frames. */
static void animation_reserve(struct animation *a, int n)
{
    if (n <= a->capacity) return;
    double *const time = alloc_doubles(2 * n + 64);
    for (int i = 0; i < a->n; i++)
        time[i] = a->time[i];
    free(a->time);
    a->time = time;
    a->capacity = 2 * n + 64;
}

int animation_add(struct animation *a, const struct picture *p)
{
    char name[40];

    animation_reserve(a, a->n + 1);
    a->time[a->n++] = p->time;
    a->fast = fmax(a->fast, picture_speed_scale(p));
    snprintf(name, sizeof name, "frames/frame_%05d.txt", a->n);
    return picture_write_particles(a->folder, name, p);
}

/* Non-zero after a message if a frame is not there. */
static int frame_missing(const struct animation *a)
{
    int missing = 0;

    for (int i = 1; i <= a->n && !missing; i++) {
        char name[40];
        snprintf(name, sizeof name, "frames/frame_%05d.txt", i);
        char *const path = file_join(folder_name(a->folder), name);
        missing = access(path, R_OK) != 0;
        if (missing)
            fprintf(stderr, "winnow: cannot read the frame %s: %s\n", path,
                    strerror(errno));
        free(path);
    }
    return missing;
}

void animation_state(struct animation *a, struct state *s)
{
    int n = a->n;

    state_begin(s, "animation");
    state_count(s, "frames", &n, INT_MAX / 4);
    if (!s->failed) animation_reserve(a, n);
    a->n = n;
    state_reals(s, "time", "s", a->time, n, 1);
    state_real(s, "fast", "m/s", &a->fast);
    state_end(s);
    if (s->loading && !s->failed) s->failed = frame_missing(a);
}

/* The script with the numbers of this run before it. */
static int animation_put_script(const struct animation *a,
                                const struct picture *p)
{
    struct file *const f = picture_open(a->folder, "frames/bed.gp");
    if (f == NULL) return 1;

    FILE *const out = file_stream(f);
    picture_put_box(out, p, a->fast > 0.0 ? a->fast : 1.0);
    fputs("times = '", out);
    for (int i = 0; i < a->n; i++)
        fprintf(out, "%s%.4g", i > 0 ? " " : "", a->time[i]);
    fputs("'\n\n", out);
    for (const char *const *line = script; *line; line++)
        fprintf(out, "%s\n", *line);
    return file_commit(f);
}

int animation_draw(const struct animation *a, const struct picture *p)
{
    static const char *const drawn[] = {"bed.gif", "frames/gnuplot.log"};

    if (a->n == 0) return 0;
    for (int i = 0; i < 2; i++) {
        char *const path = folder_file(a->folder, drawn[i]);
        free(path);
        if (path == NULL) return 1;
    }
    if (animation_put_script(a, p) != 0) return 1;
    char *const below = file_join(folder_name(a->folder), "frames");
    gnuplot_draw(&(struct gnuplot){.folder = below,
                                   .script = "bed.gp",
                                   .above = "..",
                                   .png = "../bed.gif",
                                   .log = "gnuplot.log"});
    free(below);
    return 0;
}

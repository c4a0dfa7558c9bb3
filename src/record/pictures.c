/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pictures.c -- what gnuplot draws of a run: a picture of its last state, and
 * an animation. Both are drawn only where there is a gnuplot.
 *
 * For readers without ParaView DIR/bed.gif shows the particles along z,
 * coloured by speed, at the times of the field output. The frames are left in
 * DIR/frames with the program frames/bed.gp, which may be changed and run
 * again:
 *
 *     cd DIR/frames && gnuplot bed.gp
 */
#include "record/recorder_part.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "base/file.h"
#include "output/pictures/picture.h"

/* --- frames --------------------------------------------------------------- */

struct animation {
    struct folder *folder;
    int n;        /* [-] frames so far */
    double *time; /* [s] of each frame */
    double fast; /* [m/s] largest usual speed of any frame: one scale for all */
};

/* Writes the particles as the next frame; non-zero after a message. */
static int animation_add(struct animation *a, const struct picture *p)
{
    char name[40];

    a->time = alloc_grown(a->time, a->n, a->n + 1, sizeof *a->time);
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

static void animation_state(struct animation *a, struct state *s)
{
    int n = a->n;

    state_begin(s, "animation");
    state_count(s, "frames", &n, INT_MAX / 4);
    if (s->loading && !s->failed)
        a->time = alloc_grown(a->time, a->n, n, sizeof *a->time);
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
    const struct picture_view see = picture_view(p->up);
    picture_put_box(out, p, see.axis, a->fast > 0.0 ? a->fast : 1.0);
    fputs("times = '", out);
    for (int i = 0; i < a->n; i++)
        fprintf(out, "%s%.4g", i > 0 ? " " : "", a->time[i]);
    fputs("'\n\n", out);
    picture_put_program(out, picture_frames);
    return file_commit(f);
}

/* --- as a part of the recorder -------------------------------------------- */

struct pictures {
    struct recorder_view view;
    double up[3]; /* [-] */
    int at_end;   /* [-] 1: the last state is drawn */
    int moving;   /* [-] 1: there is an animation */
    struct animation animation;
};

static void pictures_release(void *part)
{
    struct pictures *const p = part;

    free(p->animation.time);
    free(p);
}

static void *pictures_create(const struct recorder_view *v, int *failed)
{
    const struct output_options *const o = v->of->output;
    struct pictures *const p = alloc_zeroed(1, sizeof *p);

    p->view = *v;
    history_up(v->sim, p->up);
    p->animation.folder = v->folder;
    p->at_end = o->picture && (v->drawn != v->sim || v->sim->processes == NULL);
    p->moving = v->sim->particles != NULL && o->animation;
    *failed = p->moving && folder_make(v->folder, "frames") != 0;
    return p;
}

/* The present state as a picture (picture.h). */
static struct picture picture_of(const struct pictures *p)
{
    const struct recorder_view *const v = &p->view;
    const struct snapshot *const s = v->whole;

    return (struct picture){.title = v->of->title,
                            .time = s->t,
                            .up = p->up,
                            .mesh = v->drawn->mesh,
                            .eps = s->eps,
                            .u = s->u,
                            .p = s->p,
                            .walls = v->sim->n_surfaces > 0,
                            .n = s->n,
                            .x = {s->x[0], s->x[1], s->x[2]},
                            .v = {s->v[0], s->v[1], s->v[2]},
                            .d = s->d,
                            .pressure = v->sim->coupling != NULL};
}

static int add_frame(void *part, double t)
{
    struct pictures *const p = part;
    const struct picture now = picture_of(p);

    (void)t;
    return p->moving && animation_add(&p->animation, &now) != 0;
}

static int pictures_finish(void *part)
{
    struct pictures *const p = part;
    struct folder *const folder = p->view.folder;
    const struct picture last = picture_of(p);
    int drawn = 0;

    if (p->at_end) {
        if (picture_write(folder, &last) != 0 ||
            picture_draw(folder, "picture", "bed.png", &drawn) != 0)
            return 1;
        if (drawn) printf("picture %s/bed.png\n", folder_name(folder));
    }
    return p->animation.n > 0 &&
           (animation_put_script(&p->animation, &last) != 0 ||
            picture_draw(folder, "frames", "bed.gif", &drawn) != 0);
}

static void pictures_visit(void *part, struct state *s)
{
    struct pictures *const p = part;

    if (p->moving) animation_state(&p->animation, s);
}

const struct recorder_part recorder_pictures = {.create = pictures_create,
                                                .free = pictures_release,
                                                .fields = add_frame,
                                                .finish = pictures_finish,
                                                .state = pictures_visit};

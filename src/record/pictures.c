/* SPDX-License-Identifier: GPL-3.0-or-later */
/* pictures.c -- what gnuplot draws of a run: a picture of its last state
 * and an animation. Both are drawn only where there is a gnuplot. */
#include "record/recorder_part.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "output/pictures/animation.h"
#include "output/pictures/picture.h"

struct pictures {
    struct recorder_view view;
    int at_end;                  /* [-] 1: the last state is drawn */
    struct animation *animation; /* NULL: off */
};

static void pictures_release(void *part)
{
    struct pictures *const p = part;

    animation_free(p->animation);
    free(p);
}

static void *pictures_create(const struct recorder_view *v, int *failed)
{
    struct pictures *const p = alloc_zeroed(1, sizeof *p);

    p->view = *v;
    p->at_end = v->of->output->picture &&
                (v->drawn != v->sim || v->sim->processes == NULL);
    if (v->sim->particles == NULL || !v->of->output->animation) return p;
    p->animation = animation_create(v->folder);
    if (p->animation != NULL) return p;
    *failed = 1;
    pictures_release(p);
    return NULL;
}

/* The present state as a picture (picture.h). */
static struct picture picture_of(const struct recorder_view *v)
{
    const struct snapshot *const s = v->whole;

    return (struct picture){.title = v->of->title,
                            .time = s->t,
                            .mesh = v->drawn->mesh,
                            .eps = s->eps,
                            .u = s->u,
                            .p = s->p,
                            .walls = v->sim->n_surfaces > 0,
                            .n = s->n,
                            .x = {s->x[0], s->x[1], s->x[2]},
                            .v = {s->v[0], s->v[1], s->v[2]},
                            .d = s->d,
                            .pressure = v->sim->fluid != NULL &&
                                        v->sim->particles != NULL};
}

static int add_frame(void *part, double t)
{
    const struct pictures *const p = part;
    const struct picture now = picture_of(&p->view);

    (void)t;
    return p->animation != NULL && animation_add(p->animation, &now) != 0;
}

static int pictures_draw(void *part)
{
    const struct pictures *const p = part;
    const struct picture last = picture_of(&p->view);

    if (p->at_end) {
        if (picture_write(p->view.folder, &last) != 0) return 1;
        if (picture_draw(p->view.folder) == 0)
            printf("picture %s/bed.png\n", folder_name(p->view.folder));
    }
    return p->animation != NULL && animation_draw(p->animation, &last) != 0;
}

static void pictures_visit(void *part, struct state *s)
{
    struct pictures *const p = part;

    if (p->animation != NULL) animation_state(p->animation, s);
}

const struct recorder_part recorder_pictures = {.create = pictures_create,
                                                .free = pictures_release,
                                                .fields = add_frame,
                                                .finish = pictures_draw,
                                                .state = pictures_visit};

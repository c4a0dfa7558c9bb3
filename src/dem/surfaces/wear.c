/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/wear.h"

#include <math.h>

#include "base/alloc.h"
#include "base/vector.h"
#include "dem/surfaces/surface.h"

int wear_faces(const struct surface *s)
{
    return s->triangles != NULL ? s->triangles->n : 1;
}

struct wear wear_create(void *owner, const struct surface *list, int n)
{
    struct wear w = {0};

    w.first = owner_ints(owner, n);
    for (int k = 0; k < n; k++) {
        const int wears = list[k].wear.hardness > 0.0;
        w.first[k] = wears ? w.n : -1;
        w.n += wears ? wear_faces(&list[k]) : 0;
    }
    if (w.n > 0) w.face = owner_zeroed(owner, (size_t)w.n, sizeof *w.face);
    return w;
}

/* U^2 f(alpha) of the speeds U sin alpha and U cos alpha. */
double wear_finnie(const struct wear_of *w, double mass, const double v[3],
                   const double n[3])
{
    const double into = -vector_dot(v, n);
    double along[3];

    if (into <= 0.0) return 0.0;
    vector_along(v, into, n, along);
    const double u = vector_length(along);
    const double f =
        3.0 * into <= u ? 2.0 * into * u - 3.0 * into * into : u * u / 3.0;
    return w->cutting * mass / (4.0 * w->hardness) * f;
}

double wear_archard(const struct wear_of *w, double F_n, double way)
{
    return w->archard / w->hardness * fabs(F_n) * way;
}

void wear_state(struct wear_face *face, int n, struct state *s)
{
    state_begin(s, "wear");
    state_reals_of(s, "worn", "m^3", &face->worn, sizeof *face, n, 1);
    state_reals_of(s, "normal", "N s", &face->normal, sizeof *face, n, 1);
    state_reals_of(s, "shear", "N s", &face->shear, sizeof *face, n, 1);
    state_end(s);
}

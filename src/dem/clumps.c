/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/clumps.h"

#include <gsl/gsl_math.h>
#include <string.h>

#include "base/alloc.h"
#include "base/statistics.h"
#include "dem/particles_setup.h"

/* --- shapes --------------------------------------------------------------- */

static void clump_shape_mean(const struct clump_shape *s, double mean[3])
{
    mean[0] = mean[1] = mean[2] = 0.0;
    for (int k = 0; k < s->n; k++)
        vector_along(mean, s->ball[k].share, s->ball[k].at, mean);
}

/* Shares as the volumes of the balls, changed by as little as gives them the
 * centre of mass: share (1 + c . (r - r_mean)), with c from the second moments.
 * Balls in a plane cannot change what the columns of the union were wrong by
 * across it, 1e-6 of a diameter: by that the balls move. */
static int clump_set_shares(struct clump_shape *s)
{
    double sum = 0.0, mean[3], back[3], c[3], C[6] = {0.0};

    for (int k = 0; k < s->n; k++)
        sum += gsl_pow_3(s->ball[k].R);
    for (int k = 0; k < s->n; k++)
        s->ball[k].share = gsl_pow_3(s->ball[k].R) / sum;
    clump_shape_mean(s, mean);
    for (int k = 0; k < s->n; k++)
        for (int i = 0; i < 3; i++)
            for (int j = i; j < 3; j++)
                C[vector_place(i, j)] += s->ball[k].share *
                                         (s->ball[k].at[i] - mean[i]) *
                                         (s->ball[k].at[j] - mean[j]);
    for (int k = 0; k < 3; k++)
        back[k] = -mean[k];
    vector_solve(C, back, c);
    for (int k = 0; k < s->n; k++) {
        double r[3];
        vector_between(s->ball[k].at, mean, r);
        s->ball[k].share *= 1.0 + vector_dot(c, r);
        if (!(s->ball[k].share > 0.0)) return 1;
    }
    clump_shape_mean(s, mean);
    for (int k = 0; k < s->n; k++) {
        vector_between(s->ball[k].at, mean, s->ball[k].at);
        s->reach = fmax(s->reach, vector_length(s->ball[k].at) + s->ball[k].R);
    }
    return 0;
}

int clumps_shape_make(struct clump_shape *s, int n, struct clump_ball *ball,
                      double volume, const double gyration[6])
{
    s->n = n;
    s->ball = ball;
    s->volume = volume;
    s->reach = 0.0;
    rotation_principal(gyration, s->principal, s->gyration);
    for (int k = 0; k < n; k++) {
        double at[3];
        rotation_to_body(s->principal, ball[k].at, at);
        memcpy(ball[k].at, at, sizeof at);
    }
    return clump_set_shares(s);
}

double clumps_shape_diameter(const struct clump_shape *s)
{
    return cbrt(6.0 / M_PI * s->volume);
}

static double filled(const struct clump_shape *s, int k)
{
    return s->ball[k].share * s->volume /
           (4.0 / 3.0 * M_PI * gsl_pow_3(s->ball[k].R));
}

double clumps_least_ball(const struct clump_shape *s, double d)
{
    double R = HUGE_VAL;

    if (s == NULL) return d;
    for (int k = 0; k < s->n; k++)
        R = fmin(R, s->ball[k].R);
    return d * (2.0 * R) / (2.0 * s->reach);
}

double clumps_least_filled(const struct clump_shape *first)
{
    double least = first == NULL ? 1.0 : HUGE_VAL;

    for (const struct clump_shape *s = first; s != NULL; s = s->next)
        for (int k = 0; k < s->n; k++)
            least = fmin(least, filled(s, k));
    return least;
}

const struct clump_shape *clumps_drawn(const struct clump_shape *first,
                                       int seed, long i)
{
    const struct clump_shape *s = first;
    double sum = 0.0;

    if (s == NULL || s->next == NULL) return s;
    for (const struct clump_shape *one = first; one != NULL; one = one->next)
        sum += one->share;
    double left = sum * random_uniform((unsigned long)seed, i, 0, 5);
    while ((left -= s->share) >= 0.0 && s->next != NULL)
        s = s->next;
    return s;
}

/* --- clumps --------------------------------------------------------------- */

void clumps_add_to(struct particles *ps, int n_shapes,
                   const struct clump_shape *shape)
{
    struct clumps *const l = ps->clumps = owner_zeroed(ps, 1, sizeof *l);

    l->n_shapes = n_shapes;
    l->shape = shape;
    l->capacity = ps->capacity;
    l->item = owner_zeroed(ps, (size_t)l->capacity, sizeof *l->item);
    l->of = owner_ints(ps, l->capacity);
    l->index = owner_ints(ps, l->capacity);
    for (int id = 0; id < l->capacity; id++)
        l->of[id] = -1;
}

void clumps_turn(const double r[3], double q[4])
{
    const double angle = vector_length(r);
    const double per = angle > 0.0 ? sin(0.5 * angle) / angle : 0.5;

    q[0] = cos(0.5 * angle);
    for (int k = 0; k < 3; k++)
        q[1 + k] = per * r[k];
}

/* Two points in the unit circle make one on the sphere of four dimensions
 * [Marsaglia72]. */
void clumps_turn_at_random(unsigned long seed, long i, double q[4])
{
    double s[2];
    int number = 0;

    for (int half = 0; half < 2; half++)
        do {
            for (int k = 0; k < 2; k++)
                q[2 * half + k] =
                    2.0 * random_uniform(seed, i, number++, 4) - 1.0;
            s[half] = gsl_pow_2(q[2 * half]) + gsl_pow_2(q[2 * half + 1]);
        } while (s[half] >= 1.0 || s[half] == 0.0);
    for (int k = 2; k < 4; k++)
        q[k] *= sqrt((1.0 - s[0]) / s[1]);
    rotation_normalize(q);
}

/* Writes the balls into the arrays of the particles. */
static void clumps_put_balls(struct particles *ps, const struct clump *c)
{
    const struct clumps *const l = ps->clumps;
    const struct clump_pose at = clumps_pose(c);

    for (int k = 0; k < l->shape[c->shape].n; k++) {
        const int i = l->index[c->first + k];
        double r[3], v[3];
        clumps_ball(l, c, &at, k, r, v);
        ps->x[i] = c->x[0] + r[0];
        ps->y[i] = c->x[1] + r[1];
        ps->z[i] = c->x[2] + r[2];
        ps->vx[i] = v[0], ps->vy[i] = v[1], ps->vz[i] = v[2];
        ps->wx[i] = at.w[0], ps->wy[i] = at.w[1], ps->wz[i] = at.w[2];
    }
}

int clumps_add(struct particles *ps, int shape, double scale, double density,
               const double x[3], const double v[3], const double q[4],
               const double w[3])
{
    struct clumps *const l = ps->clumps;
    const struct clump_shape *const s = &l->shape[shape];
    struct clump *const c = &l->item[l->n];
    const int first = ps->n;
    double Q[3][3], spin[3];

    *c = (struct clump){.shape = shape, .first = ps->next_id, .scale = scale};
    c->m = density * s->volume * gsl_pow_3(scale);
    memcpy(c->x, x, sizeof c->x);
    memcpy(c->v, v, sizeof c->v);
    rotation_product(q, s->principal, c->q);
    rotation_matrix(c->q, Q);
    rotation_to_body(c->q, w, spin);
    for (int k = 0; k < 3; k++) {
        const double I = c->m * gsl_pow_2(scale) * s->gyration[k];
        c->per_I[k] = 1.0 / I;
        for (int e = 0; e < 3; e++)
            c->L[e] += Q[e][k] * I * spin[k];
    }
    for (int k = 0; k < s->n; k++) {
        const int id = ps->next_id;
        l->of[id] = l->n;
        l->index[id] =
            particles_add(ps, x, 2.0 * scale * s->ball[k].R, density);
    }
    l->n++;
    clumps_put_balls(ps, c);
    return first;
}

void clumps_add_drawn(struct particles *ps, const struct clump_shape *first,
                      int seed, long i, double d, double density,
                      const double x[3], const double v[3])
{
    static const double rest[3] = {0.0, 0.0, 0.0};
    const struct clump_shape *const s = clumps_drawn(first, seed, i);
    double q[4];

    if (s != NULL) {
        clumps_turn_at_random((unsigned long)seed, i, q);
        clumps_add(ps, (int)(s - ps->clumps->shape), 0.5 * d / s->reach,
                   density, x, v, q, rest);
        return;
    }
    const int at = particles_add(ps, x, d, density);
    ps->vx[at] = v[0], ps->vy[at] = v[1], ps->vz[at] = v[2];
}

double clumps_filled(const struct particles *ps, int i)
{
    const struct clumps *const l = ps->clumps;
    const int of = l->of[ps->id[i]];

    if (of < 0) return 1.0;
    const struct clump *const c = &l->item[of];
    return filled(&l->shape[c->shape], ps->id[i] - c->first);
}

double clumps_grain(const struct particles *ps, int i)
{
    if (!clumps_own(ps, i)) return particles_grain(ps, i);
    const struct clump *const c = &ps->clumps->item[ps->clumps->of[ps->id[i]]];
    return c->scale * ps->clumps->shape[c->shape].sauter;
}

double clumps_sphere(const struct particles *ps, int i)
{
    const struct clump *const c = &ps->clumps->item[ps->clumps->of[ps->id[i]]];
    return c->scale * clumps_shape_diameter(&ps->clumps->shape[c->shape]);
}

void clumps_locate(const struct particles *ps)
{
    for (int i = 0; i < ps->n; i++)
        ps->clumps->index[ps->id[i]] = i;
}

void clumps_remove(struct particles *ps, const int *removed)
{
    struct clumps *const l = ps->clumps;
    int kept = 0;

    clumps_locate(ps);
    for (int c = 0; c < l->n; c++) {
        const struct clump one = l->item[c];
        const int gone = removed[l->index[one.first]];
        for (int k = 0; k < l->shape[one.shape].n; k++)
            l->of[one.first + k] = gone ? -1 : kept;
        if (!gone) l->item[kept++] = one;
    }
    l->n = kept;
}

void clumps_mark(const struct particles *ps, int *marked)
{
    const struct clumps *const l = ps->clumps;

    clumps_locate(ps);
    for (int c = 0; c < l->n; c++) {
        const int *const index = &l->index[l->item[c].first];
        const int n = l->shape[l->item[c].shape].n;
        int any = 0;
        for (int k = 0; k < n; k++)
            any |= marked[index[k]];
        for (int k = 0; k < n; k++)
            marked[index[k]] = any;
    }
}

void clumps_slow_down(struct particles *ps, double factor)
{
    struct clumps *const l = ps->clumps;

    for (int c = 0; c < l->n; c++)
        for (int k = 0; k < 3; k++) {
            l->item[c].v[k] *= factor;
            l->item[c].L[k] *= factor;
        }
}

void clumps_energy(const struct clumps *l, double *translation,
                   double *rotation)
{
    *translation = *rotation = 0.0;
    for (int c = 0; l != NULL && c < l->n; c++) {
        const struct clump *const one = &l->item[c];
        double w[3];
        rotation_spin(one->q, one->L, one->per_I, w);
        *translation += 0.5 * one->m * vector_dot(one->v, one->v);
        *rotation += 0.5 * vector_dot(one->L, w);
    }
}

/* --- state ---------------------------------------------------------------- */

/* Each clump has balls that are there, and no ball has two. */
static int clumps_are_whole(struct particles *ps)
{
    struct clumps *const l = ps->clumps;

    for (int id = 0; id < l->capacity; id++)
        l->of[id] = l->index[id] = -1;
    clumps_locate(ps);
    for (int c = 0; c < l->n; c++) {
        const struct clump *const one = &l->item[c];
        for (int k = 0; k < l->shape[one->shape].n; k++) {
            const int id = one->first + k;
            if (id >= ps->next_id || l->index[id] < 0 || l->of[id] >= 0)
                return 0;
            l->of[id] = c;
        }
    }
    return 1;
}

void clumps_state(struct particles *ps, struct state *s)
{
    struct clumps *const l = ps->clumps;
    struct clump *const a = l->item;
    const size_t size = sizeof *a;

    state_begin(s, "clumps");
    state_count(s, "count", &l->n, l->capacity);
    state_indices_of(s, "shape", &a->shape, size, l->n, 0, l->n_shapes - 1);
    state_indices_of(s, "first", &a->first, size, l->n, 0, ps->next_id);
    state_reals_of(s, "scale", "-", &a->scale, size, l->n, 1);
    state_reals_of(s, "m", "kg", &a->m, size, l->n, 1);
    state_reals_of(s, "per_I", "1/(kg m^2)", a->per_I, size, l->n, 3);
    state_reals_of(s, "x", "m", a->x, size, l->n, 3);
    state_reals_of(s, "v", "m/s", a->v, size, l->n, 3);
    state_reals_of(s, "q", "-", a->q, size, l->n, 4);
    state_reals_of(s, "L", "kg m^2/s", a->L, size, l->n, 3);
    if (s->loading && !s->failed)
        state_demand(s, clumps_are_whole(ps), "clumps without their balls");
    state_end(s);
}

/* --- keys ----------------------------------------------------------------- */

#define OF(type, member) KEY_AT(type, member)
#define NAMED                                                                  \
    "the name of one of particles.clumps: its grains are of that shape, and "  \
    "sizes are diameters of spheres of their volume"

const struct key clumps_keys[] = {
    {"particles.clumps", KEY_LIST, "", "", "",
     "named shapes of grains that are rigid bodies of balls", "", "",
     OF(particles_setup, clumps), .size = sizeof(struct clump_setup),
     .divided = "the ranks do not know which balls are one body"},
    {"particles.clumps.name", KEY_TEXT, "", "", NULL, "its name", "", "",
     OF(clump_setup, name)},
    {"particles.clumps.file", KEY_FILE, "", "", "",
     "its balls, x y z d [m] in each line, or a table with names of columns; "
     "beside the case unless it begins with /",
     "", "", OF(clump_setup, file)},
    {"particles.clumps.scale", KEY_REAL, "-", "> 0", "1.0",
     "by which the numbers of the file are multiplied", "", "",
     OF(clump_setup, scale)},
    {"particles.clumps.half_axes", KEY_VECTOR, "m", "> 0", "",
     "or those of an ellipsoid of revolution, the longer one first, which its "
     "balls fill",
     "", "", OF(clump_setup, half), KEY_GIVEN(clump_setup, has_half)},
    {"particles.clumps.balls", KEY_INT, "-", ">= 2, <= 99", "7",
     "number of balls in an ellipsoid", "", "", OF(clump_setup, balls),
     KEY_GIVEN(clump_setup, has_balls)},
    {"particles.clumps.share", KEY_REAL, "-", "> 0", "",
     "clumps of one name are a mixture: its part of their number, over the sum "
     "of these",
     "", "", OF(clump_setup, share)},
    {"particles.place.clump", KEY_TEXT, "", "", "", NAMED, "",
     "particles.clumps", OF(place_setup, clump)},
    {"particles.place.rotation", KEY_VECTOR, "rad", "", "[0.0, 0.0, 0.0]",
     "how a clump is turned at time 0: the direction is the axis, the length "
     "the angle",
     "", "", OF(place_setup, rotation)},
    {"particles.bed.clump", KEY_TEXT, "", "", "", NAMED ", turned at random",
     "", "particles.clumps", OF(particles_setup, bed_clump),
     .divided = KEY_DIVIDED},
    {"particles.insert.clump", KEY_TEXT, "", "", "", NAMED ", turned at random",
     "", "particles.clumps", OF(insert_setup, clump)},
    KEY_END};

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/rows.h"

#include <math.h>

#include "base/alloc.h"
#include "dem/integrator.h"

struct rows *rows_create(int capacity, const struct box_domain *box)
{
    struct rows *const b = owner_create(sizeof *b);
    const size_t n = (size_t)capacity;

    b->box = *box;
    b->place = owner_zeroed(b, n, sizeof *b->place);
    b->motion = owner_zeroed(b, n, sizeof *b->motion);
    b->acceleration = owner_zeroed(b, n + 1, sizeof *b->acceleration);
    b->listed = owner_zeroed(b, n, sizeof *b->listed);
    b->chosen = owner_zeroed(b, n, sizeof *b->chosen);
    return b;
}

void rows_add_implicit_drag(struct rows *b, const struct particles *ps)
{
    if (ps->drag_coefficient == NULL) return;
    if (b->drag == NULL)
        b->drag = owner_zeroed(b, (size_t)ps->capacity, sizeof *b->drag);
    b->drag_impulse = ps->drag_impulse;
}

void rows_load(struct rows *b, const struct particles *ps, int begin, int end)
{
    for (int i = begin; i < end; i++) {
        const double R = 0.5 * ps->d[i];

        b->place[i] = (struct row_place){{ps->x[i], ps->y[i], ps->z[i]}, R};
        b->motion[i] =
            (struct row_motion){{ps->vx[i], ps->vy[i], ps->vz[i]},
                                1.0 / R,
                                {R * ps->wx[i], R * ps->wy[i], R * ps->wz[i]},
                                0.0};
        rows_load_mass(b, ps, i);
    }
}

void rows_load_mass(struct rows *b, const struct particles *ps, int i)
{
    double per_mass = 1.0 / ps->m[i], *const a = b->acceleration[i];

    b->motion[i].per_m = per_mass;
    if (b->own_inverse_mass != NULL) b->own_inverse_mass[i] = 0.0;
    if (b->drag != NULL) {
        per_mass = 1.0 / (ps->m[i] + ps->added_mass[i]);
        const double rate = ps->drag_coefficient[i] * per_mass;
        b->drag[i] = (struct row_drag){rate, implicit_drag_gain(rate * b->step),
                                       implicit_drag_gain(0.5 * rate * b->step),
                                       per_mass};
    }
    a[0] = ps->ex[i] * per_mass;
    a[1] = ps->ey[i] * per_mass;
    a[2] = ps->ez[i] * per_mass;
}

void rows_store(const struct rows *b, struct particles *ps, int begin, int end)
{
    for (int i = begin; i < end; i++) {
        const struct row_place *const p = &b->place[i];
        const struct row_motion *const m = &b->motion[i];

        ps->x[i] = box_domain_inside(&b->box, 0, p->x[0]);
        ps->y[i] = box_domain_inside(&b->box, 1, p->x[1]);
        ps->z[i] = box_domain_inside(&b->box, 2, p->x[2]);
        ps->vx[i] = m->v[0], ps->vy[i] = m->v[1], ps->vz[i] = m->v[2];
        ps->wx[i] = m->s[0] / p->R, ps->wy[i] = m->s[1] / p->R;
        ps->wz[i] = m->s[2] / p->R;
    }
}

/* With an implicit drag; the impulse of -k v is added to b->drag_impulse. */
static void rows_advance_with_drag(struct rows *b, int begin, int end,
                                   const struct row_load *load, double kick,
                                   double drift, double fastest[4])
{
    const int half = kick < b->step;
    double top[3] = {fastest[0], fastest[1], fastest[2]};

    for (int i = begin; i < end; i++) {
        const struct row_drag *const drag = &b->drag[i];
        const struct row_load *const f = &load[i - begin];
        const double *const a = b->acceleration[i];
        struct row_motion *const m = &b->motion[i];
        const double gain = half ? drag->gain_half : drag->gain;
        const double mass = 1.0 / drag->per_m;

        for (int k = 0; k < 3; k++) {
            const double given = drag->per_m * f->F[k] + a[k]; /* [m/s^2] */
            const double taken = gain * (given - drag->rate * m->v[k]);
            m->v[k] += kick * taken;
            b->drag_impulse[3 * i + k] += mass * kick * (taken - given);
            m->s[k] -= 2.5 * kick * m->per_m * f->turn[k];
            b->place[i].x[k] += drift * m->v[k];
            top[k] = fmax(top[k], fabs(m->v[k]));
        }
    }
    for (int k = 0; k < 3; k++)
        fastest[k] = top[k];
}

/* dv = (F/m + a) dt [XS11 2.1]; d(R omega) = R T dt/I [XS11 2.2] with I =
 * (2/5) m R^2 and T = -R sum n x F_t [LS 4.1-4.3, 4.16], so
 * -(5/2) (sum n x F_t) dt/m. The rows are arrays of eight and four numbers
 * here, which are treated alike. */
void rows_advance(struct rows *b, int begin, int end,
                  const struct row_load *load, double kick, double drift,
                  double fastest[4])
{
    static const double gain[8] = {1.0, 1.0, 1.0, 0.0, -2.5, -2.5, -2.5, 0.0};
    const double shift[4] = {drift, drift, drift, 0.0};
    double top[4] = {fastest[0], fastest[1], fastest[2], 0.0};

    if (b->drag != NULL) {
        rows_advance_with_drag(b, begin, end, load, kick, drift, fastest);
        return;
    }
    for (int i = begin; i < end; i++) {
        double *restrict const x = (double *)&b->place[i];
        double *restrict const v = (double *)&b->motion[i];
        const double *restrict const a = b->acceleration[i];
        const double *restrict const f = (const double *)&load[i - begin];
        const double per_mass = kick * b->motion[i].per_m;
        const double per_R = v[3], R = x[3];

#pragma omp simd
        for (int k = 0; k < 8; k++)
            v[k] += gain[k] * per_mass * f[k];
#pragma omp simd
        for (int k = 0; k < 4; k++) {
            v[k] += kick * a[k];
            x[k] += shift[k] * v[k];
        }
#pragma omp simd
        for (int k = 0; k < 4; k++)
            top[k] = fabs(v[k]) > top[k] ? fabs(v[k]) : top[k];
        v[3] = per_R; /* to which a number of the next one was added, */
        x[3] = R;     /* and 0 times that, which may not be a number */
    }
    for (int k = 0; k < 3; k++)
        fastest[k] = top[k];
}

struct row_motion rows_kicked(const struct rows *b, int i,
                              const struct row_load *load)
{
    static const struct row_drag none = {.gain = 1.0};
    const struct row_drag *const drag = b->drag != NULL ? &b->drag[i] : &none;
    const double *const a = b->acceleration[i];
    struct row_motion m = b->motion[i];
    const double per_mass = b->drag != NULL ? drag->per_m : m.per_m;

    for (int k = 0; k < 3; k++) {
        m.v[k] += b->step * drag->gain *
                  (per_mass * load->F[k] + a[k] - drag->rate * m.v[k]);
        m.s[k] -= 2.5 * b->step * m.per_m * load->turn[k];
    }
    return m;
}

/* A particle is lost when it is wholly outside, its centre a radius beyond a
 * wall, or when its position is not finite: a comparison with NaN is false. */
static int inside(const struct box_domain *box, const struct row_place *p)
{
    const double *const x = p->x;
    int ok = 1;

    for (int k = 0; k < 3; k++)
        ok &= box->periodic[k]
                  ? fabs(x[k]) < HUGE_VAL
                  : x[k] >= box->lo[k] - p->R && x[k] <= box->hi[k] + p->R;
    return ok;
}

static int finite(const struct row_motion *m)
{
    const double *const v = (const double *)m;
    double sum = 0.0;

    for (int k = 0; k < 8; k++)
        sum += fabs(v[k]);
    return sum < HUGE_VAL;
}

/* 1 if one of the rows may be lost: a sum over all of them is not finite, or
 * one is farther outside than its radius. It takes a tenth of the time of a
 * look at each. */
static int may_be_lost(const struct rows *b, int begin, int end)
{
    double lo[4], hi[4], sum[8] = {0.0}, out[4] = {0.0};

    for (int k = 0; k < 4; k++) {
        const int open = k == 3 || b->box.periodic[k];
        lo[k] = open ? -HUGE_VAL : b->box.lo[k];
        hi[k] = open ? HUGE_VAL : b->box.hi[k];
    }
    for (int i = begin; i < end; i++) {
        const double *const x = (const double *)&b->place[i], R = x[3];
        const double *const v = (const double *)&b->motion[i];

#pragma omp simd
        for (int k = 0; k < 8; k++)
            sum[k] += fabs(v[k]) + fabs(x[k % 4]);
#pragma omp simd
        for (int k = 0; k < 4; k++) {
            const double below = lo[k] - R - x[k], above = x[k] - (hi[k] + R);
            const double farther = below > above ? below : above;
            out[k] = farther > out[k] ? farther : out[k];
        }
    }
    for (int k = 1; k < 8; k++)
        sum[0] += sum[k];
    return !(sum[0] < HUGE_VAL) || out[0] > 0.0 || out[1] > 0.0 || out[2] > 0.0;
}

struct rows_survey rows_check_lost(const struct rows *b, int begin, int end)
{
    struct rows_survey found = {0, -1, -1};

    if (!may_be_lost(b, begin, end)) return found;
    for (int i = begin; i < end; i++) {
        if (inside(&b->box, &b->place[i]) && finite(&b->motion[i])) continue;
        if (found.lost++ == 0) found.first_lost = i;
    }
    return found;
}

void rows_record_positions(struct rows *b, int begin, int end, double ahead)
{
    for (int i = begin; i < end; i++) {
        for (int k = 0; k < 3; k++)
            b->listed[i][k] = b->place[i].x[k] + ahead * b->motion[i].v[k];
    }
}

/* Too little is less than two thirds of what is wanted. */
struct rows_margins rows_set_margins(struct rows *b, int begin, int end,
                                     double least, double time, double room)
{
    const struct box_domain box = b->box;
    const struct row_place *const x = b->place;
    const double(*const listed)[3] = (const double(*)[3])b->listed;
    struct row_place *const chosen = b->chosen;
    double left = HUGE_VAL;
    int narrow = 0;

#pragma omp simd reduction(min : left) reduction(| : narrow)
    for (int i = begin; i < end; i++) {
        const double *const v = b->motion[i].v;
        const double speed = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
        const double own = least + time * speed;
        const double wanted = own < 0.25 * room ? own : 0.25 * room;
        const double rest =
            room - sqrt(rows_distance2(&box, x[i].x, listed[i]));
        const double margin = wanted < rest ? wanted : rest;

        chosen[i] = x[i];
        chosen[i].R += margin;
        left = margin < left ? margin : left;
        narrow |= !(1.5 * rest >= wanted); /* or not a number */
    }
    return (struct rows_margins){left, narrow};
}

double rows_margin_left(const struct rows *b, int begin, int end)
{
    const struct box_domain box = b->box;
    const struct row_place *const x = b->place, *const at = b->chosen;
    double left = HUGE_VAL;
    int bad = 0;

#pragma omp simd reduction(min : left) reduction(| : bad)
    for (int i = begin; i < end; i++) {
        const double moved = sqrt(rows_distance2(&box, x[i].x, at[i].x));
        const double own = at[i].R - x[i].R - moved;

        left = own < left ? own : left;
        bad |= !(own >= 0.0); /* or not a number */
    }
    return bad ? -1.0 : left;
}

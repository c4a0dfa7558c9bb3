/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/fast/bodies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "dem/fast/drag_rows.h"

struct bodies *bodies_create(int capacity, const struct box_domain *box)
{
    struct bodies *const b = alloc_zeroed(1, sizeof *b);
    const size_t n = (size_t)capacity;

    b->box = *box;
    b->position_radius = alloc_zeroed(n, sizeof *b->position_radius);
    b->velocity = alloc_zeroed(n, sizeof *b->velocity);
    b->acceleration = alloc_zeroed(n, sizeof *b->acceleration);
    b->position_at_rebuild = alloc_zeroed(n, sizeof *b->position_at_rebuild);
    return b;
}

void bodies_free(struct bodies *b)
{
    if (b == NULL) return;
    free(b->position_radius);
    free(b->velocity);
    free(b->before);
    free(b->acceleration);
    free(b->position_at_rebuild);
    free(b->implicit_drag);
    free(b->own_inverse_mass);
    free(b);
}

void bodies_add_implicit_drag(struct bodies *b, const struct particles *ps)
{
    if (ps->drag_coefficient == NULL) return;
    if (b->implicit_drag == NULL)
        b->implicit_drag =
            alloc_zeroed((size_t)ps->capacity, sizeof *b->implicit_drag);
    b->drag_impulse = ps->drag_impulse;
}

void bodies_load(struct bodies *b, const struct particles *ps, int begin,
                 int end)
{
    for (int i = begin; i < end; i++) {
        const double R = 0.5 * ps->d[i], per_mass = 1.0 / ps->m[i];
        double *const x = b->position_radius[i], *const v = b->velocity[i];
        double *const a = b->acceleration[i];

        x[0] = ps->x[i], x[1] = ps->y[i], x[2] = ps->z[i], x[3] = R;
        v[0] = ps->vx[i], v[1] = ps->vy[i], v[2] = ps->vz[i], v[3] = 1.0 / R;
        v[4] = R * ps->wx[i], v[5] = R * ps->wy[i], v[6] = R * ps->wz[i];
        v[7] = per_mass;
        if (b->own_inverse_mass != NULL) b->own_inverse_mass[i] = 0.0;
        a[0] = ps->ex[i] * per_mass;
        a[1] = ps->ey[i] * per_mass;
        a[2] = ps->ez[i] * per_mass;
    }
    if (b->implicit_drag != NULL) drag_rows_load(b, ps, begin, end);
}

void bodies_store(const struct bodies *b, struct particles *ps, int begin,
                  int end)
{
    for (int i = begin; i < end; i++) {
        const double *const x = b->position_radius[i], *const v =
                                                           b->velocity[i];

        ps->x[i] = box_domain_inside(&b->box, 0, x[0]);
        ps->y[i] = box_domain_inside(&b->box, 1, x[1]);
        ps->z[i] = box_domain_inside(&b->box, 2, x[2]);
        ps->vx[i] = v[0], ps->vy[i] = v[1], ps->vz[i] = v[2];
        ps->wx[i] = v[4] / x[3], ps->wy[i] = v[5] / x[3];
        ps->wz[i] = v[6] / x[3];
    }
}

/* dv = (F/m + a) dt [XS11 2.1]; d(R omega) = R T dt/I [XS11 2.2] with I =
 * (2/5) m R^2 and T = -R sum n x F_t [LS 4.1-4.3, 4.16], so
 * -(5/2) (sum n x F_t) dt/m. */
void bodies_advance(struct bodies *b, int begin, int end, double (*load)[8],
                    double kick, double drift, double fastest[4])
{
    static const double gain[8] = {1.0, 1.0, 1.0, 0.0, -2.5, -2.5, -2.5, 0.0};
    const double shift[4] = {drift, drift, drift, 0.0};
    double top[4] = {fastest[0], fastest[1], fastest[2], 0.0};

    for (int i = begin; i < end; i++) {
        double *restrict const x = b->position_radius[i];
        double *restrict const v = b->velocity[i];
        const double *restrict const a = b->acceleration[i];
        const double *restrict const f = load[i - begin];
        const double per_mass = kick * v[7];

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
    }
    for (int k = 0; k < 3; k++)
        fastest[k] = top[k];
}

void bodies_kicked(const struct bodies *b, int i, const double load[8],
                   double velocity[8])
{
    const double *const v = b->velocity[i], *const a = b->acceleration[i];
    const double *const held =
        b->implicit_drag != NULL ? b->implicit_drag[i] : NULL;
    const double per_mass = held != NULL ? held[3] : v[7];
    const double rate = held != NULL ? held[0] : 0.0;
    const double gain = held != NULL ? held[1] : 1.0;

    memcpy(velocity, v, 8 * sizeof *v);
    for (int k = 0; k < 3; k++) {
        velocity[k] +=
            b->step * gain * (per_mass * load[k] + a[k] - rate * v[k]);
        velocity[4 + k] -= 2.5 * b->step * v[7] * load[4 + k];
    }
}

/* A particle is lost when it is wholly outside, its centre a radius beyond a
 * wall, or when its position is not finite: a comparison with NaN is false. */
static int inside(const struct box_domain *box, const double x[4])
{
    int ok = 1;

    for (int k = 0; k < 3; k++)
        ok &= box->periodic[k]
                  ? fabs(x[k]) < HUGE_VAL
                  : x[k] >= box->lo[k] - x[3] && x[k] <= box->hi[k] + x[3];
    return ok;
}

static int finite(const double v[8])
{
    double sum = 0.0;

    for (int k = 0; k < 8; k++)
        sum += fabs(v[k]);
    return sum < HUGE_VAL;
}

struct bodies_survey bodies_check_lost(const struct bodies *b, int begin,
                                       int end)
{
    struct bodies_survey found = {0.0, 0, -1, -1};

    for (int i = begin; i < end; i++) {
        double moved2 = 0.0;

        for (int k = 0; k < 3; k++) {
            const double dx =
                b->position_radius[i][k] - b->position_at_rebuild[i][k];
            const double L = b->box.length[k];
            const double nearest = dx - L * rint(dx * b->box.inverse[k]);
            moved2 += nearest * nearest;
        }
        if (moved2 > found.moved2) found.moved2 = moved2;
        if (inside(&b->box, b->position_radius[i]) && finite(b->velocity[i]))
            continue;
        if (found.lost++ == 0) found.first_lost = i;
    }
    return found;
}

void bodies_record_positions(struct bodies *b, int begin, int end)
{
    for (int i = begin; i < end; i++)
        for (int k = 0; k < 3; k++)
            b->position_at_rebuild[i][k] = b->position_radius[i][k];
}

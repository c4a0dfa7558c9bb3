/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "particles/bodies.h"

#include <math.h>
#include <stdlib.h>

#include "base/alloc.h"
#include "particles/response.h"

struct domain bodies_domain(const double lo[3], const double hi[3],
                            const int periodic[3])
{
    struct domain box;

    for (int k = 0; k < 3; k++) {
        box.lo[k] = lo[k];
        box.hi[k] = hi[k];
        box.periodic[k] = periodic[k];
        box.length[k] = periodic[k] ? hi[k] - lo[k] : 0.0;
        box.inverse[k] = periodic[k] ? 1.0 / (hi[k] - lo[k]) : 0.0;
    }
    return box;
}

struct bodies *bodies_create(int capacity, const struct domain *box)
{
    struct bodies *const b = alloc_zeroed(1, sizeof *b);
    const size_t n = (size_t)capacity;

    b->box = *box;
    b->place = alloc_zeroed(n, sizeof *b->place);
    b->motion = alloc_zeroed(n, sizeof *b->motion);
    b->push = alloc_zeroed(n, sizeof *b->push);
    b->mark = alloc_zeroed(n, sizeof *b->mark);
    return b;
}

void bodies_free(struct bodies *b)
{
    if (b == NULL) return;
    free(b->place);
    free(b->motion);
    free(b->push);
    free(b->mark);
    free(b->response);
    free(b);
}

void bodies_hold_back(struct bodies *b, const struct particles *ps)
{
    if (ps->resistance == NULL) return;
    if (b->response == NULL)
        b->response = alloc_zeroed((size_t)ps->capacity, sizeof *b->response);
    b->resisted = ps->resisted;
}

void bodies_fetch(struct bodies *b, const struct particles *ps, int begin,
                  int end)
{
    for (int i = begin; i < end; i++) {
        const double R = 0.5 * ps->d[i], per_mass = 1.0 / ps->m[i];
        double *const x = b->place[i], *const v = b->motion[i];
        double *const a = b->push[i];

        x[0] = ps->x[i], x[1] = ps->y[i], x[2] = ps->z[i], x[3] = R;
        v[0] = ps->vx[i], v[1] = ps->vy[i], v[2] = ps->vz[i], v[3] = 1.0 / R;
        v[4] = R * ps->wx[i], v[5] = R * ps->wy[i], v[6] = R * ps->wz[i];
        v[7] = per_mass;
        a[0] = ps->ex[i] * per_mass;
        a[1] = ps->ey[i] * per_mass;
        a[2] = ps->ez[i] * per_mass;
    }
    if (b->response != NULL) response_fetch(b, ps, begin, end);
}

double bodies_inside(const struct domain *box, int k, double x)
{
    return x - box->length[k] * floor((x - box->lo[k]) * box->inverse[k]);
}

void bodies_park(const struct bodies *b, struct particles *ps, int begin,
                 int end)
{
    for (int i = begin; i < end; i++) {
        const double *const x = b->place[i], *const v = b->motion[i];

        ps->x[i] = bodies_inside(&b->box, 0, x[0]);
        ps->y[i] = bodies_inside(&b->box, 1, x[1]);
        ps->z[i] = bodies_inside(&b->box, 2, x[2]);
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
        double *restrict const x = b->place[i];
        double *restrict const v = b->motion[i];
        const double *restrict const a = b->push[i];
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

/* A particle is lost when it is wholly outside, its centre a radius beyond a
 * wall, or when it is nowhere: a comparison with NaN is false. */
static int inside(const struct domain *box, const double x[4])
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

struct bodies_survey bodies_look(const struct bodies *b, int begin, int end)
{
    struct bodies_survey found = {0.0, 0, -1, -1};

    for (int i = begin; i < end; i++) {
        double moved2 = 0.0;

        for (int k = 0; k < 3; k++) {
            const double dx = b->place[i][k] - b->mark[i][k];
            const double L = b->box.length[k];
            const double nearest = dx - L * rint(dx * b->box.inverse[k]);
            moved2 += nearest * nearest;
        }
        if (moved2 > found.moved2) found.moved2 = moved2;
        if (inside(&b->box, b->place[i]) && finite(b->motion[i])) continue;
        if (found.lost++ == 0) found.first = i;
    }
    return found;
}

void bodies_mark(struct bodies *b, int begin, int end)
{
    for (int i = begin; i < end; i++)
        for (int k = 0; k < 3; k++)
            b->mark[i][k] = b->place[i][k];
}

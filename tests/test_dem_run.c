/* SPDX-License-Identifier: GPL-3.0-or-later */
/* dem_run with whole particle sets: none or one particle, lost particles,
 * periodic boxes, a saved and restored state, and its report. */
#include <stdlib.h>
#include <unistd.h>

#include "dem/dem_method.h"
#include "dem/integrator.h"
#include "dem/surfaces/surface.h"
#include "facts.h"
#include "capture.h"
#include "spheres.h"

FACT(no_particle_at_all_is_no_trouble)
{
    struct particles *const ps = particles_create(0);
    const struct dem_options o = spheres_options(&contact_hertz, 1e-5, 0.1);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    ck_assert_int_eq(dem_run(dem, 10, &r), 0);
    ck_assert_int_eq(r.contacts, 0);
    ck_assert_int_eq(r.lost, 0);
    ck_assert_int_eq(r.lost_id, -1);
    dem_free(dem);
    particles_free(ps);
}

/* Velocity Verlet is exact for a parabola: rounding only. */
FACT(xs11_2_1_one_particle_flies_a_parabola_in_any_direction)
{
    struct particles *const ps = particles_create(1);
    const struct dem_options o = spheres_options(&contact_linear, 1e-4, 1.0);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    spheres_add(ps, 0.1, 0.2, 0.3, 0.01);
    spheres_throw(ps, 0, 0.4, -0.5, 0.6);
    ps->ex[0] = 3.0 * ps->m[0];
    ps->ey[0] = 2.0 * ps->m[0];
    ps->ez[0] = -1.0 * ps->m[0];
    dem_changed(dem);
    for (int k = 0; k < 30; k++)
        ck_assert_int_eq(dem_run(dem, 100, &r), 0);
    ck_assert_int_eq(r.steps, 100);
    ck_assert_double_eq_tol(ps->x[0], 0.1 + 0.12 + 0.5 * 3.0 * 0.09, 1e-13);
    ck_assert_double_eq_tol(ps->y[0], 0.2 - 0.15 + 0.5 * 2.0 * 0.09, 1e-13);
    ck_assert_double_eq_tol(ps->z[0], 0.3 + 0.18 - 0.5 * 1.0 * 0.09, 1e-13);
    ck_assert_double_eq_tol(ps->vx[0], 0.4 + 0.9, 1e-13);
    ck_assert_double_eq_tol(
        r.translation, 0.5 * ps->m[0] * (1.3 * 1.3 + 0.1 * 0.1 + 0.3 * 0.3),
        1e-12 * ps->m[0]);
    ck_assert_double_eq_tol(r.max_speed, sqrt(1.69 + 0.01 + 0.09), 1e-12);
    dem_free(dem);
    particles_free(ps);
}

/* --- lost -------------------------------------------------------------------
 */

/* A cloud of 27 in which number 11 gets a wrong position or velocity along k.
 */
static int run_with_a_fool(int k, double x, double v, double force,
                           struct dem_report *r)
{
    struct particles *const ps = spheres_cloud(3, 0.01, 0.5, 0.03, 0.5, 2);
    const struct dem_options o = spheres_options(&contact_hertz, 1e-5, 0.1);
    struct dem *const dem = dem_create(ps, &o);

    ck_assert_int_eq(dem_run(dem, 20, r), 0);
    const int i = spheres_place(ps, 11);
    ps->x[i] += x;
    (k == 0 ? ps->vx : k == 1 ? ps->vy : ps->vz)[i] += v;
    ps->ex[i] += force;
    const int code = dem_run(dem, 200, r);
    dem_free(dem);
    particles_free(ps);
    return code;
}

FACT_FOR_EACH(a_particle_that_shoots_through_a_wall_is_reported_with_its_id, 6)
{
    const double sign = _i % 2 == 0 ? 1.0 : -1.0;
    struct dem_report r;

    ck_assert_int_ne(run_with_a_fool(_i / 2, 0.0, sign * 1e7, 0.0, &r), 0);
    ck_assert_int_eq(r.lost, 1);
    ck_assert_int_eq(r.lost_id, 11);
    ck_assert_double_gt(sign * (r.lost_at[_i / 2] - 0.05), 0.055);
    ck_assert_int_lt(r.steps, 200); /* it does not go on without it */
}

FACT_FOR_EACH(a_particle_that_is_not_a_number_is_reported_with_its_id, 6)
{
    const double bad = _i % 2 == 0 ? NAN : HUGE_VAL;
    struct dem_report r;

    ck_assert_int_ne(run_with_a_fool(0, _i / 2 == 0 ? bad : 0.0,
                                     _i / 2 == 1 ? bad : 0.0,
                                     _i / 2 == 2 ? bad : 0.0, &r),
                     0);
    ck_assert_int_eq(r.lost, 1);
    ck_assert_int_eq(r.lost_id, 11);
}

/* One at rest, one thrown at it by `ahead` diameters a step, from a place where
 * none of the steps ends in a contact: a run of all methods. Beside it, and not
 * through it, there is nothing to report. */
static struct dem_report shoot(int method, double ahead, double beside)
{
    static const char *const methods[] = {"verlet", "all-pairs", "link-cells",
                                          "verlet"};
    struct particles *const ps = particles_create(2);
    struct dem_options o = spheres_options(&contact_linear, 1e-5, 0.05);
    struct dem_report r;

    o.method = dem_method_named(methods[method]);
    if (method == 3) o.integrator = integrator_named("heun");
    o.periodic[1] = 1;
    spheres_add(ps, 0.0, 0.0495, 0.0, 1e-3);
    const int i = spheres_add(ps, beside, 0.0495 - 3.5e-3 * ahead, 0.0, 1e-3);
    ps->vy[i] = ahead * 1e-3 / o.step;
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 7, &r) != 0, r.crossing.found);
    if (r.crossing.found) /* Heun's method looks before a step */
        ck_assert_int_eq(r.steps, method == 3 ? 4 : 3);
    dem_free(dem);
    particles_free(ps);
    return r;
}

FACT_FOR_EACH(two_that_pass_through_each_other_within_a_step_are_reported, 4)
{
    const struct dem_report r = shoot(_i, 3.0, 0.0);

    ck_assert_int_eq(r.crossing.found, 1);
    ck_assert_int_eq(r.crossing.id[0], 1);
    ck_assert_int_eq(r.crossing.id[1], 0);
    ck_assert_int_eq(shoot(_i, 3.0, 0.9e-3).crossing.found, 1);
    ck_assert_int_eq(shoot(_i, 3.0, 1.1e-3).crossing.found, 0);
}

/* --- periodic boxes
 * ------------------------------------------------------------ */

/* All particles shifted along a periodic box, by parts that put its seams
 * elsewhere, move alike; a few collisions let 1e-17 m grow. */
FACT_FOR_EACH(a_periodic_box_has_no_seam, 2)
{
    static const double shift[3] = {0.3 * 0.12, 0.55 * 0.12, 0.7 * 0.12};
    struct particles *here, *there;
    struct dem_options o = spheres_options(contact_laws[_i], 2e-5, 0.06);
    struct particles **const both[2] = {&here, &there};

    o.material.friction = 0.3;
    o.material.restitution = 0.9;
    o.skin = 0.001;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = 1;
    for (int k = 0; k < 2; k++) {
        struct particles *const ps =
            spheres_cloud(6, 0.008, 1.0, 0.0199, 2.0, 8);
        struct dem_report r;
        *both[k] = ps;
        for (int i = 0; i < ps->n && k == 1; i++) {
            ps->x[i] += shift[0];
            ps->y[i] += shift[1];
            ps->z[i] += shift[2];
        }
        struct dem *const dem = dem_create(ps, &o);
        ck_assert_int_eq(dem_run(dem, 400, &r), 0);
        ck_assert_int_gt(r.contacts, 5);
        dem_free(dem);
    }
    for (int id = 0; id < here->n; id++) {
        const int i = spheres_place(here, id), j = spheres_place(there, id);
        const double dx = there->x[j] - here->x[i] - shift[0];
        ck_assert_double_eq_tol(dx, 0.12 * rint(dx / 0.12), 1e-9);
        ck_assert_double_eq_tol(there->vz[j], here->vz[i], 1e-7);
        ck_assert_double_eq_tol(there->wx[j], here->wx[i], 1e-4);
        ck_assert(fabs(there->x[j]) <= 0.06 && fabs(here->z[i]) <= 0.06);
    }
    particles_free(here);
    particles_free(there);
}

/* 216 particles, 400 steps, each rounding 2 m/s. */
FACT_FOR_EACH(a_periodic_box_keeps_its_momentum, 2)
{
    struct particles *const ps = spheres_cloud(6, 0.008, 1.0, 0.0199, 2.0, 8);
    struct dem_options o = spheres_options(contact_laws[_i], 2e-5, 0.06);
    struct dem_report r;
    double p[2] = {0.0, 0.0}, mass = 0.0;

    o.material.friction = 0.3;
    for (int k = 0; k < 3; k++)
        o.periodic[k] = 1;
    struct dem *const dem = dem_create(ps, &o);
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < ps->n; i++)
            p[k] += ps->m[i] * ps->vy[i];
        if (k == 0) ck_assert_int_eq(dem_run(dem, 400, &r), 0);
    }
    for (int i = 0; i < ps->n; i++)
        mass += ps->m[i];
    ck_assert_double_eq_tol(p[0], p[1], 1e-13 * mass);
    dem_free(dem);
    particles_free(ps);
}

/* Else two spheres could touch on both sides, and only one would count. */
FACT(a_periodic_box_too_short_for_two_spheres_is_refused_with_a_message)
{
    static char said[CAPTURE_TEXT];
    struct particles *const ps = spheres_cloud(2, 0.01, 0.0, 0.02, 0.0, 1);
    struct dem_options o = spheres_options(&contact_hertz, 1e-5, 0.05);

    o.periodic[1] = 1;
    o.hi[1] = o.lo[1] + 0.018;
    struct capture c = capture_begin(STDERR_FILENO);
    struct dem *const dem = dem_create(ps, &o);
    capture_end(&c, said);
    ck_assert_ptr_null(dem);
    ck_assert_ptr_nonnull(strstr(said, "periodic direction y"));
    ck_assert_ptr_nonnull(strstr(said, "0.018 m"));
    particles_free(ps);
}

/* --- the report and the pieces of a run
 * ------------------------------------------ */

/* 5 % of the mean diameter of 10 and 14 mm, and of the wall's one sphere. */
FACT_FOR_EACH(overlaps_are_reported_over_the_mean_diameter, 2)
{
    const int wall = _i;
    struct particles *const ps = particles_create(2);
    const struct dem_options o = spheres_options(&contact_linear, 1e-9, 0.1);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    spheres_add(ps, 0.0, 0.0, wall ? -0.1 + 0.45 * 0.01 : 0.0, 0.01);
    if (!wall) spheres_add(ps, 0.0, 0.95 * 0.012, 0.0, 0.014);
    dem_changed(dem);
    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    ck_assert_double_eq_tol(r.max_overlap, 0.05, 1e-9);
    ck_assert_int_eq(r.contacts, 1);
    dem_free(dem);
    particles_free(ps);
}

/* Two spheres across a periodic end, one in a wall, one in a plane, among many
 * without contacts: 20 % of the mean diameter, while 10 % are expected. */
FACT_FOR_EACH(the_deepest_overlap_is_known_with_its_two_and_its_place, 3)
{
    const struct surface floor = {.shape = &surface_plane,
                                  .normal = {0.0, 0.0, 1.0},
                                  .point = {0.0, 0.0, -0.05}};
    static const double x[3][3] = {
        {0.096, 0.0, 0.0}, {0.0, 0.097, 0.0}, {0.0, 0.0, -0.047}};
    static const int other[3] = {28, -1 - 3, -7};
    struct particles *const ps = particles_create(29);
    struct dem_options o = spheres_options(&contact_linear, 1e-9, 0.1);

    o.periodic[0] = 1;
    o.surfaces = &floor;
    o.n_surfaces = 1;
    for (int k = 0; k < 27; k++)
        spheres_add(ps, 0.02 * (k % 3), 0.02 * (k / 3 % 3),
                    0.02 * (k / 9) + 0.02, 0.01);
    spheres_add(ps, x[_i][0], x[_i][1], x[_i][2], 0.01);
    if (_i == 0) spheres_add(ps, -0.096, 0.0, 0.0, 0.01);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;
    dem_limit_overlap(dem, 0.1, 0.5);
    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    ck_assert_double_eq_tol(r.max_overlap, 0.2, 1e-6);
    const struct dem_overlap deep = dem_deepest(dem);
    ck_assert_double_eq_tol(deep.depth, 0.2, 1e-6);
    const int first = deep.id == 27;
    ck_assert_int_eq(first ? deep.id : deep.other, 27);
    ck_assert_int_eq(first ? deep.other : deep.id, other[_i]);
    for (int k = 0; k < 3; k++)
        ck_assert_double_eq_tol(fabs(deep.at[k]), fabs(x[_i][k]), 1e-6);
    dem_limit_overlap(dem, 0.1, 0.15);
    ck_assert_int_ne(dem_run(dem, 1, &r), 0);
    ck_assert_int_eq(r.lost, 0);
    dem_limit_overlap(dem, 0.25, 0.5);
    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    ck_assert_int_eq(dem_deepest(dem).id, -1);
    dem_free(dem);
    particles_free(ps);
}

/* cfx is what moved it: a sphere at rest in the air above a spring's end. */
FACT(ls_4_4_the_contact_force_of_the_last_step_can_be_seen)
{
    struct particles *const ps = particles_create(1);
    const struct dem_options o = spheres_options(&contact_linear, 1e-9, 0.1);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report r;

    spheres_add(ps, 0.0, 0.096, 0.0, 0.01); /* 1 mm in a wall of 1e4 N/m */
    dem_changed(dem);
    ck_assert_int_eq(dem_run(dem, 1, &r), 0);
    ck_assert_double_eq_tol(ps->cfy[0], -10.0, 1e-6);
    ck_assert_double_eq(ps->cfx[0], 0.0);
    dem_free(dem);
    particles_free(ps);
}

static struct particles *pressed_heap(void)
{
    struct particles *const ps = spheres_cloud(4, 0.01, 0.6, 0.013, 1.0, 4);

    for (int i = 0; i < ps->n; i++) {
        ps->ey[i] = -50.0 * ps->m[i];
        spheres_spin(ps, i, 20.0 * (i % 3), 10.0, -15.0 * (i % 2));
    }
    return ps;
}

static struct dem_options heap_options(void)
{
    struct dem_options o = spheres_options(&contact_hertz, 2e-5, 0.04);

    o.material.friction = 0.5;
    o.material.restitution = 0.6;
    return o;
}

static double farthest_apart(const struct particles *a,
                             const struct particles *b)
{
    double most = 0.0;

    for (int id = 0; id < a->n; id++) {
        const int i = spheres_place(a, id), j = spheres_place(b, id);
        most = fmax(most, fabs(a->x[i] - b->x[j]));
        most = fmax(most, fabs(a->y[i] - b->y[j]));
        most = fmax(most, fabs(a->z[i] - b->z[j]));
    }
    return most;
}

/* Two half kicks are one but for rounding, which 300 steps of a heap amplify.
 * A tangential displacement lost between two runs would move them by more than
 * 1e-6. */
FACT(a_run_may_be_cut_into_pieces)
{
    struct particles *whole = pressed_heap(), *cut = pressed_heap();
    const struct dem_options o = heap_options();
    struct dem *const one = dem_create(whole, &o);
    struct dem *const many = dem_create(cut, &o);
    struct dem_report r;

    ck_assert_int_eq(dem_run(one, 300, &r), 0);
    ck_assert_int_gt(r.contacts, 10);
    for (int k = 0; k < 60; k++)
        ck_assert_int_eq(dem_run(many, 5, &r), 0);
    ck_assert_double_lt(farthest_apart(whole, cut), 1e-11);
    dem_free(one);
    dem_free(many);
    particles_free(whole);
    particles_free(cut);
}

static void copy_state(struct particles *to, const struct particles *from)
{
    double *const t[] = {to->x,  to->y,  to->z,  to->vx, to->vy, to->vz, to->wx,
                         to->wy, to->wz, to->ex, to->ey, to->ez, to->d,  to->m};
    const double *const f[] = {from->x,  from->y,  from->z,  from->vx, from->vy,
                               from->vz, from->wx, from->wy, from->wz, from->ex,
                               from->ey, from->ez, from->d,  from->m};

    memcpy(to->id, from->id, (size_t)from->n * sizeof *to->id);
    for (size_t a = 0; a < sizeof t / sizeof *t; a++)
        memcpy(t[a], f[a], (size_t)from->n * sizeof *t[a]);
}

/* A state is the particles and the springs of their contacts: from both, a new
 * dem goes on as the old one would have. Elastic spheres, because in the first
 * half kick the force of a dashpot would be computed with velocities half a
 * step newer. */
FACT_FOR_EACH(springs_taken_out_and_put_back_continue_a_run, 2)
{
    struct particles *const ps = pressed_heap();
    struct particles *const copy = pressed_heap();
    struct dem_options o = heap_options();
    struct dem_report r;
    int n;

    o.material.restitution = 1.0;
    struct dem *const dem = dem_create(ps, &o);
    ck_assert_int_eq(dem_run(dem, 2000, &r), 0);
    struct dem_history *const springs = dem_histories(dem, &n);
    ck_assert_int_eq(n, r.contacts);
    copy_state(copy, ps);
    struct dem *const next = dem_create(copy, &o);
    if (_i == 0) dem_restore_histories(next, springs, n);
    ck_assert_int_eq(dem_run(dem, 200, &r), 0);
    ck_assert_int_eq(dem_run(next, 200, &r), 0);
    if (_i == 0) ck_assert_double_lt(farthest_apart(ps, copy), 1e-11);
    /* without the state it differs: contacts with history exist here */
    if (_i == 1) ck_assert_double_gt(farthest_apart(ps, copy), 1e-7);
    dem_free(dem);
    dem_free(next);
    free(springs);
    particles_free(ps);
    particles_free(copy);
}

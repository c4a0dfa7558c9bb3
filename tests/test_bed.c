/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bed before time 0: settled, the same from the same seed, and the same
 * from its file, which is refused if it was made for another case. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "dem/bed.h"
#include "case/resume/resume.h"
#include "dem/population/sizes.h"

#include "facts.h"
#include "capture.h"
#include "kept.h"

/* A temporary file that does not exist yet. */
static void temporary(char path[64])
{
    snprintf(path, 64, "/tmp/winnow-test-bed-%ld", (long)getpid());
    unlink(path);
}

static struct bed_options small_bed(void)
{
    const struct bed_options bed = {.count = 120,
                                    .diameter = 2e-3,
                                    .density = 1500.0,
                                    .seed = 3,
                                    .jitter = 0.5,
                                    .gravity = {0.0, -9.81, 0.0},
                                    .settle = 0.5};
    return bed;
}

static struct dem_options small_box(void)
{
    const struct dem_options o = {
        .law = contact_law_named("linear"),
        .material = {.stiffness = 200.0, .restitution = 0.9, .friction = 0.3},
        .step = 2e-5,
        .hi = {0.0125, 0.06, 0.0105}};
    return o;
}

static struct particles *made(const char *file, const struct bed_options *bed,
                              struct bed_report *r, int steps)
{
    const struct dem_options o = small_box();
    struct particles *const ps = particles_create(bed->count);
    struct dem *const dem = dem_create(ps, &o);
    struct dem_report moved;

    struct input in = file != NULL ? input_of(file) : (struct input){0};
    ck_assert_int_eq(
        bed_cache_create(file != NULL ? &in : NULL, ps, dem, bed, &o, r),
        BED_CREATED);
    input_release(&in);
    for (int i = 0; i < ps->n; i++)
        ps->ey[i] = -9.81 * ps->m[i];
    if (steps > 0) ck_assert_int_eq(dem_run(dem, steps, &moved), 0);
    dem_free(dem);
    return ps;
}

static int same(const struct particles *a, const struct particles *b)
{
    const size_t size = (size_t)a->n * sizeof(double);

    return a->n == b->n && memcmp(a->x, b->x, size) == 0 &&
           memcmp(a->vy, b->vy, size) == 0 && memcmp(a->wz, b->wz, size) == 0 &&
           memcmp(a->id, b->id, (size_t)a->n * sizeof(int)) == 0;
}

/* Poured spheres fill 0.55 to 0.64; in this small box walls take some, and the
 * order that they bring gives a little. */
FACT(bed_settles_to_a_poured_packing)
{
    const struct bed_options bed = small_bed();
    struct bed_report r;
    struct particles *const ps = made(NULL, &bed, &r, 0);

    ck_assert_int_eq(ps->n, 120);
    ck_assert_int_eq(r.settled, 1);
    ck_assert_double_lt(r.kinetic, BED_SETTLED_ENERGY);
    ck_assert_double_gt(r.packing, 0.48);
    ck_assert_double_lt(r.packing, 0.66);
    ck_assert_double_gt(r.top, r.height);
    ck_assert_double_lt(r.time, 0.5);
    for (int i = 0; i < ps->n; i++)
        ck_assert_double_gt(ps->y[i], 0.9e-3);
    particles_free(ps);
}

/* 0.01 s of the real motion: the floor carries the weight, and no particle
 * rises. The tangential displacements exist from the first step: without them
 * the grains move by 5e-7 m on average, with them by 8e-8 m. */
FACT(bed_stays_at_rest_when_the_run_begins)
{
    char path[64];
    const struct bed_options bed = small_bed();
    struct bed_report r;

    temporary(path); /* settled once: the second time it is read */
    struct particles *const at_0 = made(path, &bed, &r, 0);
    struct particles *const later = made(path, &bed, &r, 500);
    double sum = 0.0, weight = 0.0, moved = 0.0;

    for (int i = 0; i < at_0->n; i++) {
        sum += later->cfy[i];
        weight += 9.81 * later->m[i];
    }
    ck_assert_double_eq_tol(sum / weight, 1.0, 0.02);
    for (int i = 0; i < 120; i++)
        for (int j = 0; j < 120; j++)
            if (at_0->id[i] == later->id[j])
                moved += fabs(at_0->y[i] - later->y[j]) / 120;
    ck_assert_double_lt(moved, 2.5e-7);
    unlink(path);
    particles_free(at_0);
    particles_free(later);
}

FACT(bed_follows_from_its_seed)
{
    struct bed_options bed = small_bed();
    struct bed_report r;
    bed.settle = 0.03; /* while they fall and meet: that shows it as well */
    struct particles *const a = made(NULL, &bed, &r, 5);
    struct particles *const b = made(NULL, &bed, &r, 5);
    bed.seed = 4;
    struct particles *const c = made(NULL, &bed, &r, 5);

    ck_assert(same(a, b));
    ck_assert(!same(a, c));
    particles_free(a);
    particles_free(b);
    particles_free(c);
}

FACT(bed_from_its_file_goes_on_bit_for_bit)
{
    char path[64];
    struct bed_options bed = small_bed();
    struct bed_report made_report, read_report;

    bed.settle = 0.03; /* in motion still: harder than at rest */
    temporary(path);
    struct particles *const a = made(path, &bed, &made_report, 250);
    struct particles *const b = made(path, &bed, &read_report, 250);
    ck_assert_int_gt((int)made_report.steps, 0);
    ck_assert_int_eq((int)read_report.steps, 0);
    ck_assert_double_eq(made_report.height, read_report.height);
    ck_assert(same(a, b));
    unlink(path);
    particles_free(a);
    particles_free(b);
}

/* From a file that is there. */
static int load(const char *path, const struct bed_options *bed,
                const struct dem_options *o)
{
    struct particles *const ps = particles_create(bed->count);
    struct dem *const dem = dem_create(ps, o);
    struct bed_report r;

    ck_assert_int_eq(access(path, R_OK), 0);
    struct input in = input_of(path);
    const int code = bed_cache_create(&in, ps, dem, bed, o, &r);
    input_release(&in);
    dem_free(dem);
    particles_free(ps);
    return code;
}

FACT(bed_of_another_case_is_refused)
{
    char path[64];
    struct bed_options bed = small_bed();
    struct dem_options o = small_box();
    struct bed_report r;

    bed.settle = 0.0;
    temporary(path);
    particles_free(made(path, &bed, &r, 0));
    ck_assert_int_eq(load(path, &bed, &o), BED_CREATED);
    bed.diameter = 2.0000001e-3;
    ck_assert_int_eq(load(path, &bed, &o), BED_REFUSED);
    bed.diameter = 2e-3;
    bed.seed = 4;
    ck_assert_int_eq(load(path, &bed, &o), BED_REFUSED);
    bed.seed = 3;
    o.hi[1] = 0.07;
    ck_assert_int_eq(load(path, &bed, &o), BED_REFUSED);
    o.hi[1] = 0.06;
    o.material.friction = 0.31;
    ck_assert_int_eq(load(path, &bed, &o), BED_REFUSED);
    unlink(path);
}

FACT(half_a_bed_is_refused)
{
    char path[64];
    struct bed_options bed = small_bed();
    const struct dem_options o = small_box();
    struct bed_report r;

    bed.settle = 0.0;
    temporary(path);
    particles_free(made(path, &bed, &r, 0));
    FILE *const f = fopen(path, "r+");
    fseek(f, 0, SEEK_END);
    const long length = ftell(f);
    fclose(f);
    ck_assert_int_eq(truncate(path, length / 2), 0);
    ck_assert_int_eq(load(path, &bed, &o), BED_REFUSED);
    unlink(path);
}

/* Two spheres; saved, an entry of an array changed, and loaded. */
FACT_FOR_EACH(an_impossible_bed_is_refused, 10)
{
    static const struct {
        const char *array;
        int entry;
        double value;
        const char *message;
    } rows[] = {{"id", 0, 1, "an id that is given twice"},
                {"id", 0, 2147483647, "/bed/id = 2147483647; expected 0 to 1"},
                {"id", 0, -1, "/bed/id = -1"},
                {"x", 0, 1e303, "a particle that is not in the box"},
                {"z", 1, -1e-3, "a particle that is not in the box"},
                {"d", 1, 1e300, "a diameter that is not one of the bed's"},
                {"m", 1, 0.0, "a mass that does not belong to its diameter"},
                {"contacts/count", 0, 2147483647, "expected 0 to 300"},
                {"contacts/id", 0, 2, "/bed/contacts/id = 2"},
                {"contacts/other", 0, -7, "expected -6 to 1"}};
    const struct bed_options bed = {
        .count = 2, .diameter = 2e-3, .density = 1500.0};
    const struct dem_options o = small_box();
    struct particles *const ps = particles_create(2);
    struct dem_history one = {.id = 0, .other = 1};
    struct bed_histories histories = {1, &one}, loaded = {0, NULL};
    struct kept *const kept = kept_create();
    char said[CAPTURE_TEXT], path[64];

    ck_assert_int_eq(bed_fill(ps, &bed, &o), 0);
    bed_state(ps, &histories, &bed, &o, &kept->state);
    struct state *const s = kept_load(kept);
    bed_state(ps, &loaded, &bed, &o, s);
    ck_assert_int_eq(s->failed, 0);
    snprintf(path, sizeof path, "/bed/%s", rows[_i].array);
    for (int k = 0; k < kept->n; k++) {
        if (strcmp(kept->array[k].path, path) != 0) continue;
        if (strstr("id contacts/count contacts/id contacts/other",
                   rows[_i].array) != NULL)
            ((int *)kept->array[k].bytes)[rows[_i].entry] = (int)rows[_i].value;
        else
            ((double *)kept->array[k].bytes)[rows[_i].entry] = rows[_i].value;
    }
    struct capture heard = capture_begin(2);
    bed_state(ps, &loaded, &bed, &o, s);
    capture_end(&heard, said);
    ck_assert_int_eq(s->failed, 1);
    ck_assert_msg(strstr(said, rows[_i].message) != NULL, "%s", said);
    free(loaded.list);
    kept_free(kept);
    particles_free(ps);
}

FACT(bed_that_does_not_fit_is_refused)
{
    struct bed_options bed = small_bed();
    const struct dem_options o = small_box();
    struct particles *const ps = particles_create(5000);

    bed.count = 5000;
    ck_assert_int_ne(bed_fill(ps, &bed, &o), 0);
    bed.diameter = 0.014;
    bed.count = 1;
    ck_assert_int_ne(bed_fill(ps, &bed, &o), 0);
    ck_assert_int_eq(ps->n, 0);
    particles_free(ps);
}

/* Half of the mass of 1 mm, half of 2 mm. By number it would be 8 of 9 small;
 * of 120 the share has a standard deviation of 0.03. */
static struct sizes *two_sizes(void)
{
    static const double point[][2] = {{1e-3, 1.0}, {2e-3, 1.0}};
    const struct sizes_options o = {.law = sizes_law_named("discrete"),
                                    .by_mass = 1,
                                    .n = 2,
                                    .point = point};
    return sizes_create(&o);
}

/* At rest under their own weights with their own masses: the mass added to the
 * small ones for settling is removed again, also after sorting. The weight
 * would otherwise be 18 % too large; a bed just settled still oscillates by up
 * to 7 %. */
FACT(bed_of_two_sizes_settles_and_each_has_its_mass)
{
    struct sizes *const sizes = two_sizes();
    struct bed_options bed = small_bed();
    struct bed_report r;
    int small = 0;

    bed.sizes = sizes;
    bed.diameter = sizes_moment(sizes, 1);
    struct particles *const ps = made(NULL, &bed, &r, 1);
    ck_assert_int_eq(r.settled, 1);
    ck_assert_double_gt(r.packing, 0.5);
    ck_assert_double_lt(r.packing, 0.72);
    double sum = 0.0, weight = 0.0;
    for (int i = 0; i < ps->n; i++) {
        const double exact = 1500.0 * particles_volume(ps, i);
        ck_assert(ps->d[i] == 1e-3 || ps->d[i] == 2e-3);
        ck_assert_double_eq_tol(ps->m[i] / exact, 1.0, 1e-14);
        small += ps->d[i] == 1e-3;
        sum += ps->cfy[i];
        weight += 9.81 * ps->m[i];
    }
    ck_assert_double_eq_tol(small / 120.0, 8.0 / 9.0, 0.06);
    ck_assert_double_eq_tol(sum / weight, 1.0, 0.1);
    const struct bed_range range = bed_range(&bed);
    ck_assert_double_eq(range.min, 1e-3);
    ck_assert_double_eq(range.max, 2e-3);
    ck_assert_double_eq_tol(range.volume * 1500.0 * 9.81 / weight, 1.0, 1e-12);
    particles_free(ps);
    owner_free(sizes);
}

FACT(bed_of_other_sizes_is_refused)
{
    char path[64];
    struct sizes *const sizes = two_sizes();
    struct bed_options bed = small_bed();
    const struct dem_options o = small_box();
    struct bed_report r;

    bed.settle = 0.0;
    temporary(path);
    particles_free(made(path, &bed, &r, 0));
    bed.sizes = sizes;
    ck_assert_int_eq(load(path, &bed, &o), BED_REFUSED);
    unlink(path);
    particles_free(made(path, &bed, &r, 0));
    ck_assert_int_eq(load(path, &bed, &o), BED_CREATED);
    unlink(path);
    owner_free(sizes);
}

/* In 2D, in any direction, and without particles. */
FACT(lattice_begins_where_gravity_points)
{
    struct bed_options bed = small_bed();
    struct dem_options o = small_box();
    struct particles *const ps = particles_create(400);

    bed.gravity[1] = 0.0;
    bed.gravity[0] = 9.81;
    bed.count = 40;
    o.hi[2] = 2e-3;
    ck_assert_int_eq(bed_fill(ps, &bed, &o), 0);
    for (int i = 0; i < 40; i++) {
        ck_assert_double_gt(ps->x[i], 0.0125 - 2.1 * 2.04e-3);
        ck_assert_double_le(ps->x[i], 0.0125 - 1e-3);
        ck_assert_double_eq(ps->z[i], 1e-3);
    }
    bed.count = 0;
    ck_assert_int_eq(bed_fill(ps, &bed, &o), 0);
    ck_assert_int_eq(ps->n, 40);
    particles_free(ps);
}

/* Stops the settling before look number `stop`, and saves the bed. */
struct stopper {
    struct kept *kept;
    int looks, stop;
};

static int stop_settling(void *memory, struct bed_settling *b,
                         enum bed_stage when)
{
    struct stopper *const s = memory;

    if (when == BED_STAGE_START && s->kept->n > 0)
        bed_settling_state(b, kept_load(s->kept));
    if (when != BED_STAGE_STEPS || s->looks++ != s->stop) return 0;
    bed_settling_state(b, &s->kept->state);
    return 130;
}

/* Stopped before this look, and let go on. */
static void assert_goes_on(struct bed_options *bed, int stop,
                           const struct particles *whole,
                           const struct bed_report *made_whole)
{
    struct stopper s = {kept_create(), 0, stop};
    struct bed_saver saver = {&s, stop_settling};
    const struct dem_options o = small_box();
    struct particles *const half = particles_create(bed->count);
    struct dem *const dem = dem_create(half, &o);
    struct bed_report r;

    bed->saver = &saver;
    ck_assert_int_eq(bed_cache_create(NULL, half, dem, bed, &o, &r),
                     BED_STOPPED);
    ck_assert_int_eq(r.stopped, 130);
    dem_free(dem);
    particles_free(half);
    s.stop = -1;
    struct particles *const ps = made(NULL, bed, &r, 50);
    ck_assert_int_eq((int)r.steps, (int)made_whole->steps);
    ck_assert_double_eq(r.kinetic, made_whole->kinetic);
    ck_assert(same(whole, ps));
    particles_free(ps);
    kept_free(s.kept);
}

/* Of two sizes, so that masses are added; stopped on the way with the material
 * that dissipates, and in the last look, which has the real one. */
FACT(a_bed_that_is_stopped_settles_on_to_the_same_bits)
{
    struct sizes *const sizes = two_sizes();
    struct bed_options bed = small_bed();
    struct stopper s = {kept_create(), 0, -1};
    const struct bed_saver nobody = {&s, stop_settling};
    struct bed_report r;

    bed.count = 40;
    bed.sizes = sizes;
    bed.diameter = sizes_moment(sizes, 1);
    bed.saver = &nobody;
    struct particles *const whole = made(NULL, &bed, &r, 50);
    assert_goes_on(&bed, 60, whole, &r);
    assert_goes_on(&bed, s.looks - 1, whole, &r);
    kept_free(s.kept);
    particles_free(whole);
    owner_free(sizes);
}

/* Another bit of a number makes another bed, which may be possible. */
FACT(a_bed_file_with_another_bit_is_refused)
{
    struct bed_options bed = small_bed();
    const struct dem_options o = small_box();
    struct bed_report r;
    char path[64], said[CAPTURE_TEXT];

    bed.settle = 0.0;
    temporary(path);
    particles_free(made(path, &bed, &r, 0));
    FILE *const f = fopen(path, "r+");
    fseek(f, -400, SEEK_END);
    const int c = fgetc(f);
    fseek(f, -1, SEEK_CUR);
    fputc(c ^ 1, f);
    fclose(f);
    struct capture capture = capture_begin(2);
    ck_assert_int_eq(load(path, &bed, &o), BED_REFUSED);
    capture_end(&capture, said);
    ck_assert_msg(strstr(said, path) != NULL, "%s", said);
    unlink(path);
}

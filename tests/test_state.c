/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/checkpoint/state_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "dem/particles.h"
#include "base/alloc.h"
#include "facts.h"
#include "kept.h"
#include "scratch.h"

FACTS_IN_A_FOLDER;

/* A part of all kinds of arrays. */
struct part {
    double p[4], t;
    int id[2], n;
    long steps;
    double *none;
    struct {
        int k;
        double x[3];
    } list[2];
};

static void part_state(struct part *a, struct state *s)
{
    state_begin(s, "part");
    state_reals(s, "p", "Pa", a->p, 2, 2);
    state_real(s, "t", "s", &a->t);
    state_wholes(s, "id", "-", a->id, 2, 1);
    state_count(s, "n", &a->n, 3);
    state_long(s, "steps", "-", &a->steps);
    state_reals(s, "none", "-", a->none, 7, 1);
    state_begin_number(s, "list", 1);
    state_wholes_of(s, "k", "-", &a->list->k, sizeof *a->list, 2, 1);
    state_reals_of(s, "x", "m", a->list->x, sizeof *a->list, 2, 3);
    state_end(s);
    state_end(s);
}

static const struct part full = {
    .p = {0.1, -0.0, 1e-300, 1e300},
    .t = 1.0 / 3.0,
    .id = {-7, 2147483647},
    .n = 3,
    .steps = 9007199254740993,
    .list = {{1, {1.0, 2.0, 3.0}}, {2, {4.0, 5.0, 6.0}}}};

static const char *path(void)
{
    return scratch_path(dir, "state");
}

static void save(const struct part *a)
{
    struct part copy = *a;
    struct state_file *const f = state_file_create();

    state_file_put_text(f, "program", "a text");
    part_state(&copy, state_file_state(f));
    struct state_image image = state_file_image(f);
    ck_assert_ptr_nonnull(image.bytes);
    ck_assert_int_eq(
        state_file_write(&image, path(), scratch_path(dir, "before")), 0);
    free(image.bytes);
}

FACT(the_visit_that_saves_loads_the_same_bits)
{
    struct part a = {.t = 0.0};
    const char *why;

    save(&full);
    struct state_file *const f = state_file_open(path(), &why);
    ck_assert_ptr_nonnull(f);
    part_state(&a, state_file_state(f));
    ck_assert_int_eq(state_file_state(f)->failed, 0);
    ck_assert_int_eq(state_file_all_visited(f), 0);
    char *const text = state_file_text(f, "program");
    ck_assert_str_eq(text, "a text");
    ck_assert_mem_eq(a.p, full.p, sizeof a.p);
    ck_assert(a.t == full.t && a.n == full.n && a.steps == full.steps);
    ck_assert_mem_eq(a.id, full.id, sizeof a.id);
    for (int i = 0; i < 2; i++) {
        ck_assert_int_eq(a.list[i].k, full.list[i].k);
        ck_assert_mem_eq(a.list[i].x, full.list[i].x, sizeof a.list[i].x);
    }
    free(text);
    state_file_free(f);
}

FACT(a_single_number_is_found_by_its_name_whatever_its_type)
{
    const char *why;

    save(&full);
    struct state_file *const f = state_file_open(path(), &why);
    ck_assert(state_file_number(f, "/part/t") == full.t);
    ck_assert(state_file_number(f, "/part/n") == full.n);
    ck_assert(state_file_number(f, "/part/steps") == (double)full.steps);
    ck_assert(isnan(state_file_number(f, "/part/p"))); /* four of them */
    ck_assert(isnan(state_file_number(f, "/part/none")));
    state_file_free(f);
}

/* One flipped bit in any byte: every 7th is tried. */
FACT(a_damaged_file_is_noticed_whichever_byte_it_is)
{
    size_t size = 0;
    const char *why;

    save(&full);
    char *const bytes = scratch_read(path(), &size);
    for (size_t i = 0; i < size; i += 7) {
        bytes[i] = (char)(bytes[i] ^ 4);
        FILE *const f = fopen(path(), "wb");
        fwrite(bytes, 1, size, f);
        fclose(f);
        ck_assert_ptr_null(state_file_open(path(), &why));
        ck_assert_ptr_nonnull(strstr(why, "damaged"));
        bytes[i] = (char)(bytes[i] ^ 4);
    }
    free(bytes);
}

FACT(half_a_file_is_noticed_and_none_has_no_reason)
{
    size_t size = 0;
    const char *why;

    save(&full);
    char *const bytes = scratch_read(path(), &size);
    for (size_t part = 0; part < 10; part++) {
        FILE *const f = fopen(path(), "wb");
        fwrite(bytes, 1, size * part / 10, f);
        fclose(f);
        ck_assert_ptr_null(state_file_open(path(), &why));
        ck_assert_ptr_nonnull(why);
    }
    remove(path());
    ck_assert_ptr_null(state_file_open(path(), &why));
    ck_assert_ptr_null(why);
    free(bytes);
}

FACT(the_file_of_before_is_kept_beside_the_new_one)
{
    struct part later = full, a = {.t = 0.0};
    const char *why;

    later.t = 2.0;
    save(&full);
    save(&later);
    struct state_file *const f =
        state_file_open(scratch_path(dir, "before"), &why);
    part_state(&a, state_file_state(f));
    ck_assert(a.t == full.t);
    state_file_free(f);
}

/* Loads with one thing that is not as in the file; the message has `said`. */
static void refused(void (*visit)(struct state *s), const char *said)
{
    const char *why;

    save(&full);
    struct state_file *const f = state_file_open(path(), &why);
    scratch_listen(dir);
    visit(state_file_state(f));
    const int failed = state_file_state(f)->failed || state_file_all_visited(f);
    char *const heard = scratch_heard(dir);
    ck_assert_int_ne(failed, 0);
    ck_assert_ptr_nonnull(strstr(heard, said));
    ck_assert_ptr_nonnull(strstr(heard, "; another version of the program"));
    ck_assert_ptr_nonnull(strstr(heard, "without --resume\n"));
    free(heard);
    state_file_free(f);
}

static void visit_longer(struct state *s)
{
    double p[6];
    state_reals(s, "part/p", "Pa", p, 3, 2);
}

static void visit_other(struct state *s)
{
    double q;
    state_real(s, "part/q", "Pa", &q);
}

static void visit_count(struct state *s)
{
    int n = 0;
    state_count(s, "part/n", &n, 2);
    ck_assert_int_eq(n, 0);
}

static void visit_some(struct state *s)
{
    double t;
    state_real(s, "part/t", "s", &t);
}

FACT_FOR_EACH(a_state_of_another_case_is_refused, 4)
{
    static const struct {
        void (*visit)(struct state *s);
        const char *said;
    } cases[] = {{visit_longer, "/part/p has another number of entries"},
                 {visit_other, "/part/q is not there"},
                 {visit_count, "part/n = 3; expected 0 to 2"},
                 {visit_some, "of which this case knows 1"}};

    refused(cases[_i].visit, cases[_i].said);
}

/* A name for two arrays would lose one of them. */
FACT(two_arrays_of_one_name_cannot_be_saved)
{
    double a = 1.0, b = 2.0;
    struct state_file *const f = state_file_create();
    struct state *const s = state_file_state(f);

    scratch_listen(dir);
    state_real(s, "a", "-", &a);
    state_real(s, "a", "-", &b);
    ck_assert_int_eq(s->failed, 1);
    struct state_image image = state_file_image(f);
    ck_assert_ptr_null(image.bytes);
}

/* Whoever attaches an array to the particles need not think of this. */
FACT(every_array_that_is_attached_is_saved_and_loaded)
{
    static const double zero[3] = {0.0, 0.0, 0.0};
    struct particles *const ps = particles_create(2);
    struct kept *const kept = kept_create();
    double one[2] = {1.0, 2.0}, other[6] = {3.0, 4.0, 5.0, 6.0, 7.0, 8.0};
    const double was[6] = {3.0, 4.0, 5.0, 6.0, 7.0, 8.0};

    particles_attach(ps, "one", "-", one, 1);
    particles_attach(ps, "one", "-", other, 3); /* of the same name */
    for (int i = 0; i < 2; i++)
        particles_add(ps, zero, 0.1, 1000.0);
    one[0] = 1.0, one[1] = 2.0;
    memcpy(other, was, sizeof other);
    particles_state(ps, &kept->state);
    memset(one, 0, sizeof one);
    memset(other, 0, sizeof other);
    particles_state(ps, kept_load(kept));
    ck_assert_int_eq(kept->state.failed, 0);
    ck_assert_double_eq(one[1], 2.0);
    ck_assert_mem_eq(other, was, sizeof other);
    kept_free(kept);
    particles_free(ps);
}

/* The room that HDF5 makes the file in becomes the image. */
FACT(the_image_of_a_state_takes_no_second_copy)
{
    enum { N = 4000000 };
    double *const x = alloc_doubles(N);
    const double before = alloc_peak();
    struct state_file *const f = state_file_create();
    struct state *const s = state_file_state(f);

    state_begin(s, "part");
    state_reals(s, "x", "m", x, N, 1);
    state_end(s);
    struct state_image image = state_file_image(f);
    ck_assert_ptr_nonnull(image.bytes);
    ck_assert(image.size > N * sizeof *x);
#ifdef __SANITIZE_ADDRESS__ /* which keeps what is freed */
    ck_assert_double_gt(alloc_peak(), before);
#else
    ck_assert_double_lt(alloc_peak() - before, 1.5 * N * sizeof *x);
#endif
    free(image.bytes);
    free(x);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/plan.h"

#include "base/alloc.h"
#include "base/number.h"
#include "case/case_file.h"
#include "case/schema.h"
#include "study/study.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_RUNS = 10000 };

/* How the path of a seed ends. */
#define SEED ".seed"

/* --- what a run gets besides its choices --------------------------------- */

/* Of a fluid, and where the history has its own interval, nothing depends on
 * how often pictures are written: those of the start and the end will do. */
static int needs_few_pictures(const struct settings *s)
{
    return s->has.fluid || s->output.history > 0.0;
}

static void add_output(struct plan *p, const struct settings *s)
{
    char end[NUMBER_LENGTH];

    texts_add(&p->fixed, "output.picture=false");
    if (needs_few_pictures(s))
        texts_add(&p->fixed, "output.every=%s",
                  number_text(s->output.end, end));
}

struct settings *plan_case(const struct plan *p, const struct texts *set,
                           int *code)
{
    return case_file_read(p->words.case_file, set->n,
                          (const char *const *)set->text, code);
}

/* Adds what sets the seed of a group of the case, or those of a list, to so
 * much more than it is. */
static void add_seed(const struct settings *s, const char *path, int more,
                     struct texts *set)
{
    const int length = (int)(strlen(path) - strlen(SEED));
    char *const group = strndup(path, (size_t)length);
    const int there = settings_has(s, group);

    if (there && settings_is_list(s, group))
        for (int i = 0; i < settings_length(s, group); i++)
            texts_add(set, "%s.%d" SEED "=%d", group, i,
                      settings_item_int(s, group, i, &SEED[1]) + more);
    else if (there)
        texts_add(set, "%s=%d", path, settings_int(s, path) + more);
    free(group);
}

static int is_seed(const char *path)
{
    const size_t n = strlen(path), m = strlen(SEED);

    return n > m && strcmp(path + n - m, SEED) == 0;
}

/* The seeds of all groups that the case has with these overrides. */
static int add_seeds(const struct plan *p, int more, struct texts *set)
{
    const struct key *tables[CASE_FILE_TABLES];
    int code;
    struct settings *const s = plan_case(p, set, &code);

    if (s == NULL) return code;
    case_file_tables(tables);
    SCHEMA_EACH (key, tables)
        if (is_seed(key->path)) add_seed(s, key->path, more, set);
    settings_free(s);
    return 0;
}

int plan_overrides(const struct plan *p, int variant, int seed,
                   struct texts *set)
{
    for (int i = 0; i < p->fixed.n; i++)
        texts_add(set, "%s", p->fixed.text[i]);
    choices_overrides(&p->choices, variant, PLAN_THREADS, set);
    /* Last, for a choice may be the group that a seed stands in. */
    return p->words.seeds > 1 ? add_seeds(p, seed, set) : 0;
}

/* --seeds set all seeds that there are; one in some variant, which nothing else
 * varies. */
static int check_seeds(const struct plan *p)
{
    const struct choices *const c = &p->choices;
    int found = 0, code = 0;

    for (int i = 0; i < c->n; i++)
        for (int k = 0; k < c->of[i].key.n && c->of[i].n > 1; k++)
            if (is_seed(c->of[i].key.text[k]))
                return study_wrong(
                    "%s: is varied, so that --seeds cannot set it",
                    c->of[i].key.text[k]);
    for (int v = 0; v < choices_variants(c) && code == 0 && !found; v++) {
        struct texts set = {0};
        code = plan_overrides(p, v, 0, &set);
        found = set.n > 0 && strstr(set.text[set.n - 1], SEED "=") != NULL;
        texts_free(&set);
    }
    return code != 0 || found
               ? code
               : study_wrong("--seeds: the case has no group with a seed, such "
                             "as particles.bed or particles.insert");
}

/* --- the plan as a whole -------------------------------------------------- */

static int check_threads(const struct plan *p)
{
    for (int v = 0; v < choices_variants(&p->choices); v++) {
        const char *const text = choices_value(&p->choices, v, PLAN_THREADS);
        char *end;

        if (text == NULL) return 0;
        const long n = strtol(text, &end, 10);
        if (*end != '\0' || n < 1 || n > 1024)
            return study_wrong(PLAN_THREADS " asks for numbers from 1 to 1024");
    }
    return 0;
}

static int add_choices(struct plan *p)
{
    for (int i = 0; i < p->words.n_choices; i++)
        if (choices_add(&p->choices, p->words.choice[i]) != 0) return 2;
    const int n = choices_variants(&p->choices);
    if (n < 2)
        return study_wrong("nothing to compare: give a key several values, -s "
                           "key=value,value,...");
    if (p->words.jobs == 0) /* runs of several threads one after the other */
        p->words.jobs = choices_value(&p->choices, 0, PLAN_THREADS) != NULL
                            ? 1
                            : omp_get_num_procs();
    if ((double)n * p->words.seeds * p->words.times > MOST_RUNS)
        return study_wrong("more than %d runs", MOST_RUNS);
    return check_threads(p);
}

/* 1 if the last three entries of a choice are numbers in order. */
static int ends_in_three_sizes(const struct choice *c)
{
    for (int i = c->n - 3; i < c->n; i++)
        if (i < 0 || isnan(choices_size(c, i))) return 0;
    return 1;
}

static int check_truth(const struct plan *p, const struct truth *t)
{
    const int axis = choices_axis(&p->choices);

    if (t->kind != TRUTH_EXTRAPOLATED ||
        (axis >= 0 && ends_in_three_sizes(&p->choices.of[axis])))
        return 0;
    return study_wrong("extrapolated: asks for a key with three numbers or "
                       "more, rising or falling");
}

static int add_cost(struct plan *p, const struct settings *s)
{
    const char *const cost = p->words.cost != NULL ? p->words.cost : PLAN_COST;
    const int code = measure_parse(&p->cost, cost, s);

    return code == 0 && p->cost.how == MEASURE_CURVE
               ? study_wrong("--cost %s: is a curve, and a run costs one "
                             "number",
                             cost)
               : code;
}

static int add_measures(struct plan *p, const struct settings *s)
{
    const struct study_words *const w = &p->words;

    if (w->n_measures == 0)
        return study_wrong("what is to be looked at? Give --measure NAME, a "
                           "column of history.csv or a number of summary.json");
    for (int i = 0; i < w->n_measures; i++) {
        const char *const own =
            w->truth[i] != NULL ? w->truth[i] : w->truth[w->n_measures - 1];
        int code = measure_parse(&p->measure[i], w->measure[i], s);

        if (code == 0)
            code = truth_parse(&p->truth[i], own != NULL ? own : "finest");
        p->n_measures = i + 1;
        if (code == 0) code = check_truth(p, &p->truth[i]);
        if (code != 0) return code;
    }
    return add_cost(p, s);
}

int plan_cost_is_processor(const struct plan *p)
{
    return strcmp(p->cost.name, PLAN_COST) == 0;
}

/* out/study-NAME for some/where/NAME.cfg. */
static const char *plan_default_dir(struct study_words *w)
{
    const char *const slash = strrchr(w->file, '/');
    const char *const name = slash != NULL ? slash + 1 : w->file;
    const char *const dot = strrchr(name, '.');

    return texts_add(&w->made, "out/study-%.*s",
                     (int)(dot > name ? (size_t)(dot - name) : strlen(name)),
                     name);
}

static void tell_reversed(const struct plan *p)
{
    for (int i = 0; i < p->choices.n; i++) {
        const struct choice *const c = &p->choices.of[i];
        if (!p->words.quiet && choices_is_reversed(c))
            fprintf(stderr,
                    "%s goes from fine to coarse; its last value, %s, counts "
                    "as the finest\n",
                    c->key.text[0], choices_in_entry(c, c->n - 1, 0));
    }
}

static int plan_complete(struct plan *p)
{
    struct study_words *const w = &p->words;
    struct texts first = {0};
    int code = add_choices(p);

    if (code != 0) return code;
    choices_overrides(&p->choices, 0, PLAN_THREADS, &first);
    struct settings *const s = plan_case(p, &first, &code);
    texts_free(&first);
    if (s == NULL) return code;
    code = add_measures(p, s);
    if (code == 0) tell_reversed(p);
    if (code == 0) add_output(p, s);
    if (code == 0 && w->seeds > 1) code = check_seeds(p);
    if (w->title == NULL) w->title = texts_add(&w->made, "%s", s->title);
    if (w->dir == NULL) w->dir = plan_default_dir(w);
    settings_free(s);
    return code;
}

int plan_create(struct plan *p, int n_words, const char *const *words)
{
    *p = (struct plan){0};
    int code = study_words_take(&p->words, n_words, words);

    if (code == 0) code = plan_complete(p);
    if (code != 0) plan_free(p);
    return code;
}

void plan_free(struct plan *p)
{
    for (int i = 0; i < p->n_measures; i++)
        truth_free(&p->truth[i]);
    choices_free(&p->choices);
    texts_free(&p->fixed);
    study_words_free(&p->words);
    *p = (struct plan){0};
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/plan.h"

#include "base/alloc.h"
#include "base/number.h"
#include "case/case_file.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_RUNS = 10000 };

static int wrong(const char *what, const char *why)
{
    fprintf(stderr, "winnow: study: %s%s\n", what, why);
    return 2;
}

/* --- what a run gets besides its choices --------------------------------- */

/* Of a fluid, and where the history has its own interval, nothing depends on
 * how often pictures are written: those of the start and the end will do. */
static int needs_few_pictures(const struct settings *s)
{
    return settings_has(s, "fluid") || settings_has(s, "output.history");
}

static void add_output(struct plan *p, const struct settings *s)
{
    char end[NUMBER_LENGTH];

    texts_add(&p->fixed, "output.picture=false");
    if (needs_few_pictures(s))
        texts_add(&p->fixed, "output.every=%s",
                  number_text(settings_real(s, "output.end"), end));
}

/* The keys of all seeds of the case, and their values. */
static int add_seeds(struct plan *p, const struct settings *s)
{
    const char *const list = "particles.insert";

    if (settings_has(s, "particles") && settings_has(s, "particles.bed"))
        p->seed[p->n_seeds++] = (struct plan_seed){
            "particles.bed.seed", settings_int(s, "particles.bed.seed")};
    for (int i = 0; settings_is_list(s, list) && i < settings_length(s, list) &&
                    p->n_seeds < PLAN_SEEDS;
         i++) {
        struct plan_seed *const one = &p->seed[p->n_seeds++];
        snprintf(one->key, sizeof one->key, "%s.%d.seed", list, i);
        one->value = settings_item_int(s, list, i, "seed");
    }
    return p->words.seeds == 1 || p->n_seeds > 0
               ? 0
               : wrong("--seeds", ": the case has none: no particles.bed and "
                                  "no particles.insert");
}

void plan_overrides(const struct plan *p, int variant, int seed,
                    struct texts *set)
{
    for (int i = 0; i < p->fixed.n; i++)
        texts_add(set, "%s", p->fixed.text[i]);
    for (int i = 0; i < p->n_seeds && p->words.seeds > 1; i++)
        texts_add(set, "%s=%d", p->seed[i].key, p->seed[i].value + seed);
    choices_overrides(&p->choices, variant, PLAN_THREADS, set);
}

struct settings *plan_case(const struct plan *p, int variant, int seed,
                           int *code)
{
    struct texts set = {0};

    plan_overrides(p, variant, seed, &set);
    struct settings *const s = case_file_read(
        p->words.case_file, set.n, (const char *const *)set.text, code);
    texts_free(&set);
    return s;
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
            return wrong(PLAN_THREADS, " asks for numbers from 1 to 1024");
    }
    return 0;
}

static int add_choices(struct plan *p)
{
    for (int i = 0; i < p->words.n_choices; i++)
        if (choices_add(&p->choices, p->words.choice[i]) != 0) return 2;
    const int n = choices_variants(&p->choices);
    if (n < 2)
        return wrong("nothing to compare", ": give a key several values, -s "
                                           "key=value,value,...");
    if (p->words.jobs == 0) /* runs of several threads one after the other */
        p->words.jobs = choices_value(&p->choices, 0, PLAN_THREADS) != NULL
                            ? 1
                            : omp_get_num_procs();
    if ((double)n * p->words.seeds * p->words.times > MOST_RUNS)
        return wrong("", "more than 10000 runs");
    return check_threads(p);
}

static int check_truth(const struct plan *p, const struct truth *t)
{
    const int axis = choices_axis(&p->choices);

    if (t->kind != TRUTH_EXTRAPOLATED ||
        (axis >= 0 && p->choices.of[axis].n > 2))
        return 0;
    return wrong("extrapolated", ": asks for a key with three numbers or more, "
                                 "rising or falling");
}

static int add_measures(struct plan *p, const struct settings *s)
{
    const struct study_words *const w = &p->words;

    if (w->n_measures == 0)
        return wrong("what is to be looked at?",
                     " Give --measure NAME, a column of history.csv or a "
                     "number of summary.json");
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
    return measure_parse(&p->cost, w->cost != NULL ? w->cost : PLAN_COST, s);
}

int plan_cost_is_processor(const struct plan *p)
{
    return strcmp(p->cost.name, PLAN_COST) == 0;
}

/* out/study-NAME for some/where/NAME.cfg. */
static const char *default_dir(struct study_words *w)
{
    const char *const slash = strrchr(w->file, '/');
    const char *const name = slash != NULL ? slash + 1 : w->file;
    const char *const dot = strrchr(name, '.');

    return texts_add(&w->made, "out/study-%.*s",
                     (int)(dot > name ? (size_t)(dot - name) : strlen(name)),
                     name);
}

static int complete(struct plan *p)
{
    struct study_words *const w = &p->words;
    int code = add_choices(p);
    struct settings *const s = code == 0 ? plan_case(p, 0, 0, &code) : NULL;

    if (s == NULL) return code;
    code = add_measures(p, s);
    if (code == 0) code = add_seeds(p, s);
    if (code == 0) add_output(p, s);
    if (w->title == NULL)
        w->title = texts_add(&w->made, "%s", settings_text(s, "title"));
    if (w->dir == NULL) w->dir = default_dir(w);
    settings_free(s);
    return code;
}

int plan_create(struct plan *p, int n_words, const char *const *words)
{
    *p = (struct plan){0};
    int code = study_words_take(&p->words, n_words, words);

    if (code == 0) code = complete(p);
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

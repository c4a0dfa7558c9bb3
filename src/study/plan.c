/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/plan.h"

#include "base/number.h"
#include "case/case_file.h"
#include "case/command.h"
#include "base/text.h"
#include "case/source.h"

#include <ctype.h>
#include <math.h>
#include <omp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_RUNS = 10000 };

/* The words as they were given, or as a study file says them. A truth belongs
 * to the measure before it; that of the last measure also to those that have
 * none. */
struct words {
    struct plan *plan;
    int n_choices, n_measures;
    const char **choice;
    const char *measure[PLAN_MEASURES], *truth[PLAN_MEASURES], *cost;
    int old_choices, old_measures; /* those of the file, until replaced */
};

int plan_wrong(const char *format, ...)
{
    va_list values;

    fputs("winnow: study: ", stderr);
    va_start(values, format);
    vfprintf(stderr, format, values);
    va_end(values);
    fputc('\n', stderr);
    return 2;
}

/* --- one word ------------------------------------------------------------- */

static int words_wrong(const char *what, const char *why)
{
    return plan_wrong("%s%s\nwinnow study " PLAN_ARGUMENTS, what, why);
}

/* A choice of the same keys as one of the file takes its place. */
static int take_choice(struct words *w, const char *value)
{
    const size_t keys = strcspn(value, "=") + 1;
    int at = 0;

    while (at < w->old_choices && strncmp(w->choice[at], value, keys) != 0)
        at++;
    if (at == w->old_choices) at = w->n_choices++;
    w->choice = realloc(w->choice, (size_t)w->n_choices * sizeof *w->choice);
    if (w->choice == NULL) exit(4);
    w->choice[at] = value;
    return 0;
}

static int take_measure(struct words *w, const char *value)
{
    if (w->old_measures > 0) w->n_measures = w->old_measures = 0;
    if (w->n_measures == PLAN_MEASURES)
        return words_wrong(value, ": more than 16 measures");
    w->truth[w->n_measures] = NULL;
    w->measure[w->n_measures++] = value;
    return 0;
}

static int take_truth(struct words *w, const char *value)
{
    if (w->n_measures == w->old_measures)
        return words_wrong("--truth", " follows the --measure that it is for");
    if (w->truth[w->n_measures - 1] != NULL)
        return words_wrong(value, ": a second --truth for one measure");
    w->truth[w->n_measures - 1] = value;
    return 0;
}

static int take_option(struct words *w, const char *option, const char *value)
{
    struct plan *const p = w->plan;
    const struct {
        const char *word;
        const char **text;
        int *count;
        int (*take)(struct words *w, const char *value);
    } options[] = {{"-s", NULL, NULL, take_choice},
                   {"--measure", NULL, NULL, take_measure},
                   {"--truth", NULL, NULL, take_truth},
                   {"-o", &p->dir, NULL, NULL},
                   {"--cost", &w->cost, NULL, NULL},
                   {"--seeds", NULL, &p->seeds, NULL},
                   {"--times", NULL, &p->times, NULL},
                   {"-j", NULL, &p->jobs, NULL}};
    struct nearest near;
    char why[NEAREST_HINT + 64], hint[NEAREST_HINT];

    nearest_init(&near, option);
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        nearest_offer(&near, options[i].word);
        if (strcmp(option, options[i].word) != 0) continue;
        if (value == NULL || value[0] == '\0')
            return words_wrong(option, " asks for a value");
        if (options[i].take != NULL) return options[i].take(w, value);
        if (options[i].text != NULL)
            *options[i].text = value;
        else if ((*options[i].count = command_count(value)) == 0)
            return words_wrong(option, " asks for a number, 1 to 1024");
        return 0;
    }
    snprintf(why, sizeof why, ": no such option%s",
             nearest_hint(nearest_best(&near), "", hint));
    return words_wrong(option, why);
}

/* 1 if a word is an option and its value in one, -j2, -oDIR, -skey=value, as
 * those of the other commands may be. */
static int is_glued(const char *word)
{
    return strncmp(word, "-j", 2) == 0   ? isdigit((unsigned char)word[2])
           : strncmp(word, "-s", 2) == 0 ? strchr(word, '=') != NULL
           : strncmp(word, "-o", 2) == 0 ? word[2] != '\0'
                                         : 0;
}

static int take_words(struct words *w, int n, const char *const *words)
{
    struct plan *const p = w->plan;

    for (int i = 0; i < n; i++) {
        const char *const word = words[i];
        int code = 0;

        if (strcmp(word, "--quiet") == 0)
            p->quiet = 1;
        else if (strcmp(word, "--dry-run") == 0)
            p->dry = 1;
        else if (is_glued(word)) {
            const char option[] = {'-', word[1], '\0'};
            code = take_option(w, option, word + 2);
        } else if (word[0] == '-') {
            code = take_option(w, word, i + 1 < n ? words[i + 1] : NULL);
            i++;
        } else if (p->file != NULL)
            code =
                words_wrong(word, ": one argument too many; choices follow -s");
        else
            p->file = word;
        if (code != 0) return code;
    }
    return p->file != NULL ? 0 : words_wrong("", "which case?");
}

/* --- the study file ------------------------------------------------------- */

const struct key plan_keys[] = {
    {"title", KEY_TEXT, "", "", "",
     "heading of the picture; left out: the title of the case", "", ""},
    {"case", KEY_FILE, "", "", NULL,
     "the case, beside the study unless it begins with /", "", ""},
    {"vary", KEY_LIST, "", "", NULL, "what is varied; all crossed", "", ""},
    {"vary.keys", KEY_TEXT, "", "", NULL,
     "a key of the case, or keys that change together, with colons between; or "
     "threads: those of a run",
     "", ""},
    {"vary.values", KEY_TEXT, "", "", NULL,
     "its values from coarse to fine, with commas between", "", ""},
    {"measures", KEY_LIST, "", "", NULL, "what is looked at in each run", "",
     ""},
    {"measures.of", KEY_TEXT, "", "", NULL,
     "a column of the run, as \"mean:pressure_drop@0.3\"", "", ""},
    {"measures.truth", KEY_TEXT, "", "", "",
     "what it is compared with; left out: that of the last measure, or finest",
     "", ""},
    {"cost", KEY_TEXT, "", "", "",
     "what a run costs; left out: its processor time", "", ""},
    {"seeds", KEY_INT, "-", ">= 1, <= 1024", "1",
     "runs of each variant, with other seeds", "", ""},
    {"times", KEY_INT, "-", ">= 1, <= 1024", "1",
     "repetitions of each run, for the least processor time", "", ""},
    KEY_END};

/* 1 if the file has what only a study has; *code is not 0, after a message, if
 * it cannot be read. */
static int is_study(const char *file, int *code)
{
    config_t tree;
    struct inputs *files = NULL;

    *code = source_read(&tree, &files, file);
    input_forget(&files);
    const int found = *code == 0 && config_lookup(&tree, "case") != NULL;
    config_destroy(&tree);
    return found;
}

/* The file beside the study. */
static const char *plan_beside(struct plan *p, const char *file)
{
    char path[SETTINGS_PATH];

    settings_beside(p->study, file, path, sizeof path);
    return texts_add(&p->made, "%s", path);
}

/* A table of the truth stands beside the study. */
static int take_measured(struct words *w, const struct settings *s, int i)
{
    int code = take_measure(w, settings_item_text(s, "measures", i, "of"));

    if (code != 0 || !settings_item_has(s, "measures", i, "truth")) return code;
    const char *const text = settings_item_text(s, "measures", i, "truth");
    return take_truth(w,
                      truth_is_table(text) ? plan_beside(w->plan, text) : text);
}

/* What the study file says, as if it stood before the words. */
static int take_study(struct words *w, const char *file)
{
    const struct key *const tables[] = {plan_keys, NULL};
    struct plan *const p = w->plan;
    int code;
    const struct settings *const s = p->study =
        settings_create(file, 0, NULL, tables, &code);

    if (s == NULL) return code;
    p->case_file = plan_beside(p, settings_text(s, "case"));
    if (is_study(p->case_file, &code))
        return settings_wrong(s, "case",
                              "%s is a study, and a study asks for a case",
                              p->case_file);
    for (int i = 0; i < settings_length(s, "vary") && code == 0; i++)
        code = take_choice(
            w, texts_add(&p->made, "%s=%s",
                         settings_item_text(s, "vary", i, "keys"),
                         settings_item_text(s, "vary", i, "values")));
    for (int i = 0; i < settings_length(s, "measures") && code == 0; i++)
        code = take_measured(w, s, i);
    if (settings_has(s, "title")) p->title = settings_text(s, "title");
    if (settings_has(s, "cost")) w->cost = settings_text(s, "cost");
    p->seeds = settings_int(s, "seeds");
    p->times = settings_int(s, "times");
    w->old_choices = w->n_choices;
    w->old_measures = w->n_measures;
    return code;
}

/* --- the overrides of a run ----------------------------------------------- */

struct settings *plan_case(const struct plan *p, const struct texts *set,
                           int *code)
{
    return case_file_read(p->case_file, set->n, (const char *const *)set->text,
                          code);
}

/* Few pictures. Of a fluid, and where the history has its own interval, nothing
 * depends on how often they are written: those of the start and the end will
 * do. */
static void add_output(struct plan *p, const struct settings *s)
{
    char end[NUMBER_LENGTH];

    texts_add(&p->fixed, "output.picture=false");
    if (s->has.fluid || s->output.history > 0.0)
        texts_add(&p->fixed, "output.every=%s",
                  number_text(s->output.end, end));
}

/* The seeds of all groups that the case has with these overrides. */
static int add_seeds(const struct plan *p, int more, struct texts *set)
{
    int code;
    struct settings *const s = plan_case(p, set, &code);

    if (s == NULL) return code;
    case_file_add_seeds(s, more, set);
    settings_free(s);
    return 0;
}

int plan_overrides(const struct plan *p, int variant, int seed,
                   struct texts *set)
{
    for (int i = 0; i < p->fixed.n; i++)
        texts_add(set, "%s", p->fixed.text[i]);
    choices_overrides(&p->choices, variant, set);
    /* Last, for a choice may be the group that a seed stands in. */
    return p->seeds > 1 ? add_seeds(p, seed, set) : 0;
}

/* --seeds set all seeds that there are; one in some variant, which nothing else
 * varies. */
static int check_seeds(const struct plan *p)
{
    const struct choices *const c = &p->choices;
    int found = 0, code = 0;

    for (int i = 0; i < c->n; i++)
        for (int k = 0; k < c->of[i].key.n && c->of[i].n > 1; k++)
            if (case_file_is_seed(c->of[i].key.text[k]))
                return plan_wrong(
                    "%s: is varied, so that --seeds cannot set it",
                    c->of[i].key.text[k]);
    for (int v = 0; v < choices_variants(c) && code == 0 && !found; v++) {
        struct texts set = {0};
        code = plan_overrides(p, v, 0, &set);
        found = set.n > 0 &&
                strstr(set.text[set.n - 1], CASE_FILE_SEED "=") != NULL;
        texts_free(&set);
    }
    return code != 0 || found
               ? code
               : plan_wrong("--seeds: the case has no group with a seed, such "
                            "as particles.bed or particles.insert");
}

/* --- the plan as a whole -------------------------------------------------- */

static int add_choices(struct words *w)
{
    struct plan *const p = w->plan;
    const struct choices *const c = &p->choices;

    for (int i = 0; i < w->n_choices; i++)
        if (choices_add(&p->choices, w->choice[i]) != 0) return 2;
    const int n = choices_variants(c);
    const int threads = choices_value(c, 0, PLAN_THREADS) != NULL;
    if (n < 2)
        return plan_wrong("nothing to compare: give a key several values, -s "
                          "key=value,value,...");
    if (p->jobs == 0) /* runs of several threads one after the other */
        p->jobs = threads ? 1 : omp_get_num_procs();
    if ((double)n * p->seeds * p->times > MOST_RUNS)
        return plan_wrong("more than %d runs", MOST_RUNS);
    for (int v = 0; v < n && threads; v++)
        if (command_count(choices_value(c, v, PLAN_THREADS)) == 0)
            return plan_wrong(PLAN_THREADS " asks for numbers from 1 to 1024");
    return 0;
}

/* An extrapolation asks for three numbers in order at the end of the axis. */
static int check_truth(const struct plan *p, const struct truth *t)
{
    const int axis = choices_axis(&p->choices);
    const struct choice *const c = axis >= 0 ? &p->choices.of[axis] : NULL;
    int sizes = 0;

    if (t->kind != TRUTH_EXTRAPOLATED) return 0;
    for (int i = 0; c != NULL && i < c->n; i++)
        sizes = isnan(choices_size(c, i)) ? 0 : sizes + 1;
    return sizes >= 3 ? 0
                      : plan_wrong("extrapolated: asks for a key with three "
                                   "numbers or more, rising or falling");
}

static int add_measures(struct words *w, const struct settings *s)
{
    struct plan *const p = w->plan;
    const char *const cost = w->cost != NULL ? w->cost : PLAN_COST;

    if (w->n_measures == 0)
        return plan_wrong("what is to be looked at? Give --measure NAME, a "
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
    const int code = measure_parse(&p->cost, cost, s);
    return code == 0 && p->cost.how == MEASURE_CURVE
               ? plan_wrong("--cost %s: is a curve, and a run costs one number",
                            cost)
               : code;
}

int plan_cost_is_processor(const struct plan *p)
{
    return strcmp(p->cost.name, PLAN_COST) == 0;
}

static int plan_complete(struct words *w)
{
    struct plan *const p = w->plan;
    struct texts first = {0};
    int code = add_choices(w);

    if (code != 0) return code;
    choices_overrides(&p->choices, 0, &first);
    struct settings *const s = plan_case(p, &first, &code);
    texts_free(&first);
    if (s == NULL) return code;
    code = add_measures(w, s);
    if (code == 0 && !p->quiet) choices_tell_reversed(&p->choices);
    if (code == 0) add_output(p, s);
    if (code == 0 && p->seeds > 1) code = check_seeds(p);
    if (p->title == NULL) p->title = texts_add(&p->made, "%s", s->title);
    if (p->dir == NULL) { /* out/study-NAME for some/where/NAME.cfg */
        const char *const slash = strrchr(p->file, '/');
        const char *const name = slash != NULL ? slash + 1 : p->file;
        const char *const dot = strrchr(name, '.');
        const size_t n = dot > name ? (size_t)(dot - name) : strlen(name);
        p->dir = texts_add(&p->made, "out/study-%.*s", (int)n, name);
    }
    settings_free(s);
    return code;
}

int plan_create(struct plan *p, int n_words, const char *const *words)
{
    const struct plan none = {.seeds = 1, .times = 1};
    struct words w = {.plan = p};

    *p = none;
    int code = take_words(&w, n_words, words);
    const char *const file = p->case_file = p->file;
    if (code == 0 && is_study(file, &code)) {
        free(w.choice); /* the file's own words go first */
        w = (struct words){.plan = p};
        *p = none;
        code = take_study(&w, file);
        if (code == 0) code = take_words(&w, n_words, words);
    }
    if (code == 0) code = plan_complete(&w);
    free(w.choice);
    if (code != 0) plan_free(p);
    return code;
}

void plan_free(struct plan *p)
{
    for (int i = 0; i < p->n_measures; i++)
        truth_free(&p->truth[i]);
    choices_free(&p->choices);
    texts_free(&p->fixed);
    settings_free(p->study);
    texts_free(&p->made);
    *p = (struct plan){0};
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/study_words.h"

#include "case/nearest.h"
#include "case/source.h"
#include "study/study.h"
#include "study/truth.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int study_words_wrong(const char *what, const char *why)
{
    fprintf(stderr, "winnow: study: %s%s\n%s\n", what, why,
            "winnow study " STUDY_ARGUMENTS);
    return 2;
}

/* --- one word ------------------------------------------------------------- */

/* A whole number from 1 to 1024. */
static int take_count(const char *option, const char *value, int *count)
{
    char *end;
    const long n = strtol(value, &end, 10);

    if (end == value || *end != '\0' || n < 1 || n > 1024)
        return study_words_wrong(option, " asks for a number, 1 to 1024");
    *count = (int)n;
    return 0;
}

/* A choice of the same keys as one of the file takes its place. */
static int take_choice(struct study_words *w, const char *value)
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

static int take_measure(struct study_words *w, const char *value)
{
    if (w->old_measures > 0) w->n_measures = w->old_measures = 0;
    if (w->n_measures == STUDY_WORDS_MEASURES)
        return study_words_wrong(value, ": more than 16 measures");
    w->truth[w->n_measures] = NULL;
    w->measure[w->n_measures++] = value;
    return 0;
}

static int take_truth(struct study_words *w, const char *value)
{
    if (w->n_measures == w->old_measures)
        return study_words_wrong("--truth",
                                 " follows the --measure that it is for");
    if (w->truth[w->n_measures - 1] != NULL)
        return study_words_wrong(value, ": a second truth for one measure");
    w->truth[w->n_measures - 1] = value;
    return 0;
}

static int take_option(struct study_words *w, const char *option,
                       const char *value)
{
    const struct {
        const char *word;
        const char **text;
        int *count;
        int (*take)(struct study_words *w, const char *value);
    } options[] = {{"-s", NULL, NULL, take_choice},
                   {"--measure", NULL, NULL, take_measure},
                   {"--truth", NULL, NULL, take_truth},
                   {"-o", &w->dir, NULL, NULL},
                   {"--cost", &w->cost, NULL, NULL},
                   {"--seeds", NULL, &w->seeds, NULL},
                   {"--times", NULL, &w->times, NULL},
                   {"-j", NULL, &w->jobs, NULL}};
    struct nearest near;
    char why[NEAREST_TEXT + 64];

    nearest_init(&near, option);
    for (size_t i = 0; i < sizeof options / sizeof options[0]; i++) {
        nearest_offer(&near, options[i].word);
        if (strcmp(option, options[i].word) != 0) continue;
        if (value == NULL || value[0] == '\0')
            return study_words_wrong(option, " asks for a value");
        if (options[i].take != NULL) return options[i].take(w, value);
        if (options[i].count != NULL)
            return take_count(option, value, options[i].count);
        *options[i].text = value;
        return 0;
    }
    const char *const best = nearest_best(&near);
    snprintf(why, sizeof why, ": no such option%s%s%s",
             best != NULL ? "; did you mean " : "", best != NULL ? best : "",
             best != NULL ? "?" : "");
    return study_words_wrong(option, why);
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

static int take_words(struct study_words *w, int n, const char *const *words)
{
    for (int i = 0; i < n; i++) {
        const char *const word = words[i];
        int code = 0;

        if (strcmp(word, "--quiet") == 0)
            w->quiet = 1;
        else if (strcmp(word, "--dry-run") == 0)
            w->dry = 1;
        else if (is_glued(word)) {
            const char option[] = {'-', word[1], '\0'};
            code = take_option(w, option, word + 2);
        } else if (word[0] == '-') {
            code = take_option(w, word, i + 1 < n ? words[i + 1] : NULL);
            i++;
        } else if (w->file != NULL)
            code = study_words_wrong(
                word, ": one argument too many; choices follow -s");
        else
            w->file = word;
        if (code != 0) return code;
    }
    return w->file != NULL ? 0 : study_words_wrong("", "which case?");
}

/* --- the study file ------------------------------------------------------- */

const struct key study_words_keys[] = {
    {"title", KEY_TEXT, "", "", "",
     "heading of the picture; left out: the "
     "title of the case",
     "", ""},
    {"case", KEY_FILE, "", "", NULL,
     "the case, beside the study unless it "
     "begins with /",
     "", ""},
    {"vary", KEY_LIST, "", "", NULL, "what is varied; all crossed", "", ""},
    {"vary.keys", KEY_TEXT, "", "", NULL,
     "a key of the case, or keys that change together, with colons between; "
     "or threads: those of a run",
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

    *code = source_read(&tree, file);
    const int found = *code == 0 && config_lookup(&tree, "case") != NULL;
    config_destroy(&tree);
    return found;
}

/* The file beside the study. */
static const char *study_words_beside(struct study_words *w, const char *file)
{
    char path[SETTINGS_PATH];

    settings_beside(w->study, file, path, sizeof path);
    return texts_add(&w->made, "%s", path);
}

static int take_vary(struct study_words *w, int i)
{
    return take_choice(
        w, texts_add(&w->made, "%s=%s",
                     settings_item_text(w->study, "vary", i, "keys"),
                     settings_item_text(w->study, "vary", i, "values")));
}

/* A table of the truth stands beside the study. */
static int take_measured(struct study_words *w, int i)
{
    const struct settings *const s = w->study;
    int code = take_measure(w, settings_item_text(s, "measures", i, "of"));

    if (code != 0 || !settings_item_has(s, "measures", i, "truth")) return code;
    const char *const text = settings_item_text(s, "measures", i, "truth");
    return take_truth(w, truth_is_table(text) ? study_words_beside(w, text)
                                              : text);
}

/* What the study file says, as if it stood before the words. */
static int take_study(struct study_words *w, const char *file)
{
    const struct key *const tables[] = {study_words_keys, NULL};
    int code;
    const struct settings *const s = w->study =
        settings_create(file, 0, NULL, tables, &code);

    if (s == NULL) return code;
    w->case_file = study_words_beside(w, settings_text(s, "case"));
    if (is_study(w->case_file, &code))
        return settings_wrong(s, "case",
                              "%s is a study, and a study asks for "
                              "a case",
                              w->case_file);
    for (int i = 0; i < settings_length(s, "vary") && code == 0; i++)
        code = take_vary(w, i);
    for (int i = 0; i < settings_length(s, "measures") && code == 0; i++)
        code = take_measured(w, i);
    if (settings_has(s, "title")) w->title = settings_text(s, "title");
    if (settings_has(s, "cost")) w->cost = settings_text(s, "cost");
    w->seeds = settings_int(s, "seeds");
    w->times = settings_int(s, "times");
    w->old_choices = w->n_choices;
    w->old_measures = w->n_measures;
    return code;
}

int study_words_take(struct study_words *w, int n, const char *const *words)
{
    *w = (struct study_words){.seeds = 1, .times = 1};
    int code = take_words(w, n, words);
    const char *const file = w->case_file = w->file;

    if (code != 0 || !is_study(file, &code)) return code;
    study_words_free(w); /* the file's own words go first */
    code = take_study(w, file);
    return code != 0 ? code : take_words(w, n, words);
}

void study_words_free(struct study_words *w)
{
    settings_free(w->study);
    texts_free(&w->made);
    free(w->choice);
    *w = (struct study_words){0};
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/study_words.h"

#include "base/alloc.h"
#include "case/source.h"
#include "study/study.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int wrong(const char *what, const char *why)
{
    fprintf(stderr, "winnow: study: %s%s\n%s\n", what, why,
            "winnow study " STUDY_ARGUMENTS);
    return 2;
}

/* A whole number from 1 to 1024; 0 if it is none. */
static int count_of(const char *text)
{
    char *end;
    const long n = strtol(text, &end, 10);

    return end != text && *end == '\0' && n >= 1 && n <= 1024 ? (int)n : 0;
}

static int take_count(const char *option, const char *value, int *count)
{
    *count = count_of(value);
    return *count > 0 ? 0 : wrong(option, " asks for a number, 1 to 1024");
}

static int take_measure(struct study_words *w, const char *value)
{
    if (w->n_measures == PLAN_MEASURES)
        return wrong(value, ": more than 16 measures");
    w->measure[w->n_measures++] = value;
    return 0;
}

static int take_truth(struct study_words *w, const char *value)
{
    if (w->n_measures == 0)
        return wrong("--truth", " follows the --measure that it is for");
    if (w->truth[w->n_measures - 1] != NULL)
        return wrong(value, ": a second truth for one measure");
    w->truth[w->n_measures - 1] = value;
    return 0;
}

static int take_option(struct study_words *w, const char *option,
                       const char *value)
{
    if (strcmp(option, "-o") == 0)
        w->dir = value;
    else if (strcmp(option, "-s") == 0)
        w->choice[w->n_choices++] = value;
    else if (strcmp(option, "-j") == 0)
        return take_count(option, value, &w->jobs);
    else if (strcmp(option, "--seeds") == 0)
        return take_count(option, value, &w->seeds);
    else if (strcmp(option, "--times") == 0)
        return take_count(option, value, &w->times);
    else if (strcmp(option, "--measure") == 0)
        return take_measure(w, value);
    else if (strcmp(option, "--truth") == 0)
        return take_truth(w, value);
    else if (strcmp(option, "--cost") == 0)
        w->cost = value;
    else
        return wrong(option, ": no such option");
    return value[0] != '\0' ? 0 : wrong(option, " asks for a value");
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
        else if (word[0] == '-' && i + 1 < n)
            code = take_option(w, word, words[++i]);
        else if (word[0] == '-')
            code = wrong(word, " asks for a value, or is no option");
        else if (w->file != NULL)
            code = wrong(word, ": one argument too many; choices follow -s");
        else
            w->file = word;
        if (code != 0) return code;
    }
    return w->file != NULL ? 0 : wrong("", "which case?");
}

/* --- the study file --------------------------------------------------------
 */

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

/* A text that lives as long as the words. */
static const char *keep(struct study_words *w, char *text)
{
    w->text = realloc(w->text, ((size_t)w->n_texts + 1) * sizeof *w->text);
    if (w->text == NULL) exit(4);
    w->text[w->n_texts++] = text;
    return text;
}

static char *joined(const char *keys, const char *values)
{
    char *const text = alloc_zeroed(strlen(keys) + strlen(values) + 2, 1);

    sprintf(text, "%s=%s", keys, values);
    return text;
}

/* 1 if the command line has a choice of these keys. */
static int is_chosen(const struct study_words *w, const char *keys)
{
    const size_t n = strlen(keys);

    for (int i = 0; i < w->n_choices; i++)
        if (strncmp(w->choice[i], keys, n) == 0 && w->choice[i][n] == '=')
            return 1;
    return 0;
}

/* The choices of the file go before those of the command line. */
static void add_choices(struct study_words *w)
{
    const int n = settings_length(w->study, "vary");
    const char **const all =
        alloc_zeroed((size_t)n + (size_t)w->n_choices, sizeof *all);
    int at = 0;

    for (int i = 0; i < n; i++) {
        const char *const keys =
            settings_item_text(w->study, "vary", i, "keys");
        if (is_chosen(w, keys)) continue;
        all[at++] = keep(
            w, joined(keys, settings_item_text(w->study, "vary", i, "values")));
    }
    for (int i = 0; i < w->n_choices; i++)
        all[at++] = w->choice[i];
    free(w->choice);
    w->choice = all;
    w->n_choices = at;
}

/* A table of the truth stands beside the study. */
static const char *truth_of(struct study_words *w, const char *text)
{
    const size_t n = strlen(text);

    if (n < 4 || strcmp(text + n - 4, ".csv") != 0) return text;
    char *const path = alloc_zeroed(SETTINGS_PATH, 1);
    settings_beside(w->study, text, path, SETTINGS_PATH);
    return keep(w, path);
}

static int add_measures(struct study_words *w)
{
    const char *const list = "measures";
    const int n = settings_length(w->study, list);

    if (n > PLAN_MEASURES) return wrong(w->file, ": more than 16 measures");
    for (int i = 0; i < n; i++) {
        w->measure[i] = settings_item_text(w->study, list, i, "of");
        if (settings_item_has(w->study, list, i, "truth"))
            w->truth[i] =
                truth_of(w, settings_item_text(w->study, list, i, "truth"));
    }
    w->n_measures = n;
    return 0;
}

static int read_study(struct study_words *w)
{
    const struct key *const tables[] = {study_words_keys, NULL};
    int code;

    w->study = settings_create(w->file, 0, NULL, tables, &code);
    if (w->study == NULL) return code;
    const struct settings *const s = w->study;
    free(w->case_file);
    w->case_file = alloc_zeroed(SETTINGS_PATH, 1);
    settings_beside(s, settings_text(s, "case"), w->case_file, SETTINGS_PATH);
    add_choices(w);
    if (settings_has(s, "title")) w->title = settings_text(s, "title");
    if (w->cost == NULL && settings_has(s, "cost"))
        w->cost = settings_text(s, "cost");
    if (w->seeds == 0) w->seeds = settings_int(s, "seeds");
    if (w->times == 0) w->times = settings_int(s, "times");
    return w->n_measures > 0 ? 0 : add_measures(w);
}

int study_words_take(struct study_words *w, int n, const char *const *words)
{
    *w = (struct study_words){0};
    w->choice = alloc_zeroed((size_t)n + 1, sizeof *w->choice);
    int code = take_words(w, n, words);
    if (code != 0) return code;
    w->case_file = strdup(w->file);
    const int study = is_study(w->file, &code);
    return study ? read_study(w) : code;
}

void study_words_free(struct study_words *w)
{
    settings_free(w->study);
    plan_free_texts(w->n_texts, w->text);
    free(w->choice);
    free(w->case_file);
    *w = (struct study_words){0};
}

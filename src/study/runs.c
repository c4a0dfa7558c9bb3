/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/runs.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/number.h"
#include "base/tables/input.h"
#include "base/interrupt.h"
#include "base/version.h"
#include "case/checks/case_scales.h"
#include "case/resume/case_text.h"
#include "case/resume/read_summary.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { LONGEST_NAME = 100 };

/* --- what a run is -------------------------------------------------------- */

/* The text without the ".0" of whole numbers, for a case may write 1 or 1.0. */
static void drop_points(char *text)
{
    char *to = text;

    for (const char *at = text; *at != '\0'; at++) {
        if (at > text && isdigit((unsigned char)at[-1]) &&
            strncmp(at, ".0", 2) == 0 && strchr(",)]\n", at[2]) != NULL)
            at++;
        else
            *to++ = *at;
    }
    *to = '\0';
}

static unsigned long runs_checksum_of(const char *text)
{
    return crc32_z(0, (const unsigned char *)text, strlen(text));
}

/* Of all that the case says, and of the files that it names. */
static unsigned long runs_contents_of(const struct settings *s)
{
    char *const lines = case_text_lines(s);

    drop_points(lines);
    const unsigned long sum = runs_checksum_of(lines);
    free(lines);
    return sum;
}

/* The text of variant.txt. */
static char *identity_of(const struct plan *p, const struct run *r)
{
    const char *const threads =
        choices_value(&p->choices, r->variant, PLAN_THREADS);
    char *text;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    fprintf(out, "winnow %s, %s, contents crc32 %08lx\n", VERSION_TEXT,
            p->words.case_file, r->contents);
    for (int i = 0; i < r->overrides.n; i++)
        fprintf(out, "%s\n", r->overrides.text[i]);
    if (threads != NULL) fprintf(out, PLAN_THREADS "=%s\n", threads);
    fclose(out);
    return text;
}

/* A folder's name from what tells the run from others: letters that no shell
 * minds. A name that had to be changed has a hash behind it. */
static char *runs_name_of(const struct plan *p, const struct run *r)
{
    char *const label = choices_label(&p->choices, r->variant, -1);
    char *const name = alloc_zeroed(LONGEST_NAME + 64, 1);
    const char *c = label;
    int changed = 0;
    size_t n = 0;

    for (; *c != '\0' && n < LONGEST_NAME; c++) {
        const int between = strncmp(c, ", ", 2) == 0;
        const int plain =
            isalnum((unsigned char)*c) || strchr("=.+-_", *c) != NULL;
        name[n++] = between ? '+' : plain ? *c : '_';
        changed |= !between && !plain;
        c += between;
    }
    if (n == 0) n = (size_t)sprintf(name, "as-it-stands");
    if (changed || *c != '\0')
        n += (size_t)sprintf(name + n, "-%08x",
                             (unsigned)runs_checksum_of(label));
    if (p->words.seeds > 1) n += (size_t)sprintf(name + n, "+seed-%d", r->seed);
    if (p->words.times > 1) sprintf(name + n, "+time-%d", r->time);
    free(label);
    return name;
}

static int runs_make_folder(const struct plan *p, struct run *r)
{
    int code = plan_overrides(p, r->variant, r->seed, &r->overrides);
    struct settings *const s =
        code == 0 ? plan_case(p, &r->overrides, &code) : NULL;

    if (s == NULL) return code;
    r->code = RUN_TO_DO;
    r->name = runs_name_of(p, r);
    char *const runs = file_join(p->words.dir, "runs");
    r->folder = file_join(runs, r->name);
    free(runs);
    r->expected = case_scales_seconds(s);
    r->contents = runs_contents_of(s);
    r->identity = identity_of(p, r);
    settings_free(s);
    return 0;
}

struct run *runs_create(const struct plan *p, int *n, int *code)
{
    const int seeds = p->words.seeds, times = p->words.times;

    *n = choices_variants(&p->choices) * seeds * times;
    *code = 0;
    struct run *const runs = alloc_zeroed((size_t)*n, sizeof *runs);
    for (int i = 0; i < *n && *code == 0; i++) {
        runs[i].variant = i / times / seeds;
        runs[i].seed = i / times % seeds;
        runs[i].time = i % times;
        *code = interrupt_arrived() ? INTERRUPT_CODE
                                    : runs_make_folder(p, &runs[i]);
    }
    if (*code == 0) return runs;
    runs_free(*n, runs);
    return NULL;
}

void runs_free(int n, struct run *runs)
{
    for (int i = 0; i < n; i++) {
        free(runs[i].name);
        free(runs[i].folder);
        free(runs[i].identity);
        texts_free(&runs[i].overrides);
    }
    free(runs);
}

int runs_standing(const struct plan *p, int n, const struct run *runs)
{
    struct texts set = {0};
    int found = -1, code = plan_overrides(p, -1, 0, &set);
    struct settings *const s = code == 0 ? plan_case(p, &set, &code) : NULL;

    texts_free(&set);
    if (s == NULL) return -1;
    const unsigned long own = runs_contents_of(s);
    for (int i = 0; i < n && found < 0; i++)
        if (runs[i].seed == 0 && runs[i].contents == own)
            found = runs[i].variant;
    settings_free(s);
    return found;
}

/* --- what has ended ------------------------------------------------------- */

/* variant.txt is the identity; a run that was refused while it was built has a
 * line "exit code N" behind it, RUN_TO_DO if there is none. */
static int runs_is_same(const struct run *r, int *code)
{
    char *const path = file_join(r->folder, "variant.txt");
    const char *why;
    size_t length;
    char *const text = input_text(path, &length, &why);
    const size_t n = strlen(r->identity);
    const int same = text != NULL && strncmp(text, r->identity, n) == 0;

    *code = RUN_TO_DO;
    if (same) sscanf(text + n, "exit code %d", code);
    free(text);
    free(path);
    return same;
}

int runs_is_begun(const struct run *r)
{
    int code;

    return runs_is_same(r, &code);
}

static void find_end(struct run *r)
{
    if (!runs_is_same(r, &r->code) || r->code != RUN_TO_DO) return;
    const double code = read_summary_number(r->folder, "exit_code");
    if (isfinite(code) && code != RUN_NOT_WRITTEN && code != INTERRUPT_CODE)
        r->code = number_clamped(code, INT_MIN, INT_MAX);
}

int runs_find_ended(int n, struct run *runs)
{
    int ended = 0;

    for (int i = 0; i < n; i++) {
        find_end(&runs[i]);
        ended += runs[i].code != RUN_TO_DO;
    }
    return ended;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/runs.h"

#include "base/alloc.h"
#include "base/file.h"
#include "base/input.h"
#include "base/version.h"
#include "case/case_cost.h"
#include "case/case_file.h"
#include "case/override.h"
#include "case/source.h"
#include "study/results.h"

#include <ctype.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_NAME = 100 };

/* Exit codes of a run that are no result of it. */
enum { NOT_WRITTEN = 4, INTERRUPTED = 130 };

/* FNV-1a, 64 bits. */
static uint64_t hash_of(const char *text, size_t length)
{
    uint64_t h = UINT64_C(14695981039346656037);

    for (size_t i = 0; i < length; i++)
        h = (h ^ (unsigned char)text[i]) * UINT64_C(1099511628211);
    return h;
}

/* --- what a run is -------------------------------------------------------- */

/* The hash of all that the case and its overrides say, included files too. */
static int hash_case(const struct plan *p, const struct run *r, uint64_t *hash)
{
    char *text = NULL;
    size_t length;
    config_t tree;
    int code = source_read(&tree, p->case_file);

    for (int i = 0; i < r->n_overrides && code == 0; i++)
        code = override_apply(&tree, r->overrides[i]);
    if (code == 0) {
        FILE *const out = open_memstream(&text, &length);
        config_write(&tree, out);
        fclose(out);
        *hash = hash_of(text, length);
        free(text);
    }
    config_destroy(&tree);
    return code;
}

/* The text of variant.txt. */
static int identify(const struct plan *p, struct run *r)
{
    uint64_t hash = 0;
    size_t length;
    const int code = hash_case(p, r, &hash);

    if (code != 0) return code;
    FILE *const out = open_memstream(&r->identity, &length);
    fprintf(out, "winnow %s, %s, contents %016" PRIx64 "\n", VERSION_TEXT,
            p->case_file, hash);
    for (int i = 0; i < r->n_overrides; i++)
        fprintf(out, "%s\n", r->overrides[i]);
    fclose(out);
    return 0;
}

/* A folder's name from what tells the run from others: letters that no shell
 * minds. A name that had to be changed has a hash behind it. */
static char *name_of(const struct plan *p, const struct run *r)
{
    char *const label = choices_label(&p->choices, r->variant, -1);
    char *const name = alloc_zeroed(LONGEST_NAME + 64, 1);
    size_t n = 0;
    int changed = 0;

    for (const char *c = label; *c != '\0'; c++) {
        if (*c == ' ' && c[-1] == ',') continue;
        if (n == LONGEST_NAME) changed = 1;
        if (n == LONGEST_NAME) break;
        const int plain = isalnum((unsigned char)*c) ||
                          strchr("=.+-_", *c) != NULL ||
                          (*c == ',' && c[1] == ' ');
        name[n++] = *c == ',' && c[1] == ' ' ? '+' : plain ? *c : '_';
        changed |= !plain;
    }
    if (n == 0) n = (size_t)sprintf(name, "as-it-stands");
    if (changed)
        n += (size_t)sprintf(name + n, "-%08x",
                             (unsigned)hash_of(label, strlen(label)));
    if (p->seeds > 1) n += (size_t)sprintf(name + n, "+seed-%d", r->seed);
    if (p->times > 1) sprintf(name + n, "+time-%d", r->time);
    free(label);
    return name;
}

static int create(const struct plan *p, struct run *r)
{
    int code;

    r->code = RUN_TO_DO;
    r->overrides = plan_overrides(p, r->variant, r->seed, &r->n_overrides);
    r->name = name_of(p, r);
    char *const runs = file_join(p->dir, "runs");
    r->folder = file_join(runs, r->name);
    free(runs);
    struct settings *const s = case_file_read(
        p->case_file, r->n_overrides, (const char *const *)r->overrides, &code);
    if (s == NULL) return code;
    r->expected = case_cost_seconds(s);
    settings_free(s);
    return identify(p, r);
}

struct run *runs_create(const struct plan *p, int *n, int *code)
{
    struct run *runs;
    int at = 0;

    *n = choices_variants(&p->choices) * p->seeds * p->times;
    runs = alloc_zeroed((size_t)*n, sizeof *runs);
    *code = 0;
    for (int v = 0; at < *n; v++)
        for (int k = 0; k < p->seeds; k++)
            for (int t = 0; t < p->times && *code == 0; t++, at++) {
                runs[at] = (struct run){.variant = v, .seed = k, .time = t};
                *code = create(p, &runs[at]);
                if (*code != 0) at = *n;
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
        plan_free_texts(runs[i].n_overrides, runs[i].overrides);
    }
    free(runs);
}

/* --- what has ended ------------------------------------------------------- */

/* variant.txt is the identity; a run that was refused while it was built has a
 * line "exit code N" behind it. */
static int is_same(const struct run *r, int *code)
{
    char *const path = file_join(r->folder, "variant.txt");
    const char *why;
    size_t length;
    char *const text = input_text(path, &length, &why);
    const size_t n = strlen(r->identity);
    const int same = text != NULL && strncmp(text, r->identity, n) == 0;

    if (same && sscanf(text + n, "exit code %d", code) != 1) *code = RUN_TO_DO;
    free(text);
    free(path);
    return same;
}

static void look(struct run *r)
{
    int refused;

    r->code = RUN_TO_DO;
    if (!is_same(r, &refused)) return;
    char *const path = file_join(r->folder, "summary.json");
    const double code = results_number(path, "exit_code");
    free(path);
    if (refused != RUN_TO_DO)
        r->code = refused;
    else if (isfinite(code) && code != NOT_WRITTEN && code != INTERRUPTED)
        r->code = (int)code;
}

int runs_is_begun(const struct run *r)
{
    int code;

    return is_same(r, &code);
}

int runs_look(int n, struct run *runs)
{
    int ended = 0;

    for (int i = 0; i < n; i++) {
        look(&runs[i]);
        ended += runs[i].code != RUN_TO_DO;
    }
    return ended;
}

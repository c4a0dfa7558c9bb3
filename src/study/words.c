/* SPDX-License-Identifier: GPL-3.0-or-later */
/* words.c -- what a study is of, for people who do not know the keys: their
 * meaning as the table of keys has it, measures, references. */
#include "study/outcome.h"

#include "case/case_file.h"
#include "case/schema.h"

#include <math.h>
#include <string.h>

/* Longer meanings are sentences, and the key says it in fewer letters. */
enum { LONGEST_MEANING = 64 };

static void put_spaced(const char *name, FILE *out)
{
    for (; *name != '\0'; name++)
        fputc(strchr("_.", *name) != NULL ? ' ' : *name, out);
}

/* "time step of the fluid and of the coupling [s]": up to the first semicolon.
 */
static void put_meaning(const char *path, FILE *out)
{
    const struct key *tables[CASE_FILE_TABLES];

    case_file_tables(tables);
    const struct key *const key = schema_find(tables, path);
    const int length =
        key != NULL ? (int)strcspn(key->what, ";") : LONGEST_MEANING;
    if (strcmp(path, PLAN_THREADS) == 0)
        fputs("threads of a run", out);
    else if (length >= LONGEST_MEANING)
        put_spaced(path, out);
    else
        fprintf(out, "%.*s", length, key->what);
    if (key != NULL && strlen(key->unit) > 0 && strcmp(key->unit, "-") != 0)
        fprintf(out, " [%s]", key->unit);
}

char *words_choice(const struct choice *c)
{
    char *text = NULL;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    for (int k = 0; k < c->key.n; k++) {
        if (k > 0) fputs("; ", out);
        put_meaning(c->key.text[k], out);
    }
    fclose(out);
    return text;
}

static void put_quantity(const struct measure *m, FILE *out)
{
    static const struct {
        const char *field, *words;
    } known[] = {{"eps_f", "void fraction"},
                 {"eps_s", "solids fraction"},
                 {"p", "pressure"},
                 {"u_", "velocity of the fluid along "},
                 {"us_", "velocity of the grains along "}};
    const char *const name = m->field[0] != '\0' ? m->field : m->name;

    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        const size_t n = strlen(known[i].field);
        const int part = known[i].field[n - 1] == '_';
        if (strncmp(name, known[i].field, n) != 0 ||
            (part ? strlen(name) != n + 1 : name[n] != '\0'))
            continue;
        fprintf(out, "%s%s", known[i].words, name + n);
        return;
    }
    put_spaced(name, out);
}

char *words_measure(const struct measure *m)
{
    static const char *const how[] = {"", ", mean", ", largest", ", smallest",
                                      ""};
    const int profile = strncmp(m->file, "profiles/", 9) == 0;
    const char *const unit = profile ? "m" : "s";
    char *text = NULL;
    size_t length;
    FILE *const out = open_memstream(&text, &length);

    put_quantity(m, out);
    fputs(m->how == MEASURE_CURVE ? profile ? ", profile" : ", over time"
                                  : how[m->how],
          out);
    if (isfinite(m->to))
        fprintf(out, " from %g to %g %s", m->from, m->to, unit);
    else if (isfinite(m->from))
        fprintf(out, m->how == MEASURE_LAST ? " at %g %s" : " from %g %s on",
                m->from, unit);
    fclose(out);
    return text;
}

char *words_cost(const struct plan *p)
{
    return plan_cost_is_processor(p) ? strdup("processor time of a run [s]")
                                     : words_measure(&p->cost);
}

const char *words_error(const struct truth *t)
{
    return t->kind == TRUTH_FINEST ? "difference" : "error";
}

char *words_truth(const struct outcomes *o, int m)
{
    const struct truth *const t = &o->plan->truth[m];
    const char *const slash = strrchr(t->text, '/');
    const size_t n = strcspn(t->text, " ");
    char *text = NULL;
    size_t length;

    if (t->kind == TRUTH_FINEST)
        return words_variant(&o->plan->choices, o->n - 1, -1);
    FILE *const out = open_memstream(&text, &length);
    if (t->kind == TRUTH_EXTRAPOLATED)
        fputs("what the last three approach", out);
    else if (t->kind == TRUTH_TABLE)
        fputs(slash != NULL ? slash + 1 : t->text, out);
    else if (t->kind == TRUTH_EQUATION)
        fprintf(out, "equation %.*s", (int)n, t->text);
    else
        fputs(strlen(t->text) <= 24 ? t->text : "an exact formula", out);
    fclose(out);
    return text;
}

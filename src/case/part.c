/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/part.h"

#include <stdlib.h>

#include "base/alloc.h"

struct part_record {
    const struct case_part *part;
    void *memory;
};

struct part_records {
    int n;
    struct part_record *of; /* those that the case names */
};

static int is_named(const struct settings *s, const struct case_part *p)
{
    return settings_has(s, p->name);
}

int part_tables(const struct key **tables, int n, int room)
{
    for (int i = 0; case_parts[i] != NULL; i++)
        for (int t = 0; case_parts[i]->keys[t] != NULL && n < room; t++)
            tables[n++] = case_parts[i]->keys[t];
    return n;
}

int part_validate(const struct settings *s)
{
    int code = 0;

    for (int i = 0; case_parts[i] != NULL && code == 0; i++)
        if (is_named(s, case_parts[i])) code = case_parts[i]->validate(s);
    return code;
}

int part_create(const struct settings *s, struct simulation *sim)
{
    int code = 0;

    for (int i = 0; case_parts[i] != NULL && code == 0; i++)
        if (is_named(s, case_parts[i])) code = case_parts[i]->create(s, sim);
    return code;
}

void part_report(const struct settings *s)
{
    for (int i = 0; case_parts[i] != NULL; i++)
        if (is_named(s, case_parts[i])) case_parts[i]->report(s);
}

int part_columns(const struct settings *s, int room,
                 const struct history_column **column)
{
    int n = 0;

    for (int i = 0; case_parts[i] != NULL; i++)
        for (const struct history_column *c = case_parts[i]->columns;
             is_named(s, case_parts[i]) && c->name != NULL && n < room; c++)
            column[n++] = c;
    return n;
}

struct part_records *part_records_create(const struct settings *s,
                                         const struct simulation *sim,
                                         struct folder *folder, int *failed)
{
    int n = 0;

    *failed = 0;
    for (int i = 0; case_parts[i] != NULL; i++)
        n += is_named(s, case_parts[i]);
    if (n == 0) return NULL;
    struct part_records *const r = alloc_zeroed(1, sizeof *r);
    r->of = alloc_zeroed((size_t)n, sizeof *r->of);
    for (int i = 0; case_parts[i] != NULL && !*failed; i++) {
        if (!is_named(s, case_parts[i])) continue;
        r->of[r->n].part = case_parts[i];
        r->of[r->n].memory = case_parts[i]->record(sim, folder);
        *failed = r->of[r->n].memory == NULL;
        r->n += !*failed;
    }
    return r;
}

void part_records_free(struct part_records *r)
{
    if (r == NULL) return;
    for (int i = 0; i < r->n; i++)
        r->of[i].part->free(r->of[i].memory);
    free(r->of);
    free(r);
}

int part_records_add_row(struct part_records *r)
{
    int failed = 0;

    for (int i = 0; r != NULL && i < r->n && !failed; i++)
        failed = r->of[i].part->add_row(r->of[i].memory);
    return failed;
}

int part_records_add_fields(struct part_records *r, double t)
{
    int failed = 0;

    for (int i = 0; r != NULL && i < r->n && !failed; i++)
        failed = r->of[i].part->add_fields(r->of[i].memory, t);
    return failed;
}

void part_records_summarize(const struct part_records *r, struct summary *f)
{
    for (int i = 0; r != NULL && i < r->n; i++)
        r->of[i].part->summarize(r->of[i].memory, f);
}

void part_records_print(const struct part_records *r)
{
    for (int i = 0; r != NULL && i < r->n; i++)
        r->of[i].part->print(r->of[i].memory);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/part_record.h"

#include <stdlib.h>

#include "base/alloc.h"
#include "case/case_part.h"

struct one {
    const struct part_record_type *type;
    void *memory;
};

struct part_records {
    int n;
    struct one *of;
};

/* The record of part i; NULL if it writes nothing here. */
static const struct part_record_type *record_of(const struct simulation *sim,
                                                int i)
{
    const struct part_record_type *const r = case_parts[i]->record;
    return r != NULL && r->applies(sim) ? r : NULL;
}

int part_record_columns(const struct simulation *sim, int room,
                        const struct history_column **column)
{
    int n = 0;

    for (int i = 0; case_parts[i] != NULL; i++) {
        const struct part_record_type *const r = record_of(sim, i);
        if (r == NULL) continue;
        for (const struct history_column *c = r->columns;
             c->name != NULL && n < room; c++)
            column[n++] = c;
    }
    return n;
}

struct part_records *part_record_create(const struct simulation *sim,
                                        struct folder *folder, int *failed)
{
    int n = 0;

    *failed = 0;
    for (int i = 0; case_parts[i] != NULL; i++)
        n += record_of(sim, i) != NULL;
    if (n == 0) return NULL;
    struct part_records *const all = alloc_zeroed(1, sizeof *all);
    all->of = alloc_zeroed((size_t)n, sizeof *all->of);
    for (int i = 0; case_parts[i] != NULL && !*failed; i++) {
        const struct part_record_type *const r = record_of(sim, i);
        if (r == NULL) continue;
        all->of[all->n] = (struct one){r, r->create(sim, folder)};
        *failed = all->of[all->n].memory == NULL;
        all->n += !*failed;
    }
    return all;
}

void part_record_free(struct part_records *r)
{
    if (r == NULL) return;
    for (int i = 0; i < r->n; i++)
        r->of[i].type->free(r->of[i].memory);
    free(r->of);
    free(r);
}

int part_record_add_row(struct part_records *r)
{
    int failed = 0;

    for (int i = 0; r != NULL && i < r->n && !failed; i++)
        failed = r->of[i].type->add_row(r->of[i].memory);
    return failed;
}

int part_record_add_picture(struct part_records *r, double t)
{
    int failed = 0;

    for (int i = 0; r != NULL && i < r->n && !failed; i++)
        failed = r->of[i].type->add_picture(r->of[i].memory, t);
    return failed;
}

void part_record_summarize(const struct part_records *r, struct summary *f)
{
    for (int i = 0; r != NULL && i < r->n; i++)
        r->of[i].type->summarize(r->of[i].memory, f);
}

void part_record_print(const struct part_records *r)
{
    for (int i = 0; r != NULL && i < r->n; i++)
        r->of[i].type->print(r->of[i].memory);
}

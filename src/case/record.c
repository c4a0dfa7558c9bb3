/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/record.h"

#include <stddef.h>
#include <stdlib.h>

#include "base/alloc.h"

enum { MOST = 16 };

struct records {
    int n;
    const struct record *kind[MOST];
    void *memory[MOST];
};

/* A list, or a flag that is true. */
static int is_on(const struct settings *s, const struct record *r)
{
    const char *const path = r->keys[0].path;

    if (!settings_has(s, path)) return 0;
    if (r->keys[0].type == KEY_LIST) return settings_length(s, path) > 0;
    return r->keys[0].type != KEY_BOOL || settings_bool(s, path);
}

int records_check(const struct settings *s)
{
    int code = 0;

    for (int i = 0; records[i] != NULL && code == 0; i++)
        if (is_on(s, records[i]) && records[i]->check != NULL)
            code = records[i]->check(s);
    return code;
}

struct records *records_create(const struct settings *s,
                               const struct simulation *sim,
                               struct folder *folder)
{
    struct records *const r = alloc_zeroed(1, sizeof *r);

    for (int i = 0; records[i] != NULL && i < MOST; i++) {
        if (!is_on(s, records[i])) continue;
        r->kind[r->n] = records[i];
        r->memory[r->n++] = records[i]->create(s, sim, folder);
        if (r->memory[r->n - 1] != NULL) continue;
        records_free(r);
        return NULL;
    }
    return r;
}

int records_add_row(struct records *r)
{
    for (int i = 0; i < r->n; i++)
        if (r->kind[i]->add_row != NULL &&
            r->kind[i]->add_row(r->memory[i]) != 0)
            return 1;
    return 0;
}

int records_add_picture(struct records *r)
{
    for (int i = 0; i < r->n; i++)
        if (r->kind[i]->add_picture != NULL &&
            r->kind[i]->add_picture(r->memory[i]) != 0)
            return 1;
    return 0;
}

void records_free(struct records *r)
{
    if (r == NULL) return;
    for (int i = 0; i < r->n; i++)
        r->kind[i]->free(r->memory[i]);
    free(r);
}

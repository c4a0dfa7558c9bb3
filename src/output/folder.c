/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/folder.h"

#include "base/alloc.h"
#include "base/file.h"
#include "output/manifest/ownership.h"

#include <stdlib.h>
#include <string.h>

struct folder {
    char *dir;
    struct ownership *own;
    int resumes; /* [-] 1: tables that are there are continued */
};

struct folder *folder_open(const char *dir)
{
    struct ownership *const own = ownership_take(dir);

    if (own == NULL) return NULL;
    struct folder *const f = alloc_zeroed(1, sizeof *f);
    f->dir = strcpy(alloc_zeroed(strlen(dir) + 1, 1), dir);
    f->own = own;
    return f;
}

void folder_free(struct folder *f)
{
    if (f == NULL) return;
    ownership_free(f->own);
    free(f->dir);
    free(f);
}

void folder_abandon(struct folder *f)
{
    ownership_leave(f->own);
}

int folder_is_used(const struct folder *f)
{
    return ownership_is_used(f->own);
}

int folder_begin(struct folder *f)
{
    return ownership_begin(f->own);
}

char *folder_early_file(struct folder *f)
{
    return ownership_prepare(f->own) != 0
               ? NULL
               : file_join(f->dir, FOLDER_EARLY_FILE);
}

void folder_resume(struct folder *f)
{
    f->resumes = 1;
    ownership_resume(f->own);
}

void folder_state(struct folder *f, struct state *s)
{
    ownership_state(f->own, s);
    if (s->loading && !s->failed) f->resumes = 0;
}

char *folder_file(struct folder *f, const char *name)
{
    return ownership_list(f->own, name) == 0 ? file_join(f->dir, name) : NULL;
}

int folder_make(struct folder *f, const char *name)
{
    char *const entry = file_join(name, "");
    char *const path = file_join(f->dir, name);
    const int failed =
        ownership_list(f->own, entry) != 0 || file_make_dirs(path) != 0;

    free(entry);
    free(path);
    return failed;
}

int folder_list(struct folder *f, const char *path)
{
    return ownership_list(f->own, path + strlen(f->dir) + 1);
}

struct table *folder_table(struct folder *f, const char *name,
                           struct table_head *head)
{
    const char *const *const names = (const char *const *)head->name;
    char *const path = folder_file(f, name);
    struct table *const made = path == NULL ? NULL
                               : f->resumes
                                   ? table_open(path, head->n, names)
                                   : table_create(path, head->n, names);

    free(path);
    table_head_clear(head);
    return made;
}

const char *folder_name(const struct folder *f)
{
    return f->dir;
}

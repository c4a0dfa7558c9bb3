/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/folder.h"

#include "base/alloc.h"
#include "base/file.h"
#include "output/folder_owner.h"

#include <stdlib.h>
#include <string.h>

struct folder {
    char *dir;
    void *own;   /* of the owner */
    int resumes; /* [-] 1: tables that are there are continued */
};

/* NULL: nothing keeps the folder for this run. */
static const struct folder_owner *owner(void)
{
    return folder_owners[0];
}

struct folder *folder_open(const char *dir)
{
    void *const own = owner() != NULL ? owner()->take(dir) : NULL;

    if (owner() != NULL ? own == NULL : file_make_dirs(dir) != 0) return NULL;
    struct folder *const f = alloc_zeroed(1, sizeof *f);
    f->dir = strcpy(alloc_zeroed(strlen(dir) + 1, 1), dir);
    f->own = own;
    return f;
}

void folder_free(struct folder *f)
{
    if (f == NULL) return;
    if (owner() != NULL) owner()->free(f->own);
    free(f->dir);
    free(f);
}

void folder_abandon(struct folder *f)
{
    if (owner() != NULL) owner()->leave(f->own);
}

int folder_is_used(const struct folder *f)
{
    return owner() != NULL && owner()->is_used(f->own);
}

int folder_begin(struct folder *f)
{
    return owner() != NULL ? owner()->begin(f->own) : 0;
}

char *folder_early_file(struct folder *f)
{
    const int failed = owner() != NULL && owner()->prepare(f->own) != 0;
    return failed ? NULL : file_join(f->dir, FOLDER_EARLY_FILE);
}

void folder_resume(struct folder *f)
{
    f->resumes = 1;
    if (owner() != NULL) owner()->resume(f->own);
}

void folder_state(struct folder *f, struct state *s)
{
    if (owner() != NULL) owner()->state(f->own, s);
    if (s->loading && !s->failed) f->resumes = 0;
}

static int list(struct folder *f, const char *name)
{
    return owner() != NULL ? owner()->list(f->own, name) : 0;
}

char *folder_file(struct folder *f, const char *name)
{
    return list(f, name) == 0 ? file_join(f->dir, name) : NULL;
}

int folder_make(struct folder *f, const char *name)
{
    char *const entry = file_join(name, "");
    char *const path = file_join(f->dir, name);
    const int failed = list(f, entry) != 0 || file_make_dirs(path) != 0;

    free(entry);
    free(path);
    return failed;
}

int folder_list(struct folder *f, const char *path)
{
    return list(f, path + strlen(f->dir) + 1);
}

struct table *folder_table(struct folder *f, const char *name, int n_columns,
                           const char *const *columns)
{
    char *const path = folder_file(f, name);
    struct table *const made = path == NULL ? NULL
                               : f->resumes
                                   ? table_open(path, n_columns, columns)
                                   : table_create(path, n_columns, columns);

    free(path);
    return made;
}

const char *folder_name(const struct folder *f)
{
    return f->dir;
}

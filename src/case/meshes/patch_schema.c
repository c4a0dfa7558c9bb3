/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/meshes/patch_schema.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "base/alloc.h"
#include "case/schema.h"
#include "case/source.h"

/* The length of all paths with their closing zeros [byte]. */
static size_t room_for(const struct key *table, int n,
                       const struct mesh_patch_name *patch, int *rows)
{
    size_t text = 0;

    *rows = 1;
    for (const struct key *k = table; k->path != NULL; k++) {
        const int is_patch = strstr(k->path, KEY_ANY_PATCH) != NULL;
        *rows += is_patch ? n : 1;
        for (int i = 0; i < n && is_patch; i++)
            text += strlen(k->path) + strlen(patch[i].name) + 1;
    }
    return text;
}

static int is_of_patches(const struct key *table)
{
    for (const struct key *k = table; k->path != NULL; k++)
        if (strstr(k->path, KEY_ANY_PATCH) != NULL) return 1;
    return 0;
}

struct key *patch_schema_create(const struct key *table, int n,
                                const struct mesh_patch_name *patch)
{
    int rows;

    if (!is_of_patches(table)) return NULL;
    const size_t text = room_for(table, n, patch, &rows);
    struct key *const made =
        alloc_zeroed((size_t)rows * sizeof *made + text, 1);
    struct key *next = made;
    char *path = (char *)(made + rows);

    for (const struct key *k = table; k->path != NULL; k++) {
        const char *const at = strstr(k->path, KEY_ANY_PATCH);
        if (at == NULL) *next++ = *k;
        for (int i = 0; i < n && at != NULL; i++, next++) {
            *next = *k;
            next->path = path;
            path += sprintf(path, "%.*s%s%s", (int)(at - k->path), k->path,
                            patch[i].name, at + strlen(KEY_ANY_PATCH)) +
                    1;
            if (next->type == KEY_PATCH)
                next->what = "a patch of the mesh from files";
        }
    }
    *next = (struct key){.path = NULL};
    return made;
}

static const char *patch_schema_wrong(const struct key *const *tables,
                                      const char *name)
{
    if (!isalpha((unsigned char)name[0]))
        return "its name does not begin with a letter";
    for (const char *c = name; *c != '\0'; c++)
        if (!isalnum((unsigned char)*c) && *c != '_' && *c != '-')
            return "its name has other characters than letters, digits, _ and "
                   "-";
    SCHEMA_EACH (k, tables) {
        const char *const member = schema_member(k, "fluid");
        if (member != NULL && strcmp(member, name) == 0)
            return "the fluid has a key of that name";
    }
    return NULL;
}

int patch_schema_check(const struct key *const *tables,
                       const config_setting_t *at, int n,
                       const struct mesh_patch_name *patch)
{
    for (int i = 0; i < n; i++) {
        const char *const why = patch_schema_wrong(tables, patch[i].name);
        if (why != NULL)
            return source_wrong(at,
                                "mesh.polymesh: the patch %s cannot be named "
                                "in a case: %s; rename it in the file boundary",
                                patch[i].name, why);
    }
    return 0;
}

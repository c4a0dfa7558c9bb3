/* SPDX-License-Identifier: GPL-3.0-or-later */
/* poly_folder.c -- where the files of a mesh are, and what its patches are
 * called. */
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "mesh/poly/poly.h"
#include "mesh/poly/poly_raw.h"

int poly_folder(const char *dir, char folder[POLY_FOLDER])
{
    static const char *const within[] = {"", "/polyMesh", "/constant/polyMesh"};

    for (int i = 0; i < 6; i++) {
        char file[POLY_FOLDER + 16];
        snprintf(folder, POLY_FOLDER, "%s%s", dir, within[i / 2]);
        snprintf(file, sizeof file, "%s/boundary%s", folder,
                 i % 2 ? ".gz" : "");
        if (access(file, R_OK) == 0) return 1;
    }
    snprintf(folder, POLY_FOLDER, "%s", dir);
    return 0;
}

int poly_is(const char *dir)
{
    char folder[POLY_FOLDER];
    return poly_folder(dir, folder);
}

int poly_patches(const char *dir, struct mesh_patch_name **list)
{
    struct poly_raw r = {0};
    char folder[POLY_FOLDER];
    int n = -1;

    *list = NULL;
    poly_folder(dir, folder);
    if (!poly_raw_read_parts(&r, folder)) {
        n = 0;
        *list = alloc_zeroed((size_t)r.n_parts + 1, sizeof **list);
        for (int i = 0; i < r.n_parts; i++)
            if (strcmp(r.part[i].type, "cyclic") != 0)
                memcpy((*list)[n++].name, r.part[i].name, sizeof(*list)->name);
    }
    poly_raw_release(&r);
    return n;
}

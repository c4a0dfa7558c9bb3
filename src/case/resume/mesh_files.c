/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/resume/mesh_files.h"

#include <stdio.h>

#include "base/tables/input.h"
#include "mesh/poly/poly.h"

void mesh_files_each(const char *dir, void (*each)(void *of, const char *path),
                     void *of)
{
    static const char *const parts[] = {"points", "faces", "owner", "neighbour",
                                        "boundary"};
    char folder[POLY_FOLDER], path[POLY_FOLDER + 16];

    poly_folder(dir, folder);
    for (int i = 0; i < 10; i++) {
        snprintf(path, sizeof path, "%s/%s%s", folder, parts[i / 2],
                 i % 2 ? ".gz" : "");
        if (input_wrong(path) == NULL) each(of, path);
    }
}

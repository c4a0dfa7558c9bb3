/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "scene/scene.h"

#include "effects/effects.h"
#include "scene/case_mesh.h"
#include "scene/case_surfaces.h"
#include "scene/checks.h"
#include "scene/keys.h"

#include <assert.h>
#include <stddef.h>

void scene_tables(const struct key *tables[SCENE_TABLES])
{
    int n = 0;

    tables[n++] = keys_core;
    tables[n++] = keys_surfaces;
    for (int i = 0; effects_all[i] != NULL; i++) {
        assert(n < SCENE_TABLES - 1);
        tables[n++] = effects_all[i]->keys;
    }
    tables[n] = NULL;
}

struct settings *scene_read(const char *file, int n_overrides,
                            const char *const *overrides, int *code)
{
    const struct key *tables[SCENE_TABLES];
    struct settings *s;

    scene_tables(tables);
    s = settings_create(file, n_overrides, overrides, tables, code);
    if (s == NULL) return NULL;
    *code = case_mesh_read(s);
    if (*code == 0) *code = checks_whole(s);
    if (*code == 0) return s;
    settings_free(s);
    return NULL;
}

static int numbers_of(const struct settings *s, const struct key *key,
                      double v[3])
{
    switch (key->type) {
    case KEY_REAL:
        v[0] = settings_real(s, key->path);
        return 1;
    case KEY_INT:
        v[0] = settings_int(s, key->path);
        return 1;
    case KEY_BOOL:
        v[0] = settings_bool(s, key->path);
        return 1;
    case KEY_VECTOR:
        settings_vector(s, key->path, v);
        return 3;
    default:
        return 0;
    }
}

int scene_parameters(const struct settings *s, const struct key *keys,
                     double *numbers, int most)
{
    int n = 0;

    for (const struct key *key = keys; key->path != NULL; key++) {
        double v[3];
        const int given = numbers_of(s, key, v);

        for (int k = 0; k < given; k++, n++)
            if (n < most) numbers[n] = v[k];
    }
    return n;
}

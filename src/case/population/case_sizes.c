/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/population/case_sizes.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/alloc.h"
#include "case/models.h"
#include "case/nearest.h"

static const char list[] = "particles.sizes";

/* The points are to be released with free(). */
static struct sizes_options case_sizes_options(const struct settings *s, int i)
{
    const struct sizes_setup *const one = &s->particles.sizes.item[i];
    struct sizes_options o = one->of;
    int n = 0;

    o.by_mass = strcmp(one->by, "mass") == 0;
    for (const struct key *k = o.law->own_keys; k != NULL && k->path != NULL;
         k++)
        o.own[n++] =
            settings_item_real_or(s, list, i, strrchr(k->path, '.') + 1, 0.0);
    o.n = one->points.n;
    if (o.n == 0) return o;
    double(*const point)[2] = alloc_zeroed((size_t)o.n, sizeof *point);
    for (int k = 0; k < o.n; k++) {
        point[k][0] = one->points.at[k];
        point[k][1] = one->points.value[k];
    }
    o.point = (const double(*)[2])point;
    return o;
}

static int sizes_named(const struct settings *s, const char *name)
{
    int i = 0;

    while (i < s->particles.sizes.n &&
           strcmp(s->particles.sizes.item[i].name, name) != 0)
        i++;
    return i;
}

int case_sizes_check(const struct settings *s)
{
    for (int i = 0; i < s->particles.sizes.n; i++) {
        const char *const name = s->particles.sizes.item[i].name;
        const struct sizes_options o = case_sizes_options(s, i);
        const char *const wrong = sizes_wrong(&o);

        free((void *)o.point);
        if (wrong != NULL)
            return settings_wrong(s, list, "%s, which is %s: %s", name,
                                  o.law->name, wrong);
        if (sizes_named(s, name) != i)
            return settings_wrong(s, list, "two are called %s", name);
    }
    return 0;
}

int case_sizes_check_name(const struct settings *s, const char *key,
                          const char *name)
{
    struct nearest n;

    if (sizes_named(s, name) < s->particles.sizes.n) return 0;
    nearest_init(&n, name);
    for (int i = 0; i < s->particles.sizes.n; i++)
        nearest_offer(&n, s->particles.sizes.item[i].name);
    const char *const best = nearest_best(&n);
    return settings_wrong(s, key, "no distribution in %s is called %s%s%s",
                          list, name, best != NULL ? "; did you mean " : "",
                          best != NULL ? best : "");
}

struct sizes *case_sizes_create(const struct settings *s, const char *name)
{
    const struct sizes_options o = case_sizes_options(s, sizes_named(s, name));
    struct sizes *const made = sizes_create(&o);

    free((void *)o.point);
    return made;
}

MODELS_KIND(case_sizes_kind, sizes_laws, "sizes", "distributions of diameters",
            "particles.sizes.distribution", NULL)

int case_sizes_check_file(const struct settings *s)
{
    const char *const name = s->particles.bed_file;
    char path[SETTINGS_PATH];

    if (name == NULL || (name[0] != '/' && strstr(name, "..") == NULL))
        return 0;
    settings_beside(s, name, path, sizeof path);
    if (access(path, F_OK) == 0) return 0;
    return settings_wrong(s, "particles.bed.file",
                          "%s is not there, and a bed is written beside the "
                          "case or in a folder there alone: expected a name "
                          "that neither begins with / nor has .. in it",
                          path);
}

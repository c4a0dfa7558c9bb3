/* SPDX-License-Identifier: GPL-3.0-or-later */
/* model_choice.c -- which models a case chooses, and whether it gives each the
 * keys that it asks for, and no key of another. */
#include "case/checks/checks.h"

#include "averaging/averaging.h"
#include "case/schema.h"
#include "coupling/drag.h"
#include "dem/contact.h"
#include "fluid/inlet_profile.h"

#include <stdio.h>
#include <string.h>

/* The group that a key is in, and its own name. */
static const char *key_split(const char *path, char group[SCHEMA_TEXT])
{
    const char *const dot = strrchr(path, '.');

    snprintf(group, SCHEMA_TEXT, "%.*s", dot == NULL ? 0 : (int)(dot - path),
             path);
    return dot == NULL ? path : dot + 1;
}

/* 1 if the side chooses the model as its condition, or as its profile. */
static int is_chosen_by_side(const struct boundary_options *side,
                             const struct kind *kind, const struct model *m)
{
    const char *const name = kind->list == boundary_conditions
                                 ? side->condition->name
                             : side->has_profile ? side->profile->name
                                                 : "";
    return strcmp(name, m->name) == 0;
}

static int is_chosen_by_some_side(const struct settings *s,
                                  const struct kind *kind,
                                  const struct model *m)
{
    for (int i = 0; i < s->sides.n; i++)
        if (is_chosen_by_side(&s->sides.item[i], kind, m)) return 1;
    return 0;
}

/* 1 if one of the groups of a list chose that model. */
static int is_chosen_in_list(const struct settings *s, const char *list,
                             const char *key, const char *model)
{
    for (int i = 0; i < settings_length(s, list); i++)
        if (strcmp(settings_item_text(s, list, i, key), model) == 0) return 1;
    return 0;
}

/* 1 if the group is there in which the key of a kind is; and, where the key
 * belongs to other models, one of these is chosen. */
static int is_choice_read(const struct settings *s, const struct kind *kind)
{
    char group[SCHEMA_TEXT];
    struct model m;
    int owned = 0;

    key_split(kind->key, group);
    if (!settings_has(s, kind->group != NULL ? kind->group
                         : group[0] != '\0'  ? group
                                             : kind->key))
        return 0;
    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_at(k, i, &m); i++)
            if (models_reads(&m, kind->key)) {
                if (model_choice_is_on(s, k, &m)) return 1;
                owned = 1;
            }
    return !owned;
}

int model_choice_is_on(const struct settings *s, const struct kind *kind,
                       const struct model *m)
{
    char group[SCHEMA_TEXT], path[SCHEMA_TEXT];
    const char *const key = key_split(kind->key, group);

    if (!is_choice_read(s, kind)) return 0;
    if (strstr(kind->key, KEY_ANY_PATCH) != NULL)
        return is_chosen_by_some_side(s, kind, m);
    if (settings_is_list(s, group))
        return is_chosen_in_list(s, group, key, m->name);
    if (group[0] != '\0')
        return strcmp(settings_text(s, kind->key), m->name) == 0;
    snprintf(path, sizeof path, "%s.%s", kind->key, m->name);
    return settings_has(s, path);
}

int model_choice_refuse_unread(const struct settings *s, const char *kind,
                               const char *path)
{
    const struct kind *const k = models_kind(kind);
    char names[SCHEMA_TEXT] = "";
    struct model m;
    size_t used = 0;

    for (int i = 0; models_at(k, i, &m); i++) {
        if (!models_reads(&m, path)) continue;
        if (model_choice_is_on(s, k, &m)) return 0;
        used += (size_t)snprintf(names + used, sizeof names - used, "%s%s",
                                 used > 0 ? ", " : "", m.name);
    }
    return settings_wrong(s, path, "it is not used with %s; it is a key of %s",
                          settings_text(s, k->key), names);
}

/* 1 if the key is one that the i-th group of the list must have: 0 if this
 * group chooses another model of the kind. */
static int may_ask(const struct settings *s, const struct kind *kind,
                   const char *list, int i, const struct model *m)
{
    char of[SCHEMA_TEXT];
    const char *const key = key_split(kind->key, of);

    return strcmp(of, list) != 0 ||
           strcmp(settings_item_text(s, list, i, key), m->name) == 0;
}

/* The key that a condition or a profile asks for, on each side that chooses it.
 */
static int refuse_missing_on_sides(const struct settings *s,
                                   const struct kind *kind,
                                   const struct model *m, const char *path)
{
    char key[SCHEMA_TEXT];

    for (int i = 0; i < s->sides.n; i++) {
        const struct boundary_options *const o = &s->sides.item[i];
        snprintf(key, sizeof key, "%s%s", o->key, strrchr(path, '.'));
        if (is_chosen_by_side(o, kind, m) && !settings_has(s, key))
            return settings_wrong(s, o->key, "%s needs %s", m->name, key);
    }
    return 0;
}

/* The key that a model asks for, in a group or in each group of a list. */
static int refuse_missing(const struct settings *s, const struct kind *kind,
                          const struct model *m, const char *path)
{
    char list[SCHEMA_TEXT];
    const char *const key = key_split(path, list);

    if (strstr(path, KEY_ANY_PATCH) != NULL)
        return refuse_missing_on_sides(s, kind, m, path);
    if (!settings_is_list(s, list))
        return settings_has(s, path)
                   ? 0
                   : settings_wrong(s, kind->key, "%s needs %s", m->name, path);
    for (int i = 0; i < settings_length(s, list); i++)
        if (may_ask(s, kind, list, i, m) && !settings_item_has(s, list, i, key))
            return settings_wrong(s, list, "%s needs the %s of %s", m->name,
                                  key, settings_item_text(s, list, i, "name"));
    return 0;
}

/* A key that a model alone reads, given where another one is chosen. */
static int refuse_unread_keys(const struct settings *s, const char *kind,
                              const struct key *own)
{
    int code = 0;

    for (const struct key *k = own; k != NULL && k->path != NULL; k++)
        if (code == 0 && settings_has(s, k->path))
            code = model_choice_refuse_unread(s, kind, k->path);
    return code;
}

int model_choice_check(const struct settings *s)
{
    struct model m;
    int code = 0;

    for (int i = 0; drag_laws[i] != NULL && code == 0; i++)
        code = refuse_unread_keys(s, "drag", drag_laws[i]->own_keys);
    for (int i = 0; contact_laws[i] != NULL && code == 0; i++)
        code = refuse_unread_keys(s, "contact", contact_laws[i]->own_keys);
    for (int i = 0; averaging_methods[i] != NULL && code == 0; i++)
        code =
            refuse_unread_keys(s, "averaging", averaging_methods[i]->own_keys);
    if (code != 0) return code;

    for (const struct kind *k = models_kinds; k->name != NULL; k++)
        for (int i = 0; models_at(k, i, &m); i++)
            for (int t = 0; t < KEY_TABLES && m.keys[t] != NULL; t++)
                for (const struct key *row = m.keys[t]; row->path != NULL;
                     row++)
                    if (row->fallback != NULL && schema_is_required(row) &&
                        model_choice_is_on(s, k, &m) &&
                        refuse_missing(s, k, &m, row->path) != 0)
                        return 2;
    return 0;
}

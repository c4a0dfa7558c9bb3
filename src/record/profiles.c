/* SPDX-License-Identifier: GPL-3.0-or-later */
/* profiles.c -- time averages on lines, the files of DIR/profiles/. */
#include "record/profiles.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "output/means/profile.h"
#include "case/case_mesh.h"
#include "case/case_steps.h"
#include "record/field_names.h"
#include "record/recorder_part.h"

static const char list[] = "output.profiles";

struct line {
    struct profile *profile;
    char name[PROFILES_NAME]; /* of its file */
    int upright; /* [-] 1: along gravity, so that no mirror leaves it alone */
};

struct profiles {
    const struct snapshot *snapshot;
    struct folder *folder;
    double dt; /* [s] between two samples */
    int n;
    struct line *line;
};

/* The keys that give the place of a line, by direction. */
static const char *const place[3] = {"x", "height", "z"};

/* The line of a profile; `across` is -1 where the case does not say where it
 * lies. */
static struct profile_line profiles_line_of(const struct output_profile *p)
{
    struct profile_line l = {
        .along = p->along[0] - 'x', .across = -1, .from = p->from};

    for (int k = 0; k < 3; k++)
        if (k != l.along && p->has_place[k]) {
            l.across = k;
            l.at = p->place[k];
        }
    return l;
}

/* What the file of a profile is called but for its ending: by field, direction
 * if it is not x, and place, in millimetres. */
static void short_name(const struct output_profile *p, char name[PROFILES_NAME])
{
    static const char *const along[3] = {"", "_along_y", "_along_z"};
    const struct profile_line l = profiles_line_of(p);

    snprintf(name, PROFILES_NAME, "%s%s_%c%gmm", p->field, along[l.along],
             "xyz"[l.across], 1e3 * l.at);
}

struct name {
    char text[PROFILES_NAME];
    int i; /* [-] of its profile */
};

static int profiles_by_text(const void *a, const void *b)
{
    const struct name *const p = a, *const q = b;
    const int order = strcmp(p->text, q->text);

    return order != 0 ? order : p->i - q->i;
}

/* The names of all profiles, sorted; freed by the caller. */
static struct name *names_of(const struct settings *s)
{
    const struct output_profile *const p = s->output.profiles.item;
    const int n = s->output.profiles.n;
    struct name *const all = alloc_zeroed((size_t)n, sizeof *all);

    for (int i = 0; i < n; i++) {
        short_name(&p[i], all[i].text);
        all[i].i = i;
    }
    qsort(all, (size_t)n, sizeof *all, profiles_by_text);
    for (int k = n - 1; k > 0; k--) {
        char *const text = all[k].text;
        if (strcmp(text, all[k - 1].text) != 0) continue;
        snprintf(text + strlen(text), PROFILES_NAME - strlen(text), "_from%gs",
                 p[all[k].i].from);
    }
    qsort(all, (size_t)n, sizeof *all, profiles_by_text);
    return all;
}

void profiles_name(const struct settings *s, int i, char name[PROFILES_NAME])
{
    struct name *const all = names_of(s);
    int k = 0;

    while (all[k].i != i)
        k++;
    strcpy(name, all[k].text);
    free(all);
}

/* --- checks --------------------------------------------------------------- */

/* A line has one place, in one of the two directions that it does not follow,
 * and lies within the box. */
static int profiles_check_place(const struct settings *s, int i)
{
    const struct output_profile *const p = &s->output.profiles.item[i];
    const struct profile_line l = profiles_line_of(p);
    const int one = l.along == 0, two = l.along == 2 ? 1 : 2;
    double lo[3], hi[3];

    if (p->has_place[l.along])
        return settings_wrong(s, list,
                              "profile %d goes along %c and so has no %s; "
                              "expected %s or %s, in m",
                              i, "xyz"[l.along], place[l.along], place[one],
                              place[two]);
    if (p->has_place[one] == p->has_place[two])
        return settings_wrong(s, list,
                              "profile %d goes along %c: expected %s or %s, in "
                              "m, the place of its line%s",
                              i, "xyz"[l.along], place[one], place[two],
                              l.across < 0 ? "" : ", and not both");
    case_mesh_ends(s, lo, hi);
    if (l.at >= lo[l.across] && l.at <= hi[l.across]) return 0;
    const int over = l.at > hi[l.across];
    return settings_wrong(s, list, "%s %g m is %s the box, %g m",
                          place[l.across], l.at,
                          l.across != 1 ? "beyond"
                          : over        ? "above"
                                        : "below",
                          over ? hi[l.across] : lo[l.across]);
}

/* Of two profiles in one file only the last would be left. */
static int profiles_check_names(const struct settings *s)
{
    struct name *const all = names_of(s);
    const struct name *again = NULL;
    int code = 0;

    for (int k = 1; k < s->output.profiles.n; k++)
        if (strcmp(all[k].text, all[k - 1].text) == 0 &&
            (again == NULL || all[k].i < again->i))
            again = &all[k];
    if (again != NULL)
        code = settings_wrong(s, list,
                              "profiles %d and %d are of the same field on the "
                              "same line from the same time: both would be "
                              "%s.csv; leave one of them out",
                              again[-1].i, again->i, again->text);
    free(all);
    return code;
}

static int profiles_check(const struct settings *s)
{
    const int n = s->output.profiles.n;
    int code = 0;

    for (int i = 0; i < n && code == 0; i++)
        code = field_names_check(s, list, s->output.profiles.item[i].field);
    for (int i = 0; i < n && code == 0; i++)
        code = profiles_check_place(s, i);
    return code != 0 ? code : profiles_check_names(s);
}

/* --- a run ---------------------------------------------------------------- */

static int create_line(const struct recorder_view *v, int i, struct line *line)
{
    const struct settings *const s = v->settings;
    const struct output_profile *const p = &s->output.profiles.item[i];
    const struct profile_line where = profiles_line_of(p);
    const struct profile_field field = field_names_find(v->whole, p->field);

    if (field.values == NULL)
        return settings_wrong(s, list, "the case has no field %s", field.name);
    line->upright = v->sim->gravity[where.along] != 0.0;
    line->profile = profile_create(v->drawn->mesh, &where, 1, &field);
    return line->profile == NULL;
}

static void profiles_release(void *part)
{
    struct profiles *const l = part;

    for (int i = 0; i < l->n; i++)
        profile_free(l->line[i].profile);
    free(l->line);
    free(l);
}

static void *profiles_create(const struct recorder_view *v, int *failed)
{
    const int n = v->settings->output.profiles.n;

    if (n == 0) return NULL;
    struct profiles *const l = alloc_zeroed(1, sizeof *l);
    l->snapshot = v->whole;
    l->folder = v->folder;
    l->dt = (double)case_steps_between_rows(v->settings) * v->sim->dt;
    l->n = n;
    l->line = alloc_zeroed((size_t)n, sizeof *l->line);
    for (int i = 0; i < n && !*failed; i++)
        *failed = create_line(v, i, &l->line[i]) != 0;
    struct name *const names = names_of(v->settings);
    for (int k = 0; k < n; k++)
        strcpy(l->line[names[k].i].name, names[k].text);
    free(names);
    if (!*failed) return l;
    profiles_release(l);
    return NULL;
}

/* Takes a sample of the snapshot. */
static int profiles_add(void *part)
{
    struct profiles *const l = part;

    for (int i = 0; i < l->n; i++)
        profile_add(l->line[i].profile, l->snapshot->t, l->dt);
    return 0;
}

/* How far each can be trusted: its mirror error and its error by blocks
 * (output/means/profile.h). */
static void profiles_summarize(const void *part, struct summary *to)
{
    const struct profiles *const l = part;

    summary_begin(to, "profiles");
    for (int i = 0; i < l->n; i++) {
        const struct profile *const p = l->line[i].profile;
        summary_begin(to, l->line[i].name);
        if (!l->line[i].upright)
            summary_number(to, "mirror_error", profile_mirror_error(p, 0));
        summary_number(to, "block_error", profile_block_error(p, 0));
        summary_end(to);
    }
    summary_end(to);
}

static void profiles_visit(void *part, struct state *s)
{
    struct profiles *const l = part;

    state_begin(s, "profiles");
    for (int i = 0; i < l->n; i++) {
        state_begin(s, l->line[i].name);
        profile_state(l->line[i].profile, s);
        state_end(s);
    }
    state_end(s);
}

static int write_line(const struct line *l, struct folder *folder)
{
    char name[sizeof l->name + sizeof "profiles/.csv"];

    snprintf(name, sizeof name, "profiles/%s.csv", l->name);
    char *const path = folder_file(folder, name);
    const int failed = path == NULL || profile_write(l->profile, path) != 0;
    free(path);
    return failed;
}

static int profiles_finish(void *part)
{
    const struct profiles *const l = part;
    int failed = folder_make(l->folder, "profiles");

    for (int i = 0; i < l->n && !failed; i++)
        failed = write_line(&l->line[i], l->folder);
    return failed;
}

static const struct key keys[] = {
    {"output.profiles", KEY_LIST, "", "", "",
     "time averages on lines, each { field, along, height or x or z, from }; "
     "over the third direction they are means",
     "SX15 Fig. 4-7", "", .at = KEY_AT(output_options, profiles),
     .size = sizeof(struct output_profile)},
    {"output.profiles.field", KEY_NAME, "", FIELD_NAMES, NULL,
     "fluid or solid fraction, pressure, velocity of the fluid (u) or of the "
     "particles (us)",
     "", "", .at = KEY_AT(output_profile, field)},
    {"output.profiles.along", KEY_NAME, "", "x | y | z", "x",
     "direction of the line", "SX15 Fig. 4-7", "",
     .at = KEY_AT(output_profile, along)},
    {"output.profiles.height", KEY_REAL, "m", ">= 0", KEY_OPTIONAL,
     "y of a line along x or z", "", "", .at = KEY_AT(output_profile, place[1]),
     .given = KEY_AT(output_profile, has_place[1])},
    {"output.profiles.x", KEY_REAL, "m", "", KEY_OPTIONAL,
     "x of a line along y or z", "", "", .at = KEY_AT(output_profile, place[0]),
     .given = KEY_AT(output_profile, has_place[0])},
    {"output.profiles.z", KEY_REAL, "m", "", KEY_OPTIONAL,
     "z of a line along x or y", "", "", .at = KEY_AT(output_profile, place[2]),
     .given = KEY_AT(output_profile, has_place[2])},
    {"output.profiles.from", KEY_REAL, "s", ">= 0", "0.0",
     "time at which the average begins; later than the end: none", "", "",
     .at = KEY_AT(output_profile, from)},
    KEY_END};

const struct recorder_part profiles_part = {.keys = keys,
                                            .check = profiles_check,
                                            .create = profiles_create,
                                            .free = profiles_release,
                                            .row = profiles_add,
                                            .finish = profiles_finish,
                                            .summarize = profiles_summarize,
                                            .state = profiles_visit};

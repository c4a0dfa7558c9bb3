/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_bodies_check.c -- what a case may not ask of its bodies. */
#include "case/resolved/case_bodies.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "case/case_mesh.h"
#include "case/resolved/case_blocks.h"
#include "case/resolved/case_outlines.h"

static const char list[] = "bodies.spheres";

static int is(const struct settings *s, int i, const char *motion)
{
    return strcmp(settings_item_text(s, list, i, "motion"), motion) == 0;
}

/* Width of a cell in each direction [m]. */
void case_bodies_cell_widths(const struct settings *s, double h[3])
{
    double lo[3], hi[3];
    int n[3];

    case_mesh_ends(s, lo, hi);
    settings_counts(s, "mesh.cells", n);
    for (int k = 0; k < 3; k++)
        h[k] = (hi[k] - lo[k]) / n[k];
}

static int check_mesh(const struct settings *s)
{
    double grading[3];

    if (settings_mesh(s) != NULL)
        return settings_wrong(s, "bodies",
                              "bodies are held in the cells of a plain box; "
                              "leave out mesh.polymesh and mesh.shear");
    settings_vector(s, "mesh.grading", grading);
    for (int k = 0; k < 3; k++)
        if (fabs(grading[k] - 1.0) > 0.01)
            return settings_wrong(s, "mesh.grading",
                                  "%g: bodies ask for equal cells", grading[k]);
    return 0;
}

/* A sphere of fewer cells than these is a few of them and has no shape. Less
 * than 3 by rounding is 3. */
const double case_bodies_least_cells = 3.0 * (1.0 - 1e-9);

static int check_sphere(const struct settings *s, int i)
{
    const double d = settings_item_real(s, list, i, "diameter");
    double lo[3], hi[3], h[3], x[3];
    int periodic[3];

    case_mesh_ends(s, lo, hi);
    case_mesh_periodic(s, periodic);
    case_bodies_cell_widths(s, h);
    settings_item_vector(s, list, i, "position", x);
    if (is(s, i, "free") && !settings_item_has(s, list, i, "density"))
        return settings_wrong(s, list,
                              "sphere %d is free and asks for its density", i);
    for (int k = 0; k < 3; k++) {
        const double margin = periodic[k] || is(s, i, "fixed") ? 0.0 : 0.5 * d;
        if (x[k] < lo[k] + margin || x[k] > hi[k] - margin)
            return settings_wrong(s, list,
                                  "sphere %d at [%g, %g, %g] m with diameter "
                                  "%g m is not inside the box",
                                  i, x[0], x[1], x[2], d);
        if (d < case_bodies_least_cells * h[k])
            return settings_wrong(s, list,
                                  "sphere %d has a diameter of %.3g cells; "
                                  "expected at least %g, better 12",
                                  i, d / h[k], case_bodies_least_cells);
        if (periodic[k] &&
            d >= (is(s, i, "fixed") ? 1.0 : 0.5) * (hi[k] - lo[k]))
            return settings_wrong(s, list,
                                  "sphere %d with diameter %g m meets itself "
                                  "across the period, %g m; %s",
                                  i, d, hi[k] - lo[k],
                                  is(s, i, "fixed")
                                      ? "expected less"
                                      : "expected less than half of it");
    }
    return 0;
}

/* What moves by its mass against a spring. */
static int check_spring(const struct settings *s, const char *of, int i)
{
    double k[3];

    if (strcmp(settings_item_text(s, of, i, "motion"), "spring") != 0) return 0;
    settings_item_vector(s, of, i, "spring", k);
    if (!(vector_length(k) > 0.0))
        return settings_wrong(s, of,
                              "number %d is on a spring and asks for its "
                              "stiffness, spring = [kx, ky, kz] in N/m",
                              i);
    if (settings_item_has(s, of, i, "density")) return 0;
    return settings_wrong(
        s, of, "number %d is on a spring and asks for its density", i);
}

static const char *const lists[] = {"bodies.spheres", "bodies.boxes",
                                    "bodies.cylinders", "bodies.clumps",
                                    "bodies.surfaces"};
enum { LISTS = sizeof lists / sizeof *lists };

/* What is fixed has no velocity. */
static int check_velocity(const struct settings *s, const char *of, int i)
{
    double v[3];

    settings_item_vector(s, of, i, "velocity", v);
    if (vector_length(v) == 0.0 ||
        strcmp(settings_item_text(s, of, i, "motion"), "fixed") != 0)
        return 0;
    return settings_wrong(s, of,
                          "number %d is fixed and has a velocity; motion = "
                          "\"prescribed\" keeps it",
                          i);
}

static int check_motions(const struct settings *s)
{
    int code = 0;

    for (int l = 0; l < LISTS; l++)
        for (int i = 0; i < settings_length(s, lists[l]) && code == 0; i++) {
            code = check_spring(s, lists[l], i);
            if (code == 0) code = check_velocity(s, lists[l], i);
        }
    return code;
}

static int none(const struct settings *s)
{
    int all = 0;

    for (int l = 0; l < LISTS; l++)
        all += settings_length(s, lists[l]);
    return all == 0;
}

static int any_moves(const struct settings *s)
{
    for (int l = 0; l < LISTS; l++)
        for (int i = 0; i < settings_length(s, lists[l]); i++)
            if (strcmp(settings_item_text(s, lists[l], i, "motion"), "fixed") !=
                0)
                return 1;
    return 0;
}

/* Bodies among particles: a body in the way of a method that sets velocities by
 * solid fractions, a cell that a body enters, and what knows no surfaces. */
static int check_particles(const struct settings *s)
{
    static const char *const pulls[] = {"effects.van_der_waals",
                                        "effects.capillary"};

    if (strcmp(settings_text(s, "bodies.method"), "hold") != 0)
        return settings_wrong(s, "bodies.method",
                              "among particles bodies hold the fluid by "
                              "\"hold\" only");
    if (settings_length(s, case_outlines_clumps) > 0)
        return settings_wrong(s, case_outlines_clumps,
                              "clumps do not touch particles; give the body as "
                              "a closed surface, in bodies.surfaces");
    if (settings_has(s, "exchange") && any_moves(s) &&
        strcmp(settings_text(s, "fluid.continuity"), "mixture") != 0)
        return settings_wrong(s, "fluid.continuity",
                              "among particles a body that moves asks for "
                              "\"mixture\": where it comes, the fluid fraction "
                              "jumps");
    for (int k = 0; k < 2; k++)
        if (settings_has(s, pulls[k]))
            return settings_wrong(s, "bodies",
                                  "%s acts between particles and the box, not "
                                  "on bodies: leave one of them out",
                                  pulls[k]);
    if (settings_has(s, "particles.bed") &&
        settings_has(s, "particles.bed.file"))
        return settings_wrong(s, "bodies",
                              "a bed that settles around bodies is not kept in "
                              "a file: leave particles.bed.file out");
    return 0;
}

int case_bodies_check(const struct settings *s)
{
    if (!settings_has(s, "bodies")) return 0;
    int code = check_mesh(s);

    if (none(s))
        return settings_wrong(s, "bodies",
                              "there is no body; give spheres, boxes, "
                              "cylinders, clumps or surfaces");
    if (settings_has(s, "particles") && code == 0) code = check_particles(s);
    for (int i = 0; i < settings_length(s, list) && code == 0; i++)
        code = check_sphere(s, i);
    if (code == 0) code = check_motions(s);
    if (code == 0) code = case_outlines_check(s);
    return code != 0 ? code : case_blocks_check(s);
}

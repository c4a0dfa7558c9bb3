/* SPDX-License-Identifier: GPL-3.0-or-later */
/* case_bodies_check.c -- what a case may not ask of its bodies. */
#include "case/cohesion/case_cohesion.h"
#include "case/resolved/case_bodies.h"

#include <math.h>
#include <string.h>

#include "base/vector.h"
#include "case/case_mesh.h"
#include "case/resolved/case_blocks.h"
#include "case/resolved/case_outlines.h"

const char case_bodies_spheres[] = "bodies.spheres";
static const char *const list = case_bodies_spheres;
const char *const case_bodies_lists[] = {
    case_bodies_spheres,  case_blocks_boxes,      case_blocks_cylinders,
    case_outlines_clumps, case_outlines_surfaces, NULL};

int case_bodies_count(const struct settings *s)
{
    int all = 0;

    for (int l = 0; case_bodies_lists[l] != NULL; l++)
        all += settings_length(s, case_bodies_lists[l]);
    return all;
}

int case_bodies_is(const struct settings *s, const char *of, int i,
                   const char *motion)
{
    return strcmp(settings_item_text(s, of, i, "motion"), motion) == 0;
}

/* Width of a cell in each direction [m]. */
void case_bodies_cell_widths(const struct settings *s, double h[3])
{
    double lo[3], hi[3];

    case_mesh_ends(s, lo, hi);
    for (int k = 0; k < 3; k++)
        h[k] = (hi[k] - lo[k]) / s->mesh.box.cells[k];
}

static int check_mesh(const struct settings *s)
{
    const double *const grading = s->mesh.box.grading;

    if (settings_mesh(s) != NULL)
        return settings_wrong(s, "bodies",
                              "bodies are held in the cells of a plain box; "
                              "leave out mesh.polymesh and mesh.shear");
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
    if (case_bodies_is(s, list, i, "free") &&
        !settings_item_has(s, list, i, "density"))
        return settings_wrong(s, list,
                              "sphere %d is free and asks for its density", i);
    for (int k = 0; k < 3; k++) {
        const double margin =
            periodic[k] || case_bodies_is(s, list, i, "fixed") ? 0.0 : 0.5 * d;
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
            d >= (case_bodies_is(s, list, i, "fixed") ? 1.0 : 0.5) *
                     (hi[k] - lo[k]))
            return settings_wrong(s, list,
                                  "sphere %d with diameter %g m meets itself "
                                  "across the period, %g m; %s",
                                  i, d, hi[k] - lo[k],
                                  case_bodies_is(s, list, i, "fixed")
                                      ? "expected less"
                                      : "expected less than half of it");
    }
    return 0;
}

/* What moves by its mass against a spring, along the axes that have one. */
static int check_spring(const struct settings *s, const char *of, int i)
{
    double k[3], v[3];

    settings_item_vector(s, of, i, "spring", k);
    settings_item_vector(s, of, i, "velocity", v);
    if (case_bodies_is(s, of, i, "free") && vector_length(k) > 0.0)
        return settings_wrong(s, of,
                              "number %d is free and has a spring; motion = "
                              "\"spring\" holds it by that",
                              i);
    if (!case_bodies_is(s, of, i, "spring")) return 0;
    if (!(vector_length(k) > 0.0))
        return settings_wrong(s, of,
                              "number %d is on a spring and asks for its "
                              "stiffness, spring = [kx, ky, kz] in N/m",
                              i);
    for (int e = 0; e < 3; e++)
        if (k[e] == 0.0 && v[e] != 0.0)
            return settings_wrong(s, of,
                                  "number %d has a velocity along %c, where "
                                  "it cannot move without a spring",
                                  i, 'x' + e);
    if (settings_item_has(s, of, i, "density")) return 0;
    return settings_wrong(
        s, of, "number %d is on a spring and asks for its density", i);
}

/* What is fixed has no velocity; it has no spin, nor has what is on a spring.
 */
static int check_velocity(const struct settings *s, const char *of, int i)
{
    const int fixed = case_bodies_is(s, of, i, "fixed");
    double v[3], spin[3];

    settings_item_vector(s, of, i, "velocity", v);
    settings_item_vector(s, of, i, "spin", spin);
    if (fixed && vector_length(v) > 0.0)
        return settings_wrong(s, of,
                              "number %d is fixed and has a velocity; motion = "
                              "\"prescribed\" keeps it",
                              i);
    if (vector_length(spin) > 0.0 &&
        (fixed || case_bodies_is(s, of, i, "spring")))
        return settings_wrong(s, of,
                              "number %d does not turn and has a spin; motion "
                              "= \"prescribed\" keeps it",
                              i);
    return 0;
}

static int check_motions(const struct settings *s)
{
    const char *const *const lists = case_bodies_lists;
    int code = 0;

    for (int l = 0; lists[l] != NULL; l++)
        for (int i = 0; i < settings_length(s, lists[l]) && code == 0; i++) {
            code = check_spring(s, lists[l], i);
            if (code == 0) code = check_velocity(s, lists[l], i);
        }
    return code;
}

static int case_bodies_check_any_moves(const struct settings *s)
{
    const char *const *const lists = case_bodies_lists;

    for (int l = 0; lists[l] != NULL; l++)
        for (int i = 0; i < settings_length(s, lists[l]); i++)
            if (!case_bodies_is(s, lists[l], i, "fixed")) return 1;
    return 0;
}

/* Bodies among particles: a body in the way of a method that sets velocities by
 * solid fractions, a cell that a body enters, and what knows no surfaces. */
static int case_bodies_check_particles(const struct settings *s)
{
    const char *const pull = case_cohesion_of_box(s);

    if (strcmp(s->bodies.method->name, "hold") != 0)
        return settings_wrong(s, "bodies.method",
                              "among particles bodies hold the fluid by "
                              "\"hold\" only");
    if (settings_length(s, case_outlines_clumps) > 0)
        return settings_wrong(s, case_outlines_clumps,
                              "clumps do not touch particles; give the body as "
                              "a closed surface, in bodies.surfaces");
    if (s->has.exchange && case_bodies_check_any_moves(s) &&
        s->fluid.continuity != CONTINUITY_MIXTURE)
        return settings_wrong(s, "fluid.continuity",
                              "among particles a body that moves asks for "
                              "\"mixture\": where it comes, the fluid fraction "
                              "jumps");
    if (pull != NULL)
        return settings_wrong(s, "bodies",
                              "%s acts between particles and the box, not on "
                              "bodies: leave one of them out",
                              pull);
    if (s->particles.bed_file != NULL)
        return settings_wrong(s, "bodies",
                              "a bed that settles around bodies is not kept in "
                              "a file: leave particles.bed.file out");
    return 0;
}

/* A cube that is narrower than a cell may have none in it. */
static int check_filter(const struct settings *s)
{
    double h[3];

    const double width = s->bodies.filter;

    if (width == 0.0) return 0;
    case_bodies_cell_widths(s, h);
    const double widest = fmax(h[0], fmax(h[1], h[2]));
    return width >= widest
               ? 0
               : settings_wrong(s, "bodies.filter",
                                "%g m is narrower than a cell, %g m; expected "
                                "more than a body, two diameters or so",
                                width, widest);
}

int case_bodies_check(const struct settings *s)
{
    if (!s->has.bodies) return 0;
    int code = check_mesh(s);

    if (case_bodies_count(s) == 0)
        return settings_wrong(s, "bodies",
                              "there is no body; give spheres, boxes, "
                              "cylinders, clumps or surfaces");
    if (s->has.particles && code == 0) code = case_bodies_check_particles(s);
    for (int i = 0; i < settings_length(s, list) && code == 0; i++)
        code = check_sphere(s, i);
    if (code == 0) code = check_motions(s);
    if (code == 0) code = check_filter(s);
    if (code == 0) code = case_outlines_check(s);
    if (code == 0) code = case_blocks_check(s);
    return code != 0 ? code : case_bodies_check_stiffness(s);
}

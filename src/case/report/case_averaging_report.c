/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/report/case_averaging_report.h"

#include "averaging/averaging.h"
#include "averaging/averaging_method.h"
#include "averaging/kernel/weights.h"
#include "case/build.h"
#include "case/case_mesh.h"
#include "case/checks/check_line.h"
#include "mesh/mesh.h"
#include "mesh/measures.h"

#include <math.h>
#include <stdio.h>

static const double report_threshold = 10e6; /* [byte] */

/* Of the Gaussian, over the diameter: what chapter "Beds, compared with
 * measurements" found for Mueller's bed. With 4 d its bubbles are smeared;
 * below 1.5 d the fluid fraction follows single spheres. */
static const double narrow = 1.5, wide = 3.0;

/* Bandwidths in the height of a packed bed. With fewer of them the averaged
 * solids fraction at its ends is low, and so is the drag: more gas is needed to
 * fluidize the bed. */
static const double few = 6.0;

/* With weights at the centres of cells the bandwidth has to reach from one
 * large cell to the next; otherwise the small cells beside it receive its
 * share. */
static void case_averaging_print_bandwidth(const struct mesh *m, double b,
                                           double S_c, double widths)
{
    double V, least, mean;

    mesh_volumes(m, &least, &V, &mean);
    check_line("bandwidth / S_c", b / S_c, "-", "");
    if (cbrt(V) > 1.01 * S_c)
        check_line("bandwidth / width of the largest cell", b / cbrt(V), "-",
                   b < widths * cbrt(V)
                       ? "LOW: smaller cells get too large a solid fraction"
                       : "");
}

/* How wide the Gaussian is for the spheres and for a bed of them. */
static void print_smearing(const struct settings *s, double b,
                           const struct averaging_scales *k)
{
    double lo[3], size[3];
    const int is_bed = s->effects.has_gravity && k->volume > 0.0;

    if (k->d <= 0.0) return;
    check_line(
        "Gaussian's b / d", b / k->d, "-",
        is_bed && b > wide * k->d ? "WIDE: bubbles are smeared; better 2 to 3"
        : is_bed && b < narrow * k->d ? "NARROW: the fields show single spheres"
                                      : "of the largest particle");
    if (settings_mesh(s) != NULL || !is_bed) return;
    case_mesh_ends(s, lo, size);
    const double height = k->volume / (k->eps_s * size[0] * size[2]);
    check_line("height of the packed bed / b", height / b, "-",
               height < few * b
                   ? "LOW: its ends are smeared, it fluidizes too late"
                   : "at eps_s = 0.6");
}

/* One cell in the depth averages over all of it, whatever the bandwidth. */
static void print_depth(const struct mesh *m, double b)
{
    const int n = m->box.n[2];
    const double depth = m->hi[2] - m->lo[2];

    if (m->face_centre != NULL || m->box.periodic[2]) return;
    if (n > 1 || depth > 2.0 * b)
        check_line("cells over the depth", n, "-",
                   n == 1 ? "FEW: the depth is several bandwidths"
                   : n * b < 0.5 * depth
                       ? "FEW: they are wider than two bandwidths"
                       : "");
}

void case_averaging_print(const struct settings *s,
                          const struct averaging_scales *k)
{
    struct mesh *const m = case_mesh_outline(s);
    const struct averaging_options o = build_averaging_options(s);
    const double b = o.method->gaussian * o.bandwidth;
    const int steps = averaging_check(o.method, m, &o); /* of Crank-Nicolson */
    const double bytes = weights_bytes(o.method, m, k->d, &o);

    puts("Averaging");
    if (o.bandwidth > 0.0)
        case_averaging_print_bandwidth(m, o.bandwidth, k->S_c,
                                       o.method->uniform_widths);
    if (b > 0.0) {
        print_smearing(s, b, k);
        print_depth(m, b);
    }
    if (steps > 0)
        check_line("averaging.steps", steps, "-",
                   "needed: with fewer the fields undershoot");
    if (bytes > report_threshold)
        check_line("memory for the cells near each", 1e-6 * bytes, "MB",
                   "about, besides that below");
    mesh_free(m);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* coupling_options.c -- the keys of the group `exchange`, the members of struct
 * coupling_options that they fill, and the descriptors of their choices.
 * Chapter "The coupled loop". */
#include "coupling/coupling.h"

#include <stddef.h>

#define AT(member) KEY_AT(coupling_options, member)

const struct key coupling_keys[] = {
    {"exchange", KEY_GROUP, "", "", "", "forces between the phases",
     "XS11 2.6, 3.13", "fluid averaging", .mark = KEY_AFTER_BED,
     .divided = KEY_DIVIDED_ALL},
    {"exchange.drag", KEY_NAME, "", "", NULL, "drag law",
     "XS11 2.11, LS 5.25-5.27", "", AT(law), .models = drag_laws},
    {"exchange.shape", KEY_NAME, "", "", "sauter",
     "how the drag depends on the shape of grains that are no spheres", "",
     "particles.clumps", AT(shape), .models = drag_shapes},
    {"exchange.treatment", KEY_NAME, "", "", "semi-implicit",
     "treatment of the drag in the fluid's equation", "XS11 3.14", "",
     AT(treatment), .choices = coupling_treatments},
    {"exchange.slip_integration", KEY_NAME, "", "", "frozen",
     "integration of the drag on a particle over a sub-step", "XS11 3.18", "",
     AT(slip_integration), .choices = coupling_slip_integrations},
    {"exchange.substeps", KEY_INT, "-", "auto | >= 1", "auto",
     "drag updates in a fluid step, N_s", "XS11 3.18-3.20", "", AT(substeps)},
    {"exchange.model", KEY_NAME, "", "", "A",
     "A: the fluid's equation has the fluid's share of the pressure gradient; "
     "B: it has the whole gradient, and the reaction of the force on the "
     "particles",
     "XS11 2.4-2.8, SX15 2b", "", AT(form_a), .choices = coupling_forms},
    {"exchange.coupling", KEY_NAME, "", "", "two-way",
     "one-way: particles do not act on the fluid", "LS 5", "", AT(two_way),
     .choices = coupling_directions},
    KEY_END};

const struct model *const coupling_treatments[] = {
    &(const struct model){
        .name = "semi-implicit",
        .what = "the fluid velocity in the drag is that of the new time level",
        .equations = "XS11 3.13-3.15",
        .function = "transfer_drag_terms",
        .value = TREATMENT_SEMI_IMPLICIT,
    },
    &(const struct model){
        .name = "explicit",
        .what = "the drag is a constant force during the fluid's step",
        .equations = "",
        .function = "transfer_drag_terms",
        .value = TREATMENT_EXPLICIT,
    },
    NULL};

const struct model *const coupling_slip_integrations[] = {
    &(const struct model){
        .name = "frozen",
        .what = "constant drag during a sub-step, that of its start",
        .equations = "XS11 3.18",
        .function = "apply_frozen",
        .value = SLIP_INTEGRATION_FROZEN,
    },
    &(const struct model){
        .name = "exponential",
        .what = "a slip that decays exponentially during a sub-step",
        .equations = "XS11 3.16",
        .function = "rows_advance_with_drag",
        .value = SLIP_INTEGRATION_EXPONENTIAL,
    },
    NULL};

const struct model *const coupling_forms[] = {
    &(const struct model){
        .name = "A",
        .what = "the fluid's equation has its share of the pressure gradient, "
                "eps_f grad p",
        .equations = "XS11 2.8",
        .function = "pressure_gradient_before_particles",
        .value = 1,
    },
    &(const struct model){
        .name = "B",
        .what =
            "the fluid's equation has all of grad p, and the reaction of the "
            "particles' share",
        .equations = "SX15 2b",
        .function = "pressure_gradient_before_particles",
        .value = 0,
    },
    NULL};

const struct model *const coupling_directions[] = {
    &(const struct model){
        .name = "two-way",
        .what = "the momentum that particles gain is taken from the fluid",
        .equations = "LS 5",
        .function = "transfer_drag_terms",
        .value = 1,
    },
    &(const struct model){
        .name = "one-way",
        .what = "particles do not act on the fluid",
        .equations = "LS 5",
        .function = "transfer_drag_terms",
        .value = 0,
    },
    NULL};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* coupling_options.c -- what is told about the choices of coupling.h. */
#include "coupling/coupling.h"

#include <stddef.h>

const struct model coupling_semi_implicit = {
    .name = "semi-implicit",
    .what = "the fluid's own velocity is taken at the new time",
    .equations = "XS11 3.13-3.15",
    .function = "transfer_drag_terms",
    .value = TREATMENT_SEMI_IMPLICIT,
};

const struct model coupling_explicit = {
    .name = "explicit",
    .what = "the drag is a given force during the fluid's step",
    .equations = "",
    .function = "transfer_drag_terms",
    .value = TREATMENT_EXPLICIT,
};

const struct model coupling_frozen = {
    .name = "frozen",
    .what = "the drag of the sub-step's start, throughout it",
    .equations = "XS11 3.18",
    .function = "apply_frozen",
    .value = SLIP_INTEGRATION_FROZEN,
};

const struct model coupling_exponential = {
    .name = "exponential",
    .what = "the drag that relaxes as the particle gives in to it",
    .equations = "XS11 3.16",
    .function = "drag_rows_advance",
    .value = SLIP_INTEGRATION_EXPONENTIAL,
};

const struct model coupling_form_a = {
    .name = "A",
    .what = "the fluid has its share of the pressure gradient, eps_f grad p",
    .equations = "XS11 2.8",
    .function = "pressure_gradient_before_particles",
    .value = 1,
};

const struct model coupling_form_b = {
    .name = "B",
    .what = "the fluid has all of it, and what the particles feel returns",
    .equations = "SX15 2b",
    .function = "pressure_gradient_before_particles",
    .value = 0,
};

const struct model coupling_two_way = {
    .name = "two-way",
    .what = "what the particles gain the fluid loses",
    .equations = "LS 5",
    .function = "transfer_drag_terms",
    .value = 1,
};

const struct model coupling_one_way = {
    .name = "one-way",
    .what = "the fluid does not feel the particles",
    .equations = "LS 5",
    .function = "transfer_drag_terms",
    .value = 0,
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* diffusion_schemes.c -- what is told about the schemes of diffusion.c. */
#include "averaging/diffusion.h"

#include <stddef.h>

const struct key diffusion_keys[] = {
    {"averaging.scheme", KEY_NAME, "", "", "exponential",
     "time scheme of the diffusion", "SX15 5", ""},
    {"averaging.tolerance", KEY_REAL, "-", ">= 1e-15, < 1", "1e-6",
     "relative residual of the diffusion solver; with an implicit scheme about "
     "the relative error of the exchanged momentum",
     "", ""},
    {"averaging.bandwidth_variation", KEY_NAME, "", "", "uniform",
     "how the bandwidth of the diffusion varies in space", "SX15 section 2.2.3",
     ""},
    {"averaging.regions", KEY_LIST, "", "", KEY_OPTIONAL,
     "boxes with a bandwidth of their own, each { low, high, bandwidth }",
     "SX15 section 2.2.3", ""},
    {"averaging.regions.low", KEY_VECTOR, "m", "", NULL, "lowest corner", "",
     ""},
    {"averaging.regions.high", KEY_VECTOR, "m", "", NULL, "highest corner", "",
     ""},
    {"averaging.regions.bandwidth", KEY_REAL, "m", ">= 0", NULL,
     "its bandwidth; 0: what pcm gives stays", "", ""},
    KEY_END};

static const struct key steps_keys[] = {
    {"averaging.steps", KEY_INT, "-", ">= 1, <= 1000", "3",
     "steps of the diffusion in pseudo-time", "SX15 5", ""},
    KEY_END};

const struct model diffusion_exponential = {
    .name = "exponential",
    .what = "the matrix exponential; no steps",
    .equations = "",
    .function = "apply_exponential",
};

const struct model diffusion_series = {
    .name = "series",
    .what = "the same, always by its series",
    .equations = "",
    .function = "chebyshev_apply",
};

const struct model diffusion_crank_nicolson = {
    .name = "crank-nicolson",
    .what = "second order; undershoots if the steps are few",
    .equations = "SX15 5",
    .function = "theta_step",
    .keys = {steps_keys},
};

const struct model diffusion_implicit_euler = {
    .name = "implicit-euler",
    .what = "first order; never undershoots",
    .equations = "",
    .function = "theta_step",
    .keys = {steps_keys},
};

const struct model diffusion_sdirk2 = {
    .name = "sdirk2",
    .what = "second order, L-stable; undershoots little",
    .equations = "",
    .function = "sdirk2_step",
    .keys = {steps_keys},
};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* diffusion_schemes.c -- the keys and the descriptors of diffusion.c.
 * Chapter "Averaging". */
#include "averaging/diffusion.h"

#include "averaging/averaging.h"
#include "base/model.h"

#define AT(member) .at = KEY_AT(averaging_options, member)
#define REGION(member) .at = KEY_AT(averaging_region, member)

const struct key diffusion_keys[] = {
    {"averaging.scheme", KEY_NAME, "", "", "exponential",
     "time scheme of the diffusion", "SX15 5", "", AT(scheme)},
    {"averaging.tolerance", KEY_REAL, "-", ">= 1e-15, < 1", "1e-6",
     "relative residual of the diffusion solver; with an implicit scheme about "
     "the relative error of the exchanged momentum",
     "", "", AT(tolerance)},
    {"averaging.bandwidth_variation", KEY_NAME, "", "", "uniform",
     "how the bandwidth of the diffusion varies in space", "SX15 section 2.2.3",
     "", AT(vary)},
    {"averaging.regions", KEY_LIST, "", "", KEY_OPTIONAL,
     "boxes with a bandwidth of their own, each { low, high, bandwidth }",
     "SX15 section 2.2.3", "", AT(regions),
     .size = sizeof(struct averaging_region)},
    {"averaging.regions.low", KEY_VECTOR, "m", "", NULL, "lowest corner", "",
     "", REGION(low)},
    {"averaging.regions.high", KEY_VECTOR, "m", "", NULL, "highest corner", "",
     "", REGION(high)},
    {"averaging.regions.bandwidth", KEY_REAL, "m", ">= 0", NULL,
     "its bandwidth; 0: what pcm gives stays", "", "", REGION(bandwidth)},
    KEY_END};

const struct diffusion_scheme diffusion_exponential = {
    .name = "exponential",
    .what = "the matrix exponential; no steps",
    .equations = "",
    .function = "diffusion_apply_exponential",
    .directly = 1,
};

const struct diffusion_scheme diffusion_series = {
    .name = "series",
    .what = "the same, always by its series",
    .equations = "",
    .function = "chebyshev_apply",
};

const struct diffusion_scheme *const diffusion_schemes[] = {
    &diffusion_exponential,    &diffusion_series, &diffusion_crank_nicolson,
    &diffusion_implicit_euler, &diffusion_sdirk2, NULL};

MODEL_NAMED(diffusion_scheme)

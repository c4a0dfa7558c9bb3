/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/population/sizes_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/alloc.h"
#include "base/model.h"

const struct key sizes_range_keys[] = {
    {"particles.sizes.min", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "smallest diameter; needed by uniform and normal", "XS11 section 4.4", "",
     .at = KEY_AT(sizes_setup, of.min)},
    {"particles.sizes.max", KEY_REAL, "m", "> 0", KEY_OPTIONAL,
     "largest diameter; needed by uniform and normal", "XS11 section 4.4", "",
     .at = KEY_AT(sizes_setup, of.max)},
    KEY_END};

const struct key sizes_by_keys[] = {
    {"particles.sizes.by", KEY_NAME, "", "number | mass", "number",
     "whether shares are of the number or of the mass of the particles", "", "",
     .at = KEY_AT(sizes_setup, by)},
    KEY_END};

const char *sizes_wrong(const struct sizes_options *o)
{
    if (o->max > 0.0 && o->min >= o->max) return "min must be below max";
    return o->law->wrong(o);
}

struct sizes *sizes_create(const struct sizes_options *o)
{
    struct sizes *const s = alloc_zeroed(1, sizeof *s);

    s->law = o->law;
    memcpy(s->own, o->own, sizeof s->own);
    o->law->shape(s, o);
    return s;
}

void sizes_free(struct sizes *s)
{
    if (s == NULL) return;
    free(s->piece);
    free(s);
}

/* Rounding must not lead out of the cut-offs. */
double sizes_quantile(const struct sizes *s, double p)
{
    const double d = s->law->quantile(s, p);
    return d < s->min ? s->min : d > s->max ? s->max : d;
}

double sizes_moment_below(const struct sizes *s, int k, double x)
{
    return s->law->moment(s, k, x);
}

double sizes_moment(const struct sizes *s, int k)
{
    return s->law->moment(s, k, HUGE_VAL);
}

double sizes_min(const struct sizes *s)
{
    return s->min;
}

double sizes_max(const struct sizes *s)
{
    return s->max;
}

const struct sizes_law *const sizes_laws[] = {&sizes_uniform,   &sizes_normal,
                                              &sizes_lognormal, &sizes_discrete,
                                              &sizes_table,     NULL};

MODEL_NAMED(sizes_law)

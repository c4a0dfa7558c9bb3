/* SPDX-License-Identifier: GPL-3.0-or-later */
/* equations_drag.c -- every drag law by its name, for `winnow eval`. */
#include "case/report/equations.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "coupling/drag.h"

static const char prefix[] = "drag:";

/* Adds the keys that the law alone reads, without their group. */
static void add_own_inputs(const struct key *keys, char *inputs)
{
    for (const struct key *k = keys; k != NULL && k->path != NULL; k++) {
        const size_t used = strlen(inputs);
        snprintf(inputs + used, EQUATIONS_INPUT_TEXT - used, ", %s [%s]",
                 strrchr(k->path, '.') + 1, k->unit);
    }
}

int equations_drag(int i, struct equation *e)
{
    for (int k = 0; k <= i; k++)
        if (drag_laws[k] == NULL) return 0;
    const struct drag_law *const law = drag_laws[i];
    *e = (struct equation){.what = law->what,
                           .formula =
                               "F = F_d / (3 pi mu d eps_f u_r), Re = eps_f "
                               "rho_f d u_r / mu",
                           .inputs = "eps_f [-], Re [-]",
                           .out = "F",
                           .unit = "-",
                           .function = law->function};
    snprintf(e->key, sizeof e->key, "%s%s", prefix, law->name);
    add_own_inputs(law->own_keys, e->inputs);
    return 1;
}

/* The drag over Stokes' law at the superficial slip eps_f u_r, x = eps_f and
 * the Reynolds number of that slip: beta/eps_s of (9.7) over 18 mu eps_f/d^2.
 * In units of d, rho_f and mu. The numbers of the law's own keys follow. */
double equations_drag_value(const struct equation *e, const double *x)
{
    struct drag_law law = *drag_law_named(e->key + strlen(prefix));

    if (x[0] > 1.0 || x[1] < 0.0) return NAN;
    for (int k = 0; law.own_keys != NULL && law.own_keys[k].path != NULL; k++)
        law.own[k] = x[2 + k];
    return drag_resistance(&law, x[0], 1.0, 1.0, 1.0, x[1] / x[0]) /
           (18.0 * x[0]);
}

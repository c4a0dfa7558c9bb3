/* SPDX-License-Identifier: GPL-3.0-or-later */
/* In place of src/coupling/reaction.c, for tests/free.sh: a program that has no
 * reaction of the particles on the fluid, and must not ask for it. */
#include <stdlib.h>

#include "coupling/reaction.h"

int reaction_average(struct simulation *sim)
{
    (void)sim;
    abort();
}

void reaction_drag_terms(struct simulation *sim)
{
    (void)sim;
    abort();
}

void reaction_receive(struct simulation *sim)
{
    (void)sim;
    abort();
}

double reaction_share_in_advance(double C, double ratio, double eps_s)
{
    (void)C;
    (void)ratio;
    (void)eps_s;
    abort();
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 24-gaps.c -- what mesh and film do in a narrow gap, over the exact force. */
#include <stdio.h>

#include "brenner.h"
#include "narrow_gap.h"

static void row(double cells, int of_two, double shift)
{
    static const double reach[3] = {2.0, 1.0, 0.75};
    const double h = narrow_gap_h, z = cells * h,
                 exact = brenner_force(z / narrow_gap_R, of_two),
                 mesh = narrow_gap_force(z, of_two, shift * h, 0.0);

    printf("%5s %6.3f %6.2f %8.3f %8.3f ", of_two ? "two" : "wall", cells,
           shift, exact, mesh / exact);
    for (int i = 0; i < 3; i++)
        printf(" %7.3f",
               (mesh + narrow_gap_film(z, of_two, reach[i] * h)) / exact);
    printf("\n");
}

int main(void)
{
    printf("# gap    z/h  shift    exact  mesh/exact; with the film from 2, 1, "
           "0.75 cells on\n");
    for (int of_two = 0; of_two < 2; of_two++)
        for (double cells = 2.0; cells > 0.1; cells *= 0.5)
            for (int place = 0; place < 1 + of_two; place++)
                row(cells, of_two, place == 0 ? 0.0 : 0.25);
    return 0;
}

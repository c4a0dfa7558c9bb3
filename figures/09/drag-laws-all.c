/* SPDX-License-Identifier: GPL-3.0-or-later */
/* drag-laws-all.c -- the drag of all laws over that of Beetstra's, against the
 * fluid fraction, at two Reynolds numbers of the superficial slip.
 *
 * Prints the names, "tenneti_100" of Tenneti's law at Re = 100, then a row a
 * fluid fraction: its value, and for each Reynolds number each law, "?" outside
 * of the range of its data. */
#include "coupling/drag.h"

#include <stdio.h>

int main(void)
{
    static const double Re[] = {1.0, 100.0};
    const struct drag_law *const beetstra = drag_law_named("beetstra");

    printf("eps_f");
    for (int r = 0; r < 2; r++)
        for (int k = 0; drag_laws[k] != NULL; k++)
            printf(" %s_%g", drag_laws[k]->name, Re[r]);
    putchar('\n');
    for (double eps = 0.36; eps < 0.985; eps += 0.01) {
        printf("%.2f", eps);
        for (int r = 0; r < 2; r++)
            for (int k = 0; drag_laws[k] != NULL; k++) {
                const struct drag_law *const law = drag_laws[k];
                const double u = Re[r] / eps; /* d, rho_f and mu are 1 */
                const double F = drag_resistance(law, eps, 1.0, 1.0, 1.0, u);
                if (eps < law->eps_min - 1e-9 || eps > law->eps_max)
                    printf(" ?");
                else
                    printf(" %.4f", F / drag_resistance(beetstra, eps, 1.0, 1.0,
                                                        1.0, u));
            }
        putchar('\n');
    }
    return 0;
}

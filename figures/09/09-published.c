/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 09-published.c -- the drag laws beside what was measured or computed by
 * others (tests/published.h).
 *
 *   09-published sphere|bed|settling
 *
 * sphere: C_d of one sphere over the published one, by Reynolds number. bed:
 * pressure drop of a packed bed [Pa/m] at Re = 0.8, and over that of KTA's rule
 * at Re of 10, 100 and 1000. settling: the exponent of the fluid fraction, from
 * the velocity at two of them, by Reynolds number of one sphere; the first two
 * rows are the measured ones. */
#include "published.h"

#include <stdio.h>
#include <string.h>

static void sphere(void)
{
    printf("%-18s", "# C_d/published");
    for (int k = 0; k < PUBLISHED_SPHERES; k++)
        printf(" %6g", published_spheres[k].Re);
    putchar('\n');
    for (int i = 0; drag_laws[i] != NULL; i++) {
        printf("%-18s", drag_laws[i]->name);
        for (int k = 0; k < PUBLISHED_SPHERES; k++) {
            const struct published_sphere *const p = &published_spheres[k];
            printf(" %6.3f", published_sphere_cd(drag_laws[i], p->Re) / p->C_d);
        }
        putchar('\n');
    }
}

static void bed(void)
{
    for (int k = 0; k < PUBLISHED_BEDS; k++)
        printf("# %-16s %6.0f\n", published_beds[k].source,
               published_beds[k].drop);
    printf("%-18s %6s %6s %6s %6s\n", "# Re", "0.8", "10", "100", "1000");
    for (int i = 0; drag_laws[i] != NULL; i++) {
        printf("%-18s %6.0f", drag_laws[i]->name,
               published_bed_drop(drag_laws[i], 1e-3));
        for (double Re = 10.0; Re < 2000.0; Re *= 10.0) {
            const double U = Re * 1.25e-3; /* [m/s] */
            printf(" %6.3f",
                   published_bed_drop(drag_laws[i], U) / published_bed_kta(U));
        }
        putchar('\n');
    }
}

static void settling(void)
{
    static const double Re[] = {0.01, 1.0, 10.0, 100.0, 1000.0};
    static const char *const laws[] = {"syamlal-obrien", "gidaspow",
                                       "huilin-gidaspow", "di-felice",
                                       "di-felice-printed"};

    printf("%-18s     ", "# Re_t");
    for (int k = 0; k < 5; k++)
        printf(" %6g", Re[k]);
    printf("\n%-18s     ", "Richardson54");
    for (int k = 0; k < 5; k++)
        printf(" %6.2f", published_zaki(Re[k]));
    printf("\n%-18s     ", "Garside77");
    for (int k = 0; k < 5; k++)
        printf(" %6.2f", published_garside(Re[k]));
    putchar('\n');
    for (int i = 0; i < 10; i++) {
        const double eps = i % 2 ? 0.9 : 0.7;
        printf("%-18s %4.1f", laws[i / 2], eps);
        for (int k = 0; k < 5; k++)
            printf(" %6.2f",
                   published_exponent(drag_law_named(laws[i / 2]), eps, Re[k]));
        putchar('\n');
    }
}

int main(int argc, char **argv)
{
    const char *const what = argc > 1 ? argv[1] : "";

    if (strcmp(what, "sphere") == 0)
        sphere();
    else if (strcmp(what, "bed") == 0)
        bed();
    else if (strcmp(what, "settling") == 0)
        settling();
    else
        return 2;
    return 0;
}

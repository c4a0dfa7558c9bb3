/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pressure drop of a pipe of tetrahedra over the exact one, and the errors
 * and orders of the flow of (19.2) on tetrahedra.
 *
 *   sh figures/run.sh figures/19-tetrahedra.c
 */
#include <stdio.h>

#include "../tests/manufactured.h"
#include "../tests/pipe.h"

static void pipes(void)
{
    static const char *const gradients[] = {"gauss", "least-squares"};
    static const int blocks[] = {6, 8, 12};

    puts("# pipe: convection, slopes; drop on 2592, 6144 and 20736 cells");
    for (int i = 0; i < 3; i++)
        for (int g = 0; g < 2; g++) {
            const char *const scheme = i == 0   ? "linear"
                                       : i == 1 ? "second-upwind"
                                                : "van-leer";
            printf("%s %s", scheme, gradients[g]);
            for (int k = 0; k < 3; k++)
                printf(" %.3f", pipe_of_tetrahedra(blocks[k], scheme,
                                                   gradients[g], 2.0));
            putchar('\n');
            fflush(stdout);
        }
}

static struct manufactured_error made(const char *convection, int n)
{
    const struct manufactured a = {.kind = MANUFACTURED_BOX,
                                   .n = n,
                                   .shake = 0.1,
                                   .convection = convection,
                                   .time = "bdf2",
                                   .steady = 1,
                                   .dt = 0.32 / n,
                                   .end = 0.64};

    return manufactured_run(&a);
}

int main(void)
{
    static const char *const schemes[] = {"linear", "second-upwind",
                                          "van-leer"};

    pipes();
    puts("# made: convection, cells; error of u, order, of p, order");
    for (int i = 0; i < 3; i++) {
        struct manufactured_error last = {0};
        for (int n = 4; n <= 16; n *= 2) {
            const struct manufactured_error e = made(schemes[i], n);
            printf("%s %d %.2e %.2f %.2e %.2f\n", schemes[i], 6 * n * n * n,
                   e.u, n > 4 ? log2(last.u / e.u) : 0.0, e.p,
                   n > 4 ? log2(last.p / e.p) : 0.0);
            fflush(stdout);
            last = e;
        }
    }
    return 0;
}

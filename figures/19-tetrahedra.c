/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pressure drop of a pipe of tetrahedra over the exact one; or the errors
 * and orders of the flow of (19.3) on tetrahedra, up to 6 MOST^3 of them, as it
 * is or with the fluid at rest.
 *
 *   sh figures/run.sh figures/19-tetrahedra.c -- pipe SLOPES|made SCHEME
 * MOST|rest
 */
#include <stdio.h>

#include "../tests/manufactured.h"
#include "../tests/pipe.h"

static void pipe(const char *slopes, const char *scheme)
{
    static const int blocks[] = {6, 8, 12};

    printf("%s", scheme);
    for (int k = 0; k < 3; k++) {
        printf(" %.3f", pipe_of_tetrahedra(blocks[k], scheme, slopes, 0.6));
        fflush(stdout);
    }
    putchar('\n');
}

static void made(const char *scheme, int most, double shake, double K,
                 int still)
{
    struct manufactured_error last = {0};

    for (int n = 4; n <= most; n *= 2) {
        const struct manufactured a = {.kind = MANUFACTURED_BOX,
                                       .n = n,
                                       .shake = shake,
                                       .convection = scheme,
                                       .time = "bdf2",
                                       .steady = 1,
                                       .still = still,
                                       .K = K,
                                       .dt = 0.32 / n,
                                       .end = 0.32};
        const struct manufactured_error e = manufactured_run(&a);
        printf("%s %d  %.2e", still ? "rest" : scheme, 6 * n * n * n, e.u);
        if (n > 4) printf(" %.2f", log2(last.u / e.u));
        printf("  %.2e", e.p);
        if (n > 4) printf(" %.2f", log2(last.p / e.p));
        putchar('\n');
        fflush(stdout);
        last = e;
    }
}

int main(int argc, char **argv)
{
    if (argc < 2) return 2;
    if (strcmp(argv[1], "rest") == 0) {
        puts("# cells; error of u, order; of p, order");
        made("linear", 8, 0.1, 0.0, 1);
        return 0;
    }
    if (argc < 3) return 2;
    if (strcmp(argv[1], "pipe") == 0) {
        puts("# convection; drop on 2592, 6144 and 20736 cells");
        pipe(argv[2], "linear");
        pipe(argv[2], "second-upwind");
        pipe(argv[2], "van-leer");
        return 0;
    }
    puts("# convection, cells; error of u, order; of p, order");
    made(argv[2], argc > 3 ? atoi(argv[3]) : 16, argc > 4 ? atof(argv[4]) : 0.1,
         argc > 5 ? atof(argv[5]) : 0.0, 0);
    return 0;
}

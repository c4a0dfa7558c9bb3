/* SPDX-License-Identifier: GPL-3.0-or-later */
/* 22-orders.c -- the error of each force of the fluid in three steps, each a
 * quarter of the one before, and the order between the last two
 * (tests/orders.h). Its scenes are those of a test, so it runs as one. */
#include "facts.h"
#include "orders.h"

#include <stdio.h>

FACT(print_orders)
{
    printf("%-24s %6s %9s %9s %9s  order\n", "# effect", "steps", "error", "/4",
           "/16");
    for (int i = 0; i < ORDERS; i++) {
        double e[3];
        for (int k = 0; k < 3; k++)
            e[k] = orders_all[i].miss(orders_all[i].steps << (2 * k));
        printf("%-24s %6d %9.2e %9.2e %9.2e  %5.2f\n", orders_all[i].what,
               orders_all[i].steps, e[0], e[1], e[2], log2(e[1] / e[2]) / 2.0);
    }
    fflush(stdout);
}

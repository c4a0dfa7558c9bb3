/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/checks/check_line.h"

#include <stdio.h>

void check_line(const char *name, double value, const char *unit,
                const char *remark)
{
    printf("  %-38s %10.4g %-4s %s\n", name, value, unit, remark);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_part.h"

#include <limits.h>

#include "base/number.h"

int case_part_count_later(const struct settings *s)
{
    double sum = 0.0;

    for (int i = 0; case_parts[i] != NULL; i++)
        if (case_parts[i]->count_later != NULL)
            sum += case_parts[i]->count_later(s);
    return number_clamped(sum, 0, INT_MAX);
}

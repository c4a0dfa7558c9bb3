/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Whatever is no part of a number in C stands for its decimal point; a point
 * of several bytes becomes one. */
static void use_decimal_point(char *text)
{
    char *out = text;
    int seen = 0;

    for (const char *in = text; *in; in++) {
        if (strchr("+-0123456789e", *in))
            *out++ = *in;
        else if (!seen++)
            *out++ = '.';
    }
    *out = '\0';
}

const char *number_text(double x, char text[NUMBER_LENGTH])
{
    if (isnan(x)) return strcpy(text, "nan");
    if (isinf(x)) return strcpy(text, x > 0.0 ? "inf" : "-inf");
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, NUMBER_LENGTH, "%.*g", digits, x);
        if (strtod(text, NULL) == x) /* both in the same language */
            break;
    }
    use_decimal_point(text);
    return text;
}

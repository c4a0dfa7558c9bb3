/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Every character that is no part of a number in C is the decimal sign of the
 * locale; one of several bytes becomes one point. */
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

/* nan and inf are written without a sign, which would depend on how they were
 * computed. */
static const char *word_for(double x)
{
    if (isnan(x)) return "nan";
    return x > 0.0 ? "inf" : "-inf";
}

const char *number_text(double x, char text[NUMBER_LENGTH])
{
    if (!isfinite(x)) return strcpy(text, word_for(x));
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, NUMBER_LENGTH, "%.*g", digits, x);
        if (strtod(text, NULL) == x) break; /* both in the same locale */
    }
    use_decimal_point(text);
    return text;
}

const char *number_rounded(double x, int digits, char text[NUMBER_LENGTH])
{
    if (!isfinite(x)) return strcpy(text, word_for(x));
    snprintf(text, NUMBER_LENGTH, "%.*g", digits, x);
    use_decimal_point(text);
    return text;
}

int number_int(double x, int *n)
{
    if (!(x >= INT_MIN && x <= INT_MAX)) return 1;
    *n = (int)x;
    return 0;
}

int number_long(double x, long *n)
{
    const double max = 9007199254740992.0; /* 2^53 */

    if (!(x >= -max && x <= max)) return 1;
    *n = (long)x;
    return 0;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"
#include "facts.h"
#include "scratch.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <stdint.h>

FACT(numbers_are_as_short_as_they_can_be)
{
    const struct {
        double x;
        const char *text;
    } pair[] = {{0.1, "0.1"},      {1.0, "1"},
                {-0.0, "-0"},      {1e-300, "1e-300"},
                {0.5, "0.5"},      {1.0 / 3.0, "0.3333333333333333"},
                {NAN, "nan"},      {-NAN, "nan"},
                {INFINITY, "inf"}, {-INFINITY, "-inf"}};
    char text[NUMBER_LENGTH];

    for (size_t i = 0; i < sizeof pair / sizeof pair[0]; i++)
        ck_assert_str_eq(number_text(pair[i].x, text), pair[i].text);
}

/* Every tolerance is 0: 16 digits alone fail for about half of these. */
FACT(numbers_read_back_to_the_same_bits)
{
    const double edges[] = {DBL_MIN, DBL_MAX, -DBL_MAX, 4.9e-324, 0.1 + 0.2};
    char text[NUMBER_LENGTH];
    uint64_t bits = 88172645463325252u;

    for (int i = 0; i < 5; i++)
        ck_assert(strtod(number_text(edges[i], text), NULL) == edges[i]);
    for (int i = 0; i < 20000; i++) {
        double x;

        bits ^= bits << 13, bits ^= bits >> 7, bits ^= bits << 17;
        memcpy(&x, &bits, sizeof x);
        ck_assert_uint_lt(strlen(number_text(x, text)), NUMBER_LENGTH);
        ck_assert(isnan(x) || strtod(text, NULL) == x);
    }
}

FACT(rounded_numbers_keep_so_many_digits)
{
    char text[NUMBER_LENGTH];

    ck_assert_str_eq(number_rounded(0.78539816339, 3, text), "0.785");
    ck_assert_str_eq(number_rounded(-1.0, 6, text), "-1");
    ck_assert_str_eq(number_rounded(NAN, 6, text), "nan");
}

FACT(a_whole_number_out_of_range_is_refused_not_wrapped)
{
    const double beyond[] = {2147483648.0, -2147483649.0, 1e300,
                             INFINITY,     -INFINITY,     NAN};
    int n = 7;
    long many = 7;

    for (int i = 0; i < 6; i++)
        ck_assert(number_int(beyond[i], &n) != 0 && n == 7);
    ck_assert(number_int(2147483647.0, &n) == 0 && n == 2147483647);
    ck_assert(number_int(-2147483648.0, &n) == 0 && n == -2147483647 - 1);
    for (int i = 2; i < 6; i++)
        ck_assert(number_long(beyond[i], &many) != 0 && many == 7);
    ck_assert(number_long(1e11, &many) == 0 && many == 100000000000);
    ck_assert(number_long(9.1e15, &many) != 0);
}

FACT(a_clamped_number_stays_in_its_range_whatever_comes)
{
    ck_assert_int_eq(number_clamped(2.9, 0, 5), 2);
    ck_assert_int_eq(number_clamped(-0.5, 0, 5), 0);
    ck_assert_int_eq(number_clamped(5.0, 0, 5), 5);
    ck_assert_int_eq(number_clamped(1e300, 0, 5), 5);
    ck_assert_int_eq(number_clamped(-1e300, 0, 5), 0);
    ck_assert_int_eq(number_clamped(NAN, 0, 5), 0);
}

/* A locale that writes 0,5, made by localedef, which warns of all that this
 * locale lacks. Where localedef cannot make it, the test is void. */
FACT(the_decimal_point_is_a_point_in_every_language)
{
    char dir[64], command[256], text[NUMBER_LENGTH];

    scratch_make(dir);
    scratch_write(scratch_path(dir, "source"),
                  "LC_NUMERIC\ndecimal_point \",\"\nthousands_sep \"\"\n"
                  "grouping -1\nEND LC_NUMERIC\n"
                  "LC_CTYPE\ncopy \"POSIX\"\nEND LC_CTYPE\n");
    snprintf(command, sizeof command,
             "localedef -c -i %s/source -f UTF-8 %s/comma.utf8 >/dev/null 2>&1",
             dir, dir);
    ck_assert_int_ne(system(command), -1);
    setenv("LOCPATH", dir, 1);
    if (setlocale(LC_NUMERIC, "comma.utf8") != NULL) {
        snprintf(text, sizeof text, "%g", 0.5);
        ck_assert_str_eq(text, "0,5");
    }
    ck_assert_str_eq(number_text(-0.5e-10, text), "-5e-11");
    ck_assert_str_eq(number_text(1234567.25, text), "1234567.25");
    ck_assert_str_eq(number_rounded(1234.5678, 6, text), "1234.57");
    scratch_clear(dir);
}

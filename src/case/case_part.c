/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_part.h"

#include <limits.h>

#include "base/number.h"

/* Calls one function of all parts that have it, up to the first that returns
 * another code than 0. */
#define EACH_PART(function, ...)                                               \
    int code = 0;                                                              \
    for (int i = 0; case_parts[i] != NULL && code == 0; i++)                   \
        if (case_parts[i]->function != NULL)                                   \
            code = case_parts[i]->function(__VA_ARGS__);                       \
    return code

int case_part_check(const struct settings *s)
{
    EACH_PART(check, s);
}

int case_part_check_any(const struct settings *s)
{
    EACH_PART(check_any, s);
}

int case_part_complete(const struct settings *s, struct simulation *sim,
                       struct dem_options *o)
{
    int code = 0;

    for (int i = 0; case_parts[i] != NULL && code == 0; i++)
        if (case_parts[i]->complete != NULL)
            code = case_parts[i]->complete(s, sim, o);
    for (int i = 0; case_parts[i] != NULL && code == 0; i++)
        if (case_parts[i]->complete_last != NULL)
            code = case_parts[i]->complete_last(s, sim, o);
    return code;
}

int case_part_place(const struct settings *s, struct particles *ps,
                    const struct dem_options *o)
{
    EACH_PART(place, s, ps, o);
}

int case_part_add(const struct settings *s, struct simulation *sim)
{
    EACH_PART(add, s, sim);
}

int case_part_add_last(const struct settings *s, struct simulation *sim)
{
    EACH_PART(add_last, s, sim);
}

int case_part_bed_file(const struct settings *s, char *path, size_t room)
{
    for (int i = 0; case_parts[i] != NULL; i++)
        if (case_parts[i]->bed_file != NULL &&
            case_parts[i]->bed_file(s, path, room))
            return 1;
    return 0;
}

int case_part_count_later(const struct settings *s)
{
    double sum = 0.0;

    for (int i = 0; case_parts[i] != NULL; i++)
        if (case_parts[i]->count_later != NULL)
            sum += case_parts[i]->count_later(s);
    return number_clamped(sum, 0, INT_MAX);
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/case_check.h"

/* Calls one function of all that have it, up to the first that returns another
 * code than 0. */
#define EACH_CHECK(function, ...)                                              \
    int code = 0;                                                              \
    for (int i = 0; case_checks[i] != NULL && code == 0; i++)                  \
        if (case_checks[i]->function != NULL)                                  \
            code = case_checks[i]->function(__VA_ARGS__);                      \
    return code

int case_check_file(const char *file, const char *folder)
{
    EACH_CHECK(file, file, folder);
}

const char *case_check_text(const char *value)
{
    const char *why = NULL;

    for (int i = 0; case_checks[i] != NULL && why == NULL; i++)
        if (case_checks[i]->text != NULL) why = case_checks[i]->text(value);
    return why;
}

int case_check_value(const struct key *key, const char *path,
                     const struct config_setting_t *value)
{
    EACH_CHECK(value, key, path, value);
}

int case_check_mesh(const struct settings *s)
{
    EACH_CHECK(mesh, s);
}

int case_check_whole(const struct settings *s)
{
    EACH_CHECK(whole, s);
}

int case_check_run(const struct settings *s)
{
    EACH_CHECK(run, s);
}

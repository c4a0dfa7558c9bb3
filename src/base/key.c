/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/key.h"

#include <string.h>

int key_matches(const char *row, const char *path)
{
    const char *const at = strstr(row, KEY_ANY_PATCH);
    const size_t before = at != NULL ? (size_t)(at - row) : 0;

    if (at == NULL) return strcmp(row, path) == 0;
    return strncmp(row, path, before) == 0 &&
           strcmp(at + strlen(KEY_ANY_PATCH),
                  path + before + strcspn(path + before, ".")) == 0;
}

/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/left_out.h"

#include <stddef.h>
#include <string.h>

const char *left_out_folder(const char *word)
{
    for (const struct left_out *l = left_out_words; l->word != NULL; l++)
        if (strcmp(l->word, word) == 0) return l->folder;
    return NULL;
}

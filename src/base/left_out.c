/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/left_out.h"

#include <stddef.h>

#include "base/key.h"

const char *left_out_folder(const char *word)
{
    for (const struct left_out *l = left_out_words; l->word != NULL; l++)
        if (key_matches(l->word, word)) return l->folder;
    return NULL;
}

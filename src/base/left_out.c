/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/left_out.h"

#include <stddef.h>
#include <string.h>

/* 1 if the words are the same; <patch> in the listed one stands for any name.
 */
static int is_same(const char *listed, const char *word)
{
    static const char placeholder[] = "<patch>";
    const char *const at = strstr(listed, placeholder);
    const size_t before = at != NULL ? (size_t)(at - listed) : 0;

    if (at == NULL) return strcmp(listed, word) == 0;
    if (strncmp(listed, word, before) != 0) return 0;
    return strcmp(at + strlen(placeholder),
                  word + before + strcspn(word + before, ".")) == 0;
}

const char *left_out_folder(const char *word)
{
    for (const struct left_out *l = left_out_words; l->word != NULL; l++)
        if (is_same(l->word, word)) return l->folder;
    return NULL;
}

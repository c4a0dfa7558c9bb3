/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/keys.h"

#include "case/settings.h"

/* A row: path, type, unit, allowed, default, meaning, source, needs. NULL as
 * the default means that the key must be given. */
const struct key keys_case[] = {
    {"title", KEY_TEXT, "", "", "", "what the case shows, in one line", "", "",
     .at = KEY_AT(settings, title), .mark = KEY_MAY_CHANGE | KEY_AFTER_BED},
    {"cites", KEY_TEXT, "", "", "", "the paper, table or figure it follows", "",
     "", .at = KEY_AT(settings, cites), .mark = KEY_MAY_CHANGE | KEY_AFTER_BED},
    KEY_END};

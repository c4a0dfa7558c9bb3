/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "case/command.h"

#include "case/case_file.h"

struct settings *command_settings(const struct command_line *l, int *code)
{
    return case_file_read(l->words[0], l->n_overrides, l->overrides, code);
}

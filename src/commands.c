/* SPDX-License-Identifier: GPL-3.0-or-later */
/* commands.c -- what the program can do. */
#include "case/command.h"

#include <stdlib.h>
#include <string.h>

const struct command *const commands[] = {&run_command,
                                          &study_command,
                                          &export_command,
                                          &check_command,
                                          &explain_command,
                                          &list_command,
                                          &list_new_command,
                                          &eval_command,
                                          &command_status,
                                          &report_command,
                                          NULL};

const struct command *command_named(const char *name)
{
    const struct command *const *c = commands;

    while (*c != NULL && strcmp((*c)->name, name) != 0)
        c++;
    return *c;
}

int command_count(const char *text)
{
    char *end;
    const long n = strtol(text, &end, 10);

    return end != text && *end == '\0' && n >= 1 && n <= 1024 ? (int)n : 0;
}

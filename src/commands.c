/* SPDX-License-Identifier: GPL-3.0-or-later */
/* commands.c -- what the program can do. */
#include "case/command.h"

#include <stddef.h>

const struct command *const commands[] = {&command_run,     &study_command,
                                          &export_command,  &command_check,
                                          &command_explain, &command_list,
                                          &command_new,     &command_eval,
                                          &command_status,  NULL};

/* SPDX-License-Identifier: GPL-3.0-or-later */
/* commands.c -- what the program can do. */
#include "case/command.h"

#include <stddef.h>

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

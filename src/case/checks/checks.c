/* SPDX-License-Identifier: GPL-3.0-or-later */
/* checks.c -- what the room and run.c ask for (case_check.h). */
#include "case/case_check.h"

#include "case/checks/case_memory.h"
#include "case/checks/case_scales.h"
#include "case/checks/mesh_check.h"
#include "case/checks/unit_range.h"
#include "case/checks/validate.h"

static int check_mesh(const struct settings *s)
{
    const int code = mesh_check_keys(s);
    return code != 0 ? code : case_memory_check(s, 0.0);
}

static int check_whole(const struct settings *s)
{
    const int code = mesh_check_cells(s);
    return code != 0 ? code : validate_case(s);
}

const struct case_check checks_of_case = {.value = unit_range_check,
                                          .mesh = check_mesh,
                                          .whole = check_whole,
                                          .run = case_scales_check};

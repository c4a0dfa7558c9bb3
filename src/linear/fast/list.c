/* SPDX-License-Identifier: GPL-3.0-or-later */
/* list.c -- what this folder adds to the solvers of the room. */
#include "linear/fast/contiguous_faces.h"

#include <stddef.h>

const struct face_order *const face_orders[] = {&contiguous_faces_order, NULL};

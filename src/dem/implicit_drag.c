/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/implicit_drag.h"

#include <math.h>

double implicit_drag_gain(double x)
{
    return x > 0.0 ? -expm1(-x) / x : 1.0;
}

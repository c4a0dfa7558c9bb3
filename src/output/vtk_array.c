/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output/vtk_array.h"

#include <assert.h>
#include <string.h>

static int vtk_array_is_real(const struct vtk_array *a)
{
    return a->values != NULL || a->split[0] != NULL;
}

const char *vtk_array_type(const struct vtk_array *a)
{
    if (a->bytes != NULL) return "UInt8";
    if (!vtk_array_is_real(a)) return "Int32";
    return a->single ? "Float32" : "Float64";
}

size_t vtk_array_width(const struct vtk_array *a)
{
    if (a->bytes != NULL) return 1;
    return vtk_array_is_real(a) && !a->single ? 8 : 4;
}

/* Number v of the array: component v % components of point v / components. */
static double real_at(const struct vtk_array *a, size_t v)
{
    const size_t components = (size_t)a->components;

    return a->values ? a->values[v] : a->split[v % components][v / components];
}

static void copy_whole(const struct vtk_array *a, size_t first, size_t n,
                       int *out)
{
    for (size_t v = 0; v < n; v++)
        out[v] = a->ints ? a->ints[first + v] : a->from + (int)(first + v);
}

void vtk_array_copy(const struct vtk_array *a, size_t first, size_t n,
                    void *bytes)
{
    double *const wide = bytes;
    float *const narrow = bytes;

    assert(a->values != NULL || a->split[0] == NULL || a->components <= 3);
    if (a->bytes != NULL)
        memcpy(bytes, a->bytes + first, n);
    else if (!vtk_array_is_real(a))
        copy_whole(a, first, n, bytes);
    else if (a->single)
        for (size_t v = 0; v < n; v++)
            narrow[v] = (float)real_at(a, first + v);
    else
        for (size_t v = 0; v < n; v++)
            wide[v] = real_at(a, first + v);
}

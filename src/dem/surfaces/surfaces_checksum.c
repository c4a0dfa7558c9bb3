/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/surfaces/surfaces_checksum.h"

#include <zlib.h>

#include "dem/surfaces/surface.h"

static unsigned long surfaces_checksum_add(unsigned long sum, const void *bytes,
                                           size_t n)
{
    return crc32_z(sum, bytes, n);
}

/* Its place among the shapes. */
static int surfaces_checksum_number_of(const struct surface_shape *shape)
{
    int i = 0;

    while (surface_shapes[i] != NULL && surface_shapes[i] != shape)
        i++;
    return i;
}

static unsigned long surfaces_checksum_add_shape(unsigned long sum,
                                                 const struct surface *s)
{
    const int whole[] = {surfaces_checksum_number_of(s->shape), s->inside,
                         s->material};

    sum = surfaces_checksum_add(sum, whole, sizeof whole);
    if (s->shape->own_keys != NULL)
        sum = surfaces_checksum_add(sum, s->own, sizeof s->own);
    sum = surfaces_checksum_add(sum, s->point, sizeof s->point);
    sum = surfaces_checksum_add(sum, s->normal, sizeof s->normal);
    sum = surfaces_checksum_add(sum, &s->radius, sizeof s->radius);
    if (s->triangles == NULL) return sum;
    const size_t n = (size_t)s->triangles->n;
    return surfaces_checksum_add(sum, s->triangles->corner,
                                 n * sizeof *s->triangles->corner);
}

static unsigned long surfaces_checksum_add_pair(unsigned long sum,
                                                const struct dem_options *o,
                                                int material)
{
    const struct material_pair p =
        materials_pair(&o->material, o->materials, 0, material);
    const double known[] = {p.of[1]->young, p.of[1]->poisson, p.stiffness,
                            p.tangential,   p.restitution,    p.friction,
                            p.rolling};

    sum = surfaces_checksum_add(sum, known, sizeof known);
    return o->law->own_keys != NULL
               ? surfaces_checksum_add(sum, p.of[1]->own, sizeof p.of[1]->own)
               : sum;
}

unsigned long surfaces_checksum(const struct dem_options *o)
{
    unsigned long sum = 0;

    for (int k = 0; k < o->n_surfaces; k++) {
        sum = surfaces_checksum_add_shape(sum, &o->surfaces[k]);
        if (o->materials != NULL)
            sum = surfaces_checksum_add_pair(sum, o, o->surfaces[k].material);
    }
    return sum;
}

/* dem_options.h -- options of the motion of the particles.
 * Chapter "Particles and contact".
 *
 * An option that a case does not set is 0 here and has no effect.
 */
#ifndef DEM_DEM_OPTIONS_H
#define DEM_DEM_OPTIONS_H

#include "dem/attraction.h"
#include "dem/integrator.h"
#include "dem/materials.h"

struct dem_method;
struct surface;
struct prescribed_particle;

struct dem_options {
    char where[256]; /* in the case, before messages; or empty */
    const struct contact_law *law;
    struct material material;          /* number 0 */
    const struct materials *materials; /* with others; NULL: there is no other.
                                          Borrowed for as long as the dem is */
    const struct integrator *integrator; /* NULL: velocity Verlet */
    const struct dem_method *method;     /* NULL: the first of dem_methods */
    double step;                         /* [s] */
    double skin;                         /* [m] of the neighbour list; 0: d/3 */
    double lo[3], hi[3];                 /* [m] walls of the box */
    int periodic[3]; /* [-] 1: no walls, hi and lo coincide; the box must be at
                        least 2 (d + skin + range) long there */
    const struct surface *surfaces; /* walls besides the box; borrowed */
    int n_surfaces;
    unsigned long surfaces_checksum; /* [-] of their shapes and materials: a
                                        settled bed in a file is for these */
    const struct attraction *attractions; /* borrowed likewise */
    int n_attractions; /* [-] 0: forces act at contact only */
    const struct prescribed_particle
        *prescribed; /* particles that move as prescribed; borrowed */
    int n_prescribed;
};

#endif

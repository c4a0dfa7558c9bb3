/* dem_surface.h -- what the particles do to a surface. Chapter "Walls". */
#ifndef DEM_SURFACES_DEM_SURFACE_H
#define DEM_SURFACES_DEM_SURFACE_H

#include "dem/dem.h"
#include "dem/surfaces/motion.h"

/* Impulse and work of the particles on surface k since the run began. */
struct dem_surface {
    double impulse[3]; /* [N s] force over time */
    double angular[3]; /* [N m s] torque about the centre of its motion */
    double work;       /* [J] that it did on the particles */
    double force[3];   /* [N] at the end of the last run */
    double t;          /* [s] the time of the motions */
    struct pose pose;  /* where it is */
};
struct dem_surface dem_surface(const struct dem *dem, int k);

#endif

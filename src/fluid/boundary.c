/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/boundary.h"

#include <stdlib.h>

double boundary_inlet_velocity(const struct boundary *b, double t)
{
    const double *const x = b->time, *const U = b->velocity;
    int i = 0;

    if (t <= x[0]) return U[0];
    while (i < b->n_points - 1 && t > x[i + 1])
        i++;
    if (i == b->n_points - 1) return U[i];
    return U[i] + (U[i + 1] - U[i]) * (t - x[i]) / (x[i + 1] - x[i]);
}

double boundary_inlet_profile(const struct boundary *b, int j, double t)
{
    if (b->varying != NULL) return b->varying(b, j, t);
    return b->profile != NULL ? b->profile[j] : 1.0;
}

const double *boundary_wall_velocity(const struct boundary *b, int j)
{
    return b->walls != NULL ? &b->walls[3 * j] : b->wall;
}

void boundary_release(struct boundary *b)
{
    free(b->series);
    if (b->release != NULL)
        b->release(b);
    else
        free(b->memory);
}

static const struct key inlet_keys[] = {
    {"fluid.<patch>.inlet", KEY_SERIES, "m/s", ">= 0", KEY_OPTIONAL,
     "superficial velocity into the box, constant or ((time, velocity), ...)",
     "SX15 Table 1", ""},
    {"fluid.<patch>.profile", KEY_NAME, "", "", "uniform",
     "how the velocity varies over an inlet", "", ""},
    KEY_END};

static const struct key wall_keys[] = {
    {"fluid.<patch>.wall", KEY_VECTOR, "m/s", "", KEY_OPTIONAL,
     "velocity of a no-slip wall that moves along itself", "", ""},
    KEY_END};

static const struct key pressure_keys[] = {
    {"fluid.<patch>.pressure", KEY_REAL, "Pa", "", KEY_OPTIONAL,
     "pressure of an inlet, without the weight of the fluid: what enters has "
     "the velocity of its flux",
     "", ""},
    KEY_END};

static const struct key outlet_keys[] = {
    {"fluid.<patch>.outlet", KEY_REAL, "Pa", "", KEY_OPTIONAL,
     "pressure outside, without the weight of the fluid", "", ""},
    KEY_END};

const struct model boundary_no_slip = {
    .name = "no-slip",
    .what = "the fluid stands still at the wall",
    .equations = "",
    .function = "add_wall_face",
    .value = BOUNDARY_NO_SLIP,
};

const struct model boundary_slip = {
    .name = "slip",
    .what = "no flow through, no friction along",
    .equations = "",
    .function = "add_slip_face",
    .value = BOUNDARY_SLIP,
};

const struct model boundary_inlet = {
    .name = "inlet",
    .what = "a superficial velocity, constant or varying in time",
    .equations = "",
    .function = "boundary_inlet_velocity",
    .keys = {inlet_keys},
    .value = BOUNDARY_INLET,
};

const struct model boundary_wall = {
    .name = "wall",
    .what = "a wall that moves along itself and takes the fluid with it",
    .equations = "",
    .function = "add_wall_face",
    .keys = {wall_keys},
    .value = BOUNDARY_NO_SLIP,
};

const struct model boundary_outlet = {
    .name = "outlet",
    .what = "a pressure outside",
    .equations = "",
    .function = "pressure_correct",
    .keys = {outlet_keys},
    .value = BOUNDARY_OUTLET,
};

const struct model boundary_pressure = {
    .name = "pressure",
    .what = "a pressure that the fluid enters with, or leaves against",
    .equations = "",
    .function = "boundary_face_velocity",
    .keys = {pressure_keys},
    .value = BOUNDARY_OUTLET,
};

const struct model *const boundary_kinds[] = {
    &boundary_no_slip, &boundary_slip,      &boundary_inlet,    &boundary_wall,
    &boundary_outlet,  &rotating_wall_kind, &boundary_pressure, NULL};

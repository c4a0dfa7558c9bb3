/* integrator.h -- time integrators of the particles.
 * Chapter "Insertion, removal and energy".
 *
 * With a(x, v) the acceleration by all forces:
 *
 *   velocity Verlet   v += a dt/2,  x += v dt,  v += a dt/2
 *   symplectic Euler  v += a dt,    x += v dt
 *   Heun              x*, v* = x + v dt, v + a dt
 *                     x += (v + v*) dt/2,  v += (a + a*) dt/2
 *
 * Symplectic Euler differs from velocity Verlet by its first and its last kick
 * only: in between both are kick, drift, kick, drift. Heun (LS section 4.2:
 * HADES) needs the forces twice, and a third time for the rates of tangential
 * springs.
 */
#ifndef DEM_INTEGRATOR_H
#define DEM_INTEGRATOR_H

#include "base/model.h"

struct integrator {
    MODEL_MEMBERS;      /* base/model.h */
    double first, last; /* [-] of a step that the first and last kick take */
    int predicts;       /* [-] 1: Heun */
    int adapts;         /* [-] 1: and splits the steps (fast/heun.c) */
};

/* By how much of a step the velocity lags behind the positions between runs
 * [-]. */
static inline double integrator_lag(const struct integrator *by)
{
    return by->predicts ? 0.0 : 0.5 - by->last;
}

/* All of them, ended by NULL, the default first; integrator_named: NULL for an
 * unknown name. */
extern const struct integrator integrators_velocity_verlet,
    integrators_symplectic_euler, integrators_heun, integrators_adaptive_heun;
extern const struct integrator *const integrators[];
const struct integrator *integrator_named(const char *name);

/* --- implicit drag: implicit drag and added mass of particles.
 *
 * In addition to contact forces and the external force F a particle may have a
 * drag -k v and an added mass m_a of fluid:
 *
 *   (m + m_a) dv/dt = sum F_c + F - k v                      [XS11 2.1]
 *
 * Over one step, in which the forces are constant, this is solved exactly:
 *
 *   v += g ((F_c + F)/(m + m_a) - r v) dt,   r = k/(m + m_a)
 *   g  = (1 - exp(-r dt))/(r dt)
 *
 * Thus v approaches its final value and never overshoots, however large r dt
 * is.
 */

/* The factor g [-] by which the drag reduces the effect of a force in a step; x
 * = r dt >= 0. */
double implicit_drag_gain(double x);

#endif

/* implicit_drag.h -- implicit drag and added mass of particles.
 * Chapter "Which treatment is stable".
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
#ifndef DEM_IMPLICIT_DRAG_H
#define DEM_IMPLICIT_DRAG_H

/* The factor g [-] by which the drag reduces the effect of a force in a step; x
 * = r dt >= 0. */
double implicit_drag_gain(double x);

#endif

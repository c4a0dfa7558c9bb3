/* response.h -- particles that a fluid holds back.  Chapter 20.
 *
 * Beside its contacts and its outside force F a particle may have a drag -k v
 * on its own velocity and an added mass m_a of fluid that it takes along:
 *
 *   (m + m_a) dv/dt = sum F_c + F - k v                      [XS11 2.1]
 *
 * Over one step, in which the forces stand still, this is solved exactly:
 *
 *   v += g ((F_c + F)/(m + m_a) - r v) dt,   r = k/(m + m_a)
 *   g  = (1 - exp(-r dt))/(r dt)
 *
 * So v goes to its end value and never past it, however large r dt is. Only a
 * scene that asks for it has rows of this kind; bodies_advance knows nothing
 * of them.
 */
#ifndef RESPONSE_H
#define RESPONSE_H

#include "particles/bodies.h"

/* The share g of what a force would do in a step if nothing held back [-];
 * x = r dt >= 0. */
double response_gain(double x);

/* The rows of the particles begin .. end - 1, for steps of b->step. */
void response_fetch(struct bodies *b, const struct particles *ps, int begin,
                    int end);

/* bodies_advance for particles that are held back; the impulse of -k v goes
 * to b->resisted. */
void response_advance(struct bodies *b, int begin, int end, double (*load)[8],
                      double kick, double drift, double fastest[4]);

#endif

/* rotation.h -- how a rigid body turns that no torque acts on.
 *
 * The unit quaternion q = (s, v) maps the frame of the body to that of the
 * box. The axes of the body are its principal ones, with the moments of
 * inertia I. L is the angular momentum, seen in the box: without a torque it
 * is constant. P = Q^T L is the same, seen in the body.
 *
 * The energy is a sum of three, P_k^2/(2 I_k). Each alone turns the body about
 * its axis k at P_k/I_k, which is constant. A step takes them one after the
 * other: 1, 2, 3, 2, 1, all but the middle one for half of it [Dullweber97].
 * So the energy has an error, of second order, that does not grow; and steps
 * can be taken back. In place of an angle a stands 2 atan(a/2): still a
 * function of P_k, so all this holds, and it takes no sine, whose last bit
 * another library may round otherwise.
 *
 * A plain loop over bodies with numbers in columns becomes one of vectors, 9 ns
 * a body in place of 30; not if it is marked `omp simd`.
 */
#ifndef BASE_ROTATION_H
#define BASE_ROTATION_H

#include "base/vector.h"

/* The product a b of two quaternions: first b, then a. */
static inline void rotation_product(const double a[4], const double b[4],
                                    double ab[4])
{
    double c[3];

    vector_cross(&a[1], &b[1], c);
    ab[0] = a[0] * b[0] - vector_dot(&a[1], &b[1]);
    for (int k = 1; k < 4; k++)
        ab[k] = a[0] * b[k] + b[0] * a[k] + c[k - 1];
}

static inline void rotation_normalize(double q[4])
{
    const double length = sqrt(q[0] * q[0] + vector_dot(&q[1], &q[1]));

    for (int k = 0; k < 4; k++)
        q[k] /= length;
}

/* Q of q. */
static inline void rotation_matrix(const double q[4], double Q[3][3])
{
    const double s = q[0], *const v = &q[1];
    const double cross[3][3] = {
        {0.0, -v[2], v[1]}, {v[2], 0.0, -v[0]}, {-v[1], v[0], 0.0}};

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            Q[i][j] = (i == j ? s * s - vector_dot(v, v) : 0.0) +
                      2.0 * (v[i] * v[j] + s * cross[i][j]);
}

/* u = Q^T v, a vector of the box as the body sees it. */
static inline void rotation_to_body(const double q[4], const double v[3],
                                    double u[3])
{
    double Q[3][3];

    rotation_matrix(q, Q);
    for (int k = 0; k < 3; k++)
        u[k] = Q[0][k] * v[0] + Q[1][k] * v[1] + Q[2][k] * v[2];
}

/* About the axis k of the body, k, i, j in cyclic order, by twice the angle
 * atan(h): q goes on, and P, which the box keeps, goes back. */
static inline void rotation_about(double q[4], double P[3], int k, double h)
{
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const double per = 1.0 / (1.0 + h * h);
    const double c = (1.0 - h * h) * per, s = 2.0 * h * per;
    const double P_i = P[i], P_j = P[j];
    const double a = q[0], b = q[1 + k], e = q[1 + i], f = q[1 + j];

    P[i] = c * P_i + s * P_j;
    P[j] = c * P_j - s * P_i;
    q[0] = a - h * b;
    q[1 + k] = b + h * a;
    q[1 + i] = e + h * f;
    q[1 + j] = f - h * e;
}

/* q after dt [s], with per_I = 1/I; where that is 0 nothing turns the body. */
static inline void rotation_advance(double q[4], const double L[3],
                                    const double per_I[3], double dt)
{
    double P[3];

    rotation_to_body(q, L, P);
    rotation_about(q, P, 0, 0.25 * dt * P[0] * per_I[0]);
    rotation_about(q, P, 1, 0.25 * dt * P[1] * per_I[1]);
    rotation_about(q, P, 2, 0.50 * dt * P[2] * per_I[2]);
    rotation_about(q, P, 1, 0.25 * dt * P[1] * per_I[1]);
    rotation_about(q, P, 0, 0.25 * dt * P[0] * per_I[0]);
    rotation_normalize(q);
}

/* The spin w = Q I^-1 Q^T L [rad/s]. */
static inline void rotation_spin(const double q[4], const double L[3],
                                 const double per_I[3], double w[3])
{
    double Q[3][3], P[3];

    rotation_matrix(q, Q);
    rotation_to_body(q, L, P);
    for (int k = 0; k < 3; k++)
        P[k] *= per_I[k];
    for (int k = 0; k < 3; k++)
        w[k] = vector_dot(Q[k], P);
}

/* The entry i, j of Q^T G Q, of a symmetric G (xx, xy, xz, yy, yz, zz). */
static inline double rotation_moment(const double G[6], double Q[3][3], int i,
                                     int j)
{
    double sum = 0.0;

    for (int k = 0; k < 3; k++)
        for (int l = 0; l < 3; l++)
            sum += Q[k][i] * G[vector_place(k, l)] * Q[l][j];
    return sum;
}

/* The principal frame q of moments of inertia G, and the moments there: each
 * axis in turn is turned about until nothing but rounding is left beside the
 * diagonal, as Jacobi did it. Where nothing was there q is 1. The angle a has
 * tan 2a = off/more and tan a = t. */
static inline void rotation_principal(const double G[6], double q[4],
                                      double moments[3])
{
    double Q[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
    double P[3] = {0.0};

    q[0] = 1.0, q[1] = q[2] = q[3] = 0.0;
    for (int n = 0; n < 30; n++) {
        const int k = n % 3, i = (k + 1) % 3, j = (k + 2) % 3;
        const double off = rotation_moment(G, Q, i, j);
        if (fabs(off) <= 1e-16 * (G[0] + G[3] + G[5])) continue;
        const double more =
            0.5 * (rotation_moment(G, Q, i, i) - rotation_moment(G, Q, j, j));
        const double x = fabs(more) + sqrt(more * more + off * off);
        const double t = copysign(off, more * off) / x;
        rotation_about(q, P, k, t / (1.0 + sqrt(1.0 + t * t)));
        rotation_normalize(q);
        rotation_matrix(q, Q);
    }
    for (int k = 0; k < 3; k++)
        moments[k] = rotation_moment(G, Q, k, k);
}

#endif

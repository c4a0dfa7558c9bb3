/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fluid/inlets/face_mean.h"

#include "base/vector.h"
#include "mesh/measures.h"

enum { MOST_CORNERS = 64 }; /* further ones are left out */

/* Seven points of degree 5: barycentric coordinates and weights [Dunavant85].
 */
static double triangle_mean(const double a[3], const double b[3],
                            const double c[3],
                            double (*g)(const void *, const double *),
                            const void *of)
{
    static const double near[2] = {0.470142064105115, 0.101286507323456};
    static const double weight[2] = {0.132394152788506, 0.125939180544827};
    double sum = 0.0, x[3];

    for (int k = 0; k < 3; k++)
        x[k] = (a[k] + b[k] + c[k]) / 3.0;
    sum = 0.225 * g(of, x);
    for (int group = 0; group < 2; group++)
        for (int i = 0; i < 3; i++) {
            const double s = near[group], t = 1.0 - 2.0 * s;
            const double of_a = i == 0 ? t : s, of_b = i == 1 ? t : s;
            for (int k = 0; k < 3; k++)
                x[k] = of_a * a[k] + of_b * b[k] + (1.0 - of_a - of_b) * c[k];
            sum += weight[group] * g(of, x);
        }
    return sum;
}

static double face_mean_area_of(const double a[3], const double b[3],
                                const double c[3])
{
    double u[3], v[3], n[3];

    vector_between(b, a, u);
    vector_between(c, a, v);
    vector_cross(u, v, n);
    return 0.5 * vector_length(n);
}

double face_mean(const struct mesh *m, int f,
                 double (*g)(const void *of, const double x[3]), const void *of)
{
    double x[MOST_CORNERS][3], middle[3] = {0.0, 0.0, 0.0};
    double sum = 0.0, area = 0.0;
    const int all = mesh_face_corners(m, f, MOST_CORNERS, x);
    const int n = all < MOST_CORNERS ? all : MOST_CORNERS;

    for (int i = 0; i < n; i++)
        vector_along(middle, 1.0 / n, x[i], middle);
    for (int i = 0; i < n; i++) {
        const double *const next = x[(i + 1) % n];
        const double part = face_mean_area_of(middle, x[i], next);
        sum += part * triangle_mean(middle, x[i], next, g, of);
        area += part;
    }
    return sum / area;
}

# The speed of the sphere of settling-sphere.cfg from rest, m v' = (m - m_f) g - F(v),
# F = 3 pi mu d v (1 + 0.15 Re^0.687) [LS 5.13], by Runge and Kutta's method of fourth
# order with steps of 10 us. Makes settling.csv: awk -f settling.awk
function a(v) {
    phi = 1 + 0.15 * (rho * v * d / mu) ^ 0.687
    return (1 - rho / rho_s) * 9.81 - 18 * mu / (rho_s * d ^ 2) * v * phi
}
BEGIN {
    rho = 10; rho_s = 3000; mu = 1e-4; d = 1e-4; h = 1e-5
    print "time [s],v [m/s]"
    for (n = 0; n <= 10000; n++) {
        if (n % 50 == 0) printf "%.4f,%.8f\n", n * h, v
        k1 = a(v); k2 = a(v + h / 2 * k1); k3 = a(v + h / 2 * k2); k4 = a(v + h * k3)
        v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    }
}

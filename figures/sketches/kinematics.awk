# Two spheres in contact: distances, overlap, arms, velocities and forces of (2.1) to (2.3).
BEGIN {
    begin(720, 400)
    xi = 470; xj = 235; y = 190; Ri = 145; Rj = 115
    r = xi - xj
    xc = xj + r * Rj / (Ri + Rj)
    disc(xj, y, Rj, pale, blue)
    disc(xi, y, Ri, "none", ink)
    # the part that both fill
    x = (r * r + Rj * Rj - Ri * Ri) / (2 * r); h = sqrt(Rj * Rj - x * x)
    path(sprintf("M%.2f %.2f A%g %g 0 0 1 %.2f %.2f A%g %g 0 0 1 %.2f %.2f z", xj + x, y - h, Rj, Rj, xj + x, y + h, Ri, Ri, xj + x, y - h), "url(#hatch)", ink)
    line(xj, y, xi, y, soft, 1, "5 4")
    disc(xj, y, 3, ink, ink); disc(xi, y, 3, ink, ink)
    disc(xc, y, 4, orange, orange)
    word(xj - 10, y - 8, "x_{j}", "end", ink, "bold"); word(xi + 10, y - 8, "x_{i}", "start", ink, "bold")
    # radii
    line(xj, y, xj - Rj * 0.707, y + Rj * 0.707, ink, 1); word(xj - 62, y + 44, "R_{j}", "start", ink)
    line(xi, y, xi + Ri * 0.707, y + Ri * 0.707, ink, 1); word(xi + 62, y + 48, "R_{i}", "start", ink)
    # arms
    arrow(xi, y + 22, xc, y + 22, ink, 1); word((xi + xc) / 2 + 12, y + 40, "l_{i}", "middle")
    arrow(xj, y + 22, xc, y + 22, ink, 1); word((xj + xc) / 2, y + 40, "l_{j}", "middle")
    # overlap
    line(xi - Ri, y - 40, xi - Ri, y - 128, soft, 1, "3 3"); line(xj + Rj, y - 40, xj + Rj, y - 128, soft, 1, "3 3")
    arrow(xi - Ri - 26, y - 122, xi - Ri, y - 122, ink); arrow(xj + Rj + 26, y - 122, xj + Rj, y - 122, ink)
    word(xi - Ri - 30, y - 118, "overlap δ", "end")
    # distance
    line(xj, y + 4, xj, y + 186, soft, 1, "3 3"); line(xi, y + 4, xi, y + 186, soft, 1, "3 3")
    arrow(xj, y + 180, xi, y + 180, ink, 1); word((xi + xj) / 2, y + 174, "r", "middle", ink, "italic")
    # normal
    arrow(xi, y, xi + 70, y, blue); word(xi + 74, y + 5, "n", "start", blue, "bold")
    # velocity and spin
    arrow(xi, y, xi - 55, y - 80, orange); word(xi - 50, y - 86, "v_{i}", "start", orange, "bold")
    arrow(xj, y, xj - 10, y - 60, orange); word(xj - 4, y - 62, "v_{j}", "start", orange, "bold")
    spin(xi, y, 100); spin(xj, y, 78)
    word(xi + 76, y - 80, "ω_{i}", "start", orange, "bold"); word(xj - 78, y - 62, "ω_{j}", "end", orange, "bold")
    # what is what
    word(712, 372, "dashed: line of centres", "end", soft)
    word(712, 391, "hatched: the overlap, drawn much too large", "end", soft)
    end()
}
function spin(x, y, R,    a, b) {
    a = -0.95; b = -0.35
    if (R < 90) { a = -2.2; b = -2.8 }
    printf "<path d=\"M%.2f %.2f A%g %g 0 0 %d %.2f %.2f\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\" marker-end=\"url(#orange)\"/>\n", \
        x + R * cos(b), y + R * sin(b), R, R, R < 90 ? 1 : 0, x + R * cos(a), y + R * sin(a), orange
}

# The coupled step as a time line: what is computed, in which order, and what is handed on.
BEGIN {
    begin(760, 420)
    left = 110; right = 700; fluid = 92; grains = 262
    word(14, fluid + 5, "fluid", "start", blue, "bold")
    word(14, grains + 5, "particles", "start", orange, "bold")
    # the two time axes
    arrow(left, fluid, right + 40, fluid, blue); arrow(left, grains, right + 40, grains, orange)
    tick(left, "t^{n-1}"); tick(right, "t^{n}")
    # 1: one step of the fluid
    printf "<path d=\"M%g %g C%g %g %g %g %g %g\" fill=\"none\" stroke=\"%s\" stroke-width=\"2.5\" marker-end=\"url(#blue)\"/>\n", \
        left, fluid - 8, left + 120, fluid - 62, right - 120, fluid - 62, right - 2, fluid - 8, blue
    number(405, 48, 1, blue)
    word(405, 24, "one step Δt of the fluid, with K and F of the step before: u^{n}, p^{n}", "middle")
    # 2: the new velocity goes to the particles
    printf "<path d=\"M%g %g C%g %g %g %g %g %g\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\" stroke-dasharray=\"6 4\" marker-end=\"url(#ink)\"/>\n", \
        right - 6, fluid + 8, right - 40, fluid + 90, left + 90, grains - 120, left + 8, grains - 12, ink
    number(405, 164, 2, ink)
    word(left + 14, 122, "velocity and pressure gradient at the particles;", "start")
    word(left + 14, 140, "what the fluid has received is subtracted", "start")
    # 3 and 4: sub-steps with steps of the particles
    n = 4
    for (s = 0; s < n; s++) {
        a = left + (right - left) * s / n; b = left + (right - left) * (s + 1) / n
        printf "<path d=\"M%.1f %g Q%.1f %g %.1f %g\" fill=\"none\" stroke=\"%s\" stroke-width=\"2.5\" marker-end=\"url(#orange)\"/>\n", \
            a, grains + 8, (a + b) / 2, grains + 52, b - 2, grains + 8, orange
        line(b, grains - 9, b, grains + 9, orange, 2)
        for (k = 1; k < 10; k++)
            line(a + (b - a) * k / 10, grains - 4, a + (b - a) * k / 10, grains + 4, orange, 1)
    }
    number(left + 60, grains + 58, 3, orange)
    word(left + 80, grains + 62, "N_{s} sub-steps: the drag anew in each (long ticks)", "start")
    number(left + 60, grains + 84, 4, orange)
    word(left + 80, grains + 88, "in each, many steps of the particles with contacts (short ticks)", "start")
    # 5: averaging, at the end
    printf "<path d=\"M%g %g L%g %g\" fill=\"none\" stroke=\"%s\" stroke-width=\"2\" stroke-dasharray=\"2 4\" marker-end=\"url(#ink)\"/>\n", \
        right + 14, grains - 10, right + 14, fluid + 12, ink
    number(right + 14, 205, 5, ink)
    word(right - 8, 205, "averages: ε_{s}, u_{s};", "end")
    word(right - 8, 223, "from them K and F for the next step", "end")
    word(14, 398, "full: motion in time;  dashed: from the fluid to the particles;  dotted: from the particles to the fluid", "start", soft, " font-size=\"13\"")
    end()
}
function tick(x, name) {
    line(x, fluid - 14, x, grains + 14, soft, 1, "3 3")
    word(x, grains + 34, name, "middle")
}
function number(x, y, n, colour) {
    disc(x, y, 11, "#ffffff", colour)
    word(x, y + 5, n, "middle", colour, "bold")
}

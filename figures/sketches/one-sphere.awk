# What PCM, the kernel and diffusion make of one sphere: the part of it in each cell, in
# per cent, by (8.6), (8.7) and (8.9). Cells of one diameter, in a plane.
BEGIN {
    begin(760, 400)
    n = 7; w = 33; top = 70
    px = 3.72; py = 3.36   # the centre, in cells
    b = 2.5                # bandwidth of the kernel and of the Gaussian, in cells
    panel(12, "PCM", "all of it in the cell of its centre", 1)
    panel(262, "kernel, b = 2.5 cells", "by the distance of the cell's centre", 2)
    panel(512, "diffusion, b = 2.5 cells", "by a Gaussian, of cell averages", 3)
    word(12, 350, "Numbers: per cent of the volume of the sphere; where none stands, less than one half. In each panel", "start", soft)
    word(12, 369, "all cells together have 100. Diffusion begins with the field of PCM: it is symmetric about the cell of", "start", soft)
    word(12, 388, "the centre. The kernel is symmetric about the centre itself, which the cross marks.", "start", soft)
    end()
}
function erfc2(x,    t, s) { # erf by Abramowitz and Stegun 7.1.26, to 1.5e-7
    s = x < 0 ? -1 : 1; x = x < 0 ? -x : x
    t = 1 / (1 + 0.3275911 * x)
    return s * (1 - (((((1.061405429 * t - 1.453152027) * t) + 1.421413741) * t - 0.284496736) * t + 0.254829592) * t * exp(-x * x))
}
# The average over a cell of what diffusion makes of a full cell, along one axis.
function spread(k,    s, m, q) {
    s = 0; m = 40
    for (q = 0; q < m; q++) {
        x = (q + 0.5) / m - 0.5
        s += (erfc2((k + 0.5 - x) / b) - erfc2((k - 0.5 - x) / b)) / 2
    }
    return s / m
}
function part(i, j, how,    dx, dy, z) {
    if (how == 1) return i == int(px) && j == int(py)
    if (how == 3) return spread(i - int(px)) * spread(j - int(py))
    dx = i + 0.5 - px; dy = j + 0.5 - py
    z = (dx * dx + dy * dy) / (b * b)
    return z < 1 ? (1 - z) ^ 4 : 0
}
function panel(x, title, below, how,    i, j, sum, v, shade, far) {
    word(x + n * w / 2, 30, title, "middle", ink, "bold")
    word(x + n * w / 2, 52, below, "middle", soft, " font-size=\"13\"")
    # the kernel is divided by its sum; the others have theirs
    far = how == 3 ? 12 : 0
    sum = 0
    for (i = -far; i < n + far; i++) for (j = -far; j < n + far; j++) sum += part(i, j, how)
    for (i = 0; i < n; i++) for (j = 0; j < n; j++) {
        v = 100 * part(i, j, how) / sum
        shade = v > 60 ? 60 : v
        shade = how == 1 ? (v > 0 ? 0.75 : 0) : v / 22
        box(x + i * w, top + j * w, w, w, sprintf("rgb(%d,%d,%d)", 255 - 244 * shade, 255 - 165 * shade, 255 - 117 * shade), "#bbbbbb")
        if (i == int(px) && j == int(py))
            word(x + i * w + 3, top + (j + 1) * w - 3, sprintf("%.0f", v), "start", shade > 0.55 ? "#ffffff" : ink, " font-size=\"12\"")
        else if (v >= 0.5) word(x + (i + 0.5) * w, top + (j + 0.5) * w + 5, sprintf("%.0f", v), "middle", shade > 0.55 ? "#ffffff" : ink, " font-size=\"13\"")
    }
    disc(x + px * w, top + py * w, w / 2, "none", orange)
    line(x + px * w - 4, top + py * w, x + px * w + 4, top + py * w, orange, 1.5)
    line(x + px * w, top + py * w - 4, x + px * w, top + py * w + 4, orange, 1.5)
}

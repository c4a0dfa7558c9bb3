# The boxes of beds with their sensors, to scale, from the case files themselves.
#
#   awk -f svg.awk -f beds.awk -v title=... cases/mueller-bed.cfg ...
#
# The height of the packing follows from the number and size of the grains, with 0.6 of
# its volume solid. Where the case lists its grains, or has several sizes, the number and
# the diameter of equal volume are given before it: grains=512 diameter=1 cases/b.cfg

function numbers(s, list) {
    gsub(/^[^=]*= *[[(]+|[])].*/, "", s)
    return split(s, list, / *, */)
}
function value(s, key) {
    sub(".*" key " = ", "", s)
    sub(/[;} ].*/, "", s)
    return s
}
function at_height(field, height,    k) { # fields at one height have one line
    for (k = 1; k <= sensors[n]; k++)
        if (px[n, k] == -1 && py[n, k] + 0 == height + 0) {
            sensor[n, k] = sensor[n, k] ", " field
            return
        }
    sensor[n, ++sensors[n]] = field; py[n, sensors[n]] = height; px[n, sensors[n]] = -1
}
function slot(s,    part, k, m, pair) { # where the table of an inlet is not zero
    sub(/.*table = [(]/, "", s)
    m = split(s, part, /[)]/)
    for (k = 1; k <= m; k++)
        if (sub(/.*[(]/, "", part[k]) && split(part[k], pair, /, */) == 2 && pair[2] > 0) {
            if (!(n in from)) from[n] = pair[1] + 0
            to[n] = pair[1] + 0
        }
}
FNR == 1 {
    n++
    name[n] = FILENAME
    sub(/.*\//, "", name[n]); sub(/[.]cfg$/, "", name[n])
    d[n] = count[n] = 0
    given[n] = diameter; many[n] = grains
    diameter = grains = 0
}
{ sub(/#.*/, "") }
/^mesh|^fluid|^particles|^output|^effects/ { part = $1 }
part == "mesh" && /size = / { s = $0; sub(/.*size/, "size", s); numbers(s, v); W[n] = v[1]; H[n] = v[2]; T[n] = v[3] }
part == "mesh" && /cells = / { s = $0; sub(/.*cells/, "cells", s); numbers(s, v); cells[n] = v[1] + 0 " x " v[2] + 0 " x " v[3] + 0 " cells" }
/periodic = .true/ { wrap[n] = 1 }
part == "particles" && /count = / && /bed/ { count[n] = value($0, "count"); if (/diameter/) d[n] = value($0, "diameter") }
part == "particles" && /bed = .*sizes/ { count[n] = value($0, "count") }
part == "output" && /position = / && /field = "/ {
    s = $0; f = $0
    sub(/.*position/, "position", s); numbers(s, v)
    sub(/.*field = "/, "", f); sub(/".*/, "", f)
    sensor[n, ++sensors[n]] = f; px[n, sensors[n]] = v[1]; py[n, sensors[n]] = v[2]
}
part == "fluid" && /table = / { slot($0) }
part == "output" && /height = / && /field = "/ {
    f = $0; sub(/.*field = "/, "", f); sub(/".*/, "", f)
    at_height(f, value($0, "height"))
}
part == "effects" && /bubbles = .*height/ { at_height("bubbles", value($0, "height")) }
END {
    each = 225
    for (i = 1; i <= n; i++) if (many_heights(i)) each = 240
    begin(n * each + (n < 3 ? 80 : 20), 440)
    tall = 0
    for (i = 1; i <= n; i++) if (H[i] > tall) tall = H[i]
    for (i = 1; i <= n; i++) bed(62 + (i - 1) * each, i)
    word(20, 412, "dots: the packed bed;  depth into the page in brackets", "start", soft, " font-size=\"13\"")
    said = wrapped ? "dotted sides: periodic" : ""
    if (lines) said = said (said ? ";  " : "") "dashed: a line with its field"
    if (points) said = said (said ? ";  " : "") "cross: a sensor"
    word(20, 431, said, "start", soft, " font-size=\"13\"")
    end()
}
function many_heights(i,    k) { # of the same fields: these are named once
    for (k = 2; k <= sensors[i] && sensor[i, k] == sensor[i, 1]; k++) ;
    return sensors[i] > 2 && k > sensors[i]
}
function bed(x, i,    scale, w, h, base, p, k, y, unit, in_units, up, shift, last, said) {
    if (wrap[i]) wrapped = 1
    scale = 270 / H[i]
    if (W[i] * scale > 100) scale = 100 / W[i]
    w = W[i] * scale; h = H[i] * scale; base = 340
    unit = wrap[i] ? "d" : "mm"; in_units = wrap[i] ? 1 : 1000
    if (given[i]) d[i] = given[i]
    if (many[i]) count[i] = many[i]
    p = count[i] * 3.14159265 / 6 * d[i] ^ 3 / (W[i] * T[i] * 0.6)
    word(x + w / 2, 28, name[i], "middle", ink, "bold")
    word(x + w / 2, 46, cells[i], "middle", soft, " font-size=\"12\"")
    print "<pattern id=\"grains" i "\" width=\"5\" height=\"5\" patternUnits=\"userSpaceOnUse\"><circle cx=\"2.5\" cy=\"2.5\" r=\"1.7\" fill=\"" soft "\"/></pattern>"
    box(x, base - p * scale, w, p * scale, "url(#grains" i ")", "none")
    box(x, base - h, w, h, "none", "none")
    line(x, base - h, x, base, ink, wrap[i] ? 1 : 2.5, wrap[i] ? "2 3" : ""); line(x + w, base - h, x + w, base, ink, wrap[i] ? 1 : 2.5, wrap[i] ? "2 3" : "")
    line(x, base, x + w, base, blue, 1.5); line(x, base - h, x + w, base - h, blue, 1.5)
    if (i in from) {
        line(x, base, x + w, base, ink, 2.5)
        line(x + from[i] * scale, base, x + to[i] * scale, base, "white", 3)
        line(x + from[i] * scale, base, x + to[i] * scale, base, blue, 1.5)
        arrow(x + w / 2, base + 24, x + w / 2, base + 3, blue)
    } else
        for (k = 0; k < 3; k++) arrow(x + w * (k + 0.5) / 3, base + 24, x + w * (k + 0.5) / 3, base + 3, blue)
    arrow(x + w / 2, base - h - 2, x + w / 2, base - h - 20, blue)
    word(x + w / 2, base + 42, sprintf("%g (%g) %s", W[i] * in_units, T[i] * in_units, unit), "middle")
    arrow(x - 10, base, x - 10, base - h, soft, 1)
    printf "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" fill=\"%s\" transform=\"rotate(-90 %.1f %.1f)\">%g %s</text>\n", x - 16, base - h / 2, ink, x - 16, base - h / 2, H[i] * in_units, unit
    last = 1e9
    # from the bottom up, so that names do not overlap
    for (;;) {
        up = 0
        for (k = 1; k <= sensors[i]; k++) if (!said[k] && (!up || py[i, k] + 0 < py[i, up] + 0)) up = k
        if (!up) break
        said[up] = 1
        y = base - py[i, up] * scale
        if (px[i, up] < 0) { line(x - 3, y, x + w + 6, y, orange, 2, "6 3"); lines = 1 }
        else { mark(x + px[i, up] * scale, y); line(x + px[i, up] * scale + 6, y, x + w + 6, y, orange, 1); points = 1 }
        shift = y + 5 > last - 15 ? last - 15 : y + 5
        word(x + w + 10, shift, (many_heights(i) ? "" : sensor[i, up] ", ") sprintf("%g %s", py[i, up] * in_units, unit), "start", orange, " font-size=\"13\"")
        last = shift
    }
    if (many_heights(i)) word(x + w + 10, last - 18, sensor[i, 1], "start", orange, " font-size=\"13\"")
}
function mark(x, y) {
    line(x - 5, y - 5, x + 5, y + 5, orange, 2.5); line(x - 5, y + 5, x + 5, y - 5, orange, 2.5)
}

# A sphere and the facets of a surface, from the side: (14.1), (14.4), and which nearest
# points count.
BEGIN {
    begin(760, 360)
    R = 72
    # a face
    x = 120; y = 130; floor_ = 185
    scene(x, "on a face")
    path(sprintf("M%g %g A%g %g 0 0 1 %g %g", x + 46.5, floor_, R, R, x - 46.5, floor_), "url(#hatch)", orange)
    disc(x, y, R, "none", blue); line(20, floor_, 225, floor_, ink, 3)
    nearest(x, y, x, floor_, "q"); word(x + 8, y - 6, "y", "start", ink, "bold")
    arrow(x, floor_, x, 75, blue); word(x + 7, 86, "n", "start", blue, "bold")
    line(x - R * 0.8, y - R * 0.6, x, y, ink, 1); word(x - 44, y - 17, "R", "end", ink, "italic")
    word(x + 7, y + 32, "r", "start", ink, "italic")
    line(x, y + R, x + 98, y + R, soft, 1, "3 3")
    arrow(x + 92, floor_ - 26, x + 92, floor_, ink); arrow(x + 92, y + R + 26, x + 92, y + R, ink)
    word(x + 96, y + R + 40, "δ = R - r", "end", ink)
    word(x, 268, "the cut is a disc; its depth", "middle"); word(x, 287, "is the overlap δ, drawn large", "middle")
    # an edge
    x = 380; y = 130; scene(x, "on an edge")
    ex = x + 28; ey = y + 50
    disc(x, y, R, "none", blue)
    line(ex, ey, x + 125, ey + 18, ink, 3); line(ex, ey, ex + 24, y + 110, ink, 3)
    nearest(x, y, ex, ey, "q"); word(x - 8, y - 6, "y", "end", ink, "bold")
    arrow(ex, ey, x - 30, y - 53, blue); word(x - 24, y - 58, "n", "start", blue, "bold")
    word(x, 268, "n points from the edge to y; both", "middle"); word(x, 287, "facets have this q: one contact", "middle")
    # a seam and a corner
    x = 638; y = 130; scene(x, "in a corner")
    disc(x, y, R, "none", blue)
    line(x - 60, y - 75, x - 60, y + 60, ink, 3); line(x - 60, y + 60, x + 105, y + 60, ink, 3)
    nearest(x, y, x, y + 60, "q"); nearest(x, y, x - 60, y, "q'", 1)
    word(x + 8, y - 6, "y", "start", ink, "bold")
    word(x, 268, "two nearest points, neither", "middle"); word(x, 287, "behind the other: two contacts", "middle")
    word(20, 335, "thick: facets from the side;  dot: nearest point q;  dashed: its distance r from the centre y;  hatched: overlap", "start", soft, " font-size=\"13\"")
    end()
}
function scene(x, title) { word(x, 32, title, "middle", ink, "bold") }
function nearest(x, y, qx, qy, name, side) {
    line(x, y, qx, qy, ink, 1.5, "5 4"); disc(x, y, 3, ink, ink); disc(qx, qy, 4.5, orange, orange)
    word(qx + (side ? -8 : -7), qy + (side ? 5 : 18), name, "end", orange, "bold")
}

#!/bin/sh
# Draws 31-ranks.svg: the cells of two ranks, the layers of each, and the three
# things that all ranks do together.
#
#   sh figures/31/31-ranks.sh >figures/31/31-ranks.svg
awk 'BEGIN {
    s = 24; w = 8; h = 7; gap = 90
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 330\" width=\"700\" height=\"330\" font-family=\"sans-serif\" font-size=\"14\">"
    print "<rect width=\"700\" height=\"330\" fill=\"#ffffff\"/>"
    rank(40, "rank 0", 0); rank(40 + (w + 2) * s + gap, "rank 1", 1)
    note(350, 262, "layers are refreshed after each solve, each corrector and each step")
    note(350, 284, "PETSc solves for all cells at once; LAMMPS moves the spheres across the cut")
    note(350, 306, "sums of the averaging go from the layers to the owners")
    arrow(40 + (w + 2) * s + 6, 130, 40 + (w + 2) * s + gap - 6)
    print "</svg>"
}
function rank(x0, name, second,   i, j, own, n) {
    n = w + 2
    printf "<text x=\"%d\" y=\"26\" text-anchor=\"middle\" font-weight=\"bold\">%s</text>\n", x0 + n * s / 2, name
    for (j = 0; j < h; j++) for (i = 0; i < n; i++) {
        own = second ? i >= 2 : i < w
        printf "<rect x=\"%d\" y=\"%d\" width=\"%d\" height=\"%d\" fill=\"%s\" stroke=\"#8a9aa5\"/>\n", x0 + i * s, 40 + j * s, s, s, own ? "#dcebf5" : "#f6e3d3"
    }
    i = second ? x0 + 2 * s : x0 + w * s
    printf "<line x1=\"%d\" y1=\"34\" x2=\"%d\" y2=\"%d\" stroke=\"#0b5a8a\" stroke-width=\"3\"/>\n", i, i, 46 + h * s
    i = second ? x0 : x0 + n * s
    printf "<line x1=\"%d\" y1=\"40\" x2=\"%d\" y2=\"%d\" stroke=\"#c2571a\" stroke-width=\"3\" stroke-dasharray=\"5 4\"/>\n", i, i, 40 + h * s
    srand(second + 4)
    for (i = 0; i < 26; i++)
        printf "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"6\" fill=\"#6b7f4a\" fill-opacity=\"0.75\"/>\n", x0 + (second ? 2 * s : 0) + 8 + rand() * (w * s - 16), 40 + h * s - 8 - rand() * 74
    printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"#0b5a8a\">own cells</text>\n", x0 + (second ? 2 + w / 2 : w / 2) * s, 62
    printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"#c2571a\">2 layers</text>\n", x0 + (second ? 1 : w + 1) * s, 40 + h * s + 22
}
function note(x, y, text) { printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"#333333\">%s</text>\n", x, y, text }
function arrow(a, y, b) {
    printf "<path d=\"M%d %d L%d %d M%d %d l8 -5 M%d %d l8 5 M%d %d l-8 -5 M%d %d l-8 5\" stroke=\"#333333\" stroke-width=\"1.5\" fill=\"none\"/>\n", a, y, b, y, a, y, a, y, b, y, b, y
    printf "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\" fill=\"#333333\">MPI</text>\n", (a + b) / 2, y - 10
}'

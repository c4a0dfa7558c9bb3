# svg.awk -- lines, arrows, circles and words of the sketches, as SVG.
#
#   awk -f svg.awk -f one-sphere.awk </dev/null >../08/08-one-sphere.svg
#
# Coordinates are those of the picture: pixels to the right and down. Nothing
# is said by colour alone: lines differ by dashes, areas by shade, and all are labelled.

function begin(width, height) {
    blue = "#0b5a8a"; orange = "#c2571a"; ink = "#333333"; soft = "#777777"
    pale = "#d9e6ee"; sand = "#f0d9c9"
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %g %g\" width=\"%g\" height=\"%g\"", width, height, width, height
    print " font-family=\"sans-serif\" font-size=\"14\">"
    print "<defs>"
    head("blue", blue); head("orange", orange); head("ink", ink); head("soft", soft)
    print "<pattern id=\"hatch\" width=\"7\" height=\"7\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><line x1=\"0\" y1=\"0\" x2=\"0\" y2=\"7\" stroke=\"" soft "\" stroke-width=\"1.5\"/></pattern>"
    print "</defs>"
    box(0, 0, width, height, "#ffffff", "none")
}

function end() { print "</svg>" }

function head(name, colour) {
    print "<marker id=\"" name "\" viewBox=\"0 0 10 10\" refX=\"9\" refY=\"5\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto-start-reverse\"><path d=\"M0 1 L10 5 L0 9 z\" fill=\"" colour "\"/></marker>"
}

function named(colour) {
    return colour == blue ? "blue" : colour == orange ? "orange" : colour == soft ? "soft" : "ink"
}

function box(x, y, w, h, inside, edge) {
    printf "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" fill=\"%s\" stroke=\"%s\"/>\n", x, y, w, h, inside, edge
}

function disc(x, y, r, inside, edge) {
    printf "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\" fill=\"%s\" stroke=\"%s\" stroke-width=\"1.5\"/>\n", x, y, r, inside, edge
}

function line(x1, y1, x2, y2, colour, width, dashes) {
    printf "<line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\" stroke=\"%s\" stroke-width=\"%g\"%s/>\n", \
        x1, y1, x2, y2, colour, width, dashes ? " stroke-dasharray=\"" dashes "\"" : ""
}

# With a head at its end; at both ends if it measures a length.
function arrow(x1, y1, x2, y2, colour, both) {
    printf "<line x1=\"%.2f\" y1=\"%.2f\" x2=\"%.2f\" y2=\"%.2f\" stroke=\"%s\" stroke-width=\"2\" marker-end=\"url(#%s)\"%s/>\n", \
        x1, y1, x2, y2, colour, named(colour), both ? " marker-start=\"url(#" named(colour) ")\"" : ""
}

# The anchor is start, middle or end; a style of bold or italic may follow.
function word(x, y, text, anchor, colour, style) {
    gsub(/&/, "\\&amp;", text)
    printf "<text x=\"%.2f\" y=\"%.2f\" text-anchor=\"%s\" fill=\"%s\"%s>%s</text>\n", x, y, \
        anchor ? anchor : "start", colour ? colour : ink, \
        style == "bold" ? " font-weight=\"bold\"" : style == "italic" ? " font-style=\"italic\"" : style, text
}

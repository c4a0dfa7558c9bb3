# A mesh of OpenFOAM's format from quadrangles in the plane, one cell deep, or,
# with -v tetrahedra=LAYERS, of so many layers of tetrahedra.
#
#   awk -f cases/meshes/extruded.awk -f cases/meshes/ring.awk -v out=DIR
#
# The second program calls quadrangle(a, b, c, d), the corners going round
# against the clock, each from corner(x, y); side(x, y) of it names the patch of
# an edge with its middle there. At the end write_mesh(depth) writes the files.
# Corners closer than 1e-9 are one.

BEGIN { n_corners = n_columns = n_cells = n_faces = n_patches = 0 }

function corner(x, y,   key) {
    key = sprintf("%.9f %.9f", x + 1e-12, y + 1e-12)
    if (!(key in number)) {
        number[key] = n_corners
        px[n_corners] = x
        py[n_corners] = y
        n_corners++
    }
    return number[key]
}

function quadrangle(a, b, c, d) {
    column[n_columns, 0] = a; column[n_columns, 1] = b
    column[n_columns, 2] = c; column[n_columns, 3] = d
    n_columns++
}

# A face of the present cell: the first cell that has a face owns it, and its
# corners go round with the normal out of that one; the second is its neighbour.
# key is the same for both, patch the name of the side if there is no second.
function face(key, corners, patch) {
    if (key in known) { beyond[known[key]] = n_cells; return }
    known[key] = n_faces
    text[n_faces] = corners; name[n_faces] = patch
    owner[n_faces] = n_cells; beyond[n_faces] = -1
    n_faces++
}

# The name of the side with the edge from a to b, of the lowest layer.
function edge_side(a, b) {
    return side(0.5 * (px[a] + px[b]), 0.5 * (py[a] + py[b]))
}

function hexahedron(c,   i, k, a, b, upper) {
    for (i = 0; i < 4; i++) {
        a = column[c, i]; b = column[c, (i + 1) % 4]
        face(a < b ? a " " b : b " " a, \
             "4(" a " " b " " b + n_corners " " a + n_corners ")", edge_side(a, b))
    }
    for (k = 0; k < 2; k++) {
        upper = ""
        for (i = 0; i < 4; i++)
            upper = upper (i ? " " : "") \
                column[c, k ? i : 3 - i] + (k ? n_corners : 0)
        face(upper, "4(" upper ")", k ? "above" : "below")
    }
    n_cells++
}

# A prism over a triangle of corners a < b < c is three tetrahedra. Its sides are
# cut from the lower corner below to the higher one above, as those of its
# neighbours are.
function prism(a, b, c, layer,   swap, n) {
    if (a > b) { swap = a; a = b; b = swap }
    if (b > c) { swap = b; b = c; c = swap }
    if (a > b) { swap = a; a = b; b = swap }
    n = n_corners
    a += layer * n; b += layer * n; c += layer * n
    tetrahedron(a, b, c, c + n)
    tetrahedron(a, b, b + n, c + n)
    tetrahedron(a, a + n, b + n, c + n)
}

function tetrahedron(a, b, c, d) {
    triangle(a, b, c, d)
    triangle(a, b, d, c)
    triangle(a, c, d, b)
    triangle(b, c, d, a)
    n_cells++
}

# The side a < b < c of a tetrahedron, opposite to its corner e.
function triangle(a, b, c, e,   low, high, flat) {
    low = a % n_corners
    high = c % n_corners == low ? b % n_corners : c % n_corners
    flat = int(a / n_corners) == int(c / n_corners)
    face(a " " b " " c, \
         "3(" a " " (volume(a, b, c, e) > 0 ? c " " b : b " " c) ")", \
         !flat ? edge_side(low, high) : a < n_corners ? "below" : "above")
}

# Six times the volume of a tetrahedron, positive if b, c, e go round against the
# clock as one sees them from a.
function volume(a, b, c, e,   i, at, x, y, z) {
    at[1] = b; at[2] = c; at[3] = e
    for (i = 1; i <= 3; i++) {
        x[i] = px[at[i] % n_corners] - px[a % n_corners]
        y[i] = py[at[i] % n_corners] - py[a % n_corners]
        z[i] = int(at[i] / n_corners) - int(a / n_corners)
    }
    return x[3] * (y[1] * z[2] - z[1] * y[2]) + \
        y[3] * (z[1] * x[2] - x[1] * z[2]) + z[3] * (x[1] * y[2] - y[1] * x[2])
}

function cut(   layer, c) {
    if (!tetrahedra) {
        for (c = 0; c < n_columns; c++) hexahedron(c)
        return
    }
    for (layer = 0; layer < tetrahedra; layer++)
        for (c = 0; c < n_columns; c++) {
            prism(column[c, 0], column[c, 1], column[c, 2], layer)
            prism(column[c, 0], column[c, 2], column[c, 3], layer)
        }
}

# The faces in the order of the files: the inner ones, then patch by patch, the
# ends of the columns last.
function order_faces(   f, p, k) {
    n_ordered = 0
    for (f = 0; f < n_faces; f++)
        if (beyond[f] >= 0) order[n_ordered++] = f
    n_inner = n_ordered
    for (f = 0; f < n_faces; f++) {
        if (beyond[f] >= 0) continue
        if (!(name[f] in count) && name[f] !~ /^(below|above)$/)
            patch[++n_patches] = name[f]
        list[name[f], count[name[f]]++] = f
    }
    for (p = 1; p <= n_patches; p++) append(p, patch[p])
    patch[++n_patches] = "ends"
    append(n_patches, "below")
    append(n_patches, "above")
}

# The listed faces as the next ones of patch p.
function append(p, of,   k) {
    if (!(p in first)) first[p] = n_ordered
    for (k = 0; k < count[of]; k++) order[n_ordered++] = list[of, k]
    size[p] = n_ordered - first[p]
}

# A file of the mesh with its header; the list follows.
function begin(name, class, count) {
    file = out "/" name
    printf "FoamFile\n{\n    version 2.0;\n    format ascii;\n" \
        "    class %s;\n    object %s;\n}\n%d\n(\n", class, name, count >file
}

function finish() { print ")" >file; close(file) }

function write_mesh(depth,   i, k, p, layers) {
    cut()
    order_faces()
    layers = tetrahedra ? tetrahedra : 1
    begin("points", "vectorField", (layers + 1) * n_corners)
    for (k = 0; k <= layers; k++)
        for (i = 0; i < n_corners; i++)
            printf "(%.12g %.12g %.12g)\n", px[i], py[i], k * depth / layers >file
    finish()
    begin("faces", "faceList", n_faces)
    for (i = 0; i < n_faces; i++) print text[order[i]] >file
    finish()
    begin("owner", "labelList", n_faces)
    for (i = 0; i < n_faces; i++) print owner[order[i]] >file
    finish()
    begin("neighbour", "labelList", n_inner)
    for (i = 0; i < n_inner; i++) print beyond[order[i]] >file
    finish()
    begin("boundary", "polyBoundaryMesh", n_patches)
    for (p = 1; p <= n_patches; p++)
        printf "    %s\n    {\n        type %s;\n        nFaces %d;\n" \
            "        startFace %d;\n    }\n", patch[p], \
            patch[p] == "ends" ? (tetrahedra ? "symmetryPlane" : "empty") : "patch", \
            size[p], first[p] >file
    finish()
}

# A mesh of OpenFOAM's format from quadrangles in the plane, one cell deep.
#
#   awk -f cases/meshes/extruded.awk -f cases/meshes/ring.awk -v out=DIR
#
# The second program calls quadrangle(a, b, c, d), the corners going round
# against the clock, each from corner(x, y); side(x, y) of it names the patch of
# an edge with its middle there. At the end write_mesh(depth) writes the files.
# Corners closer than 1e-9 are one.

BEGIN { n_corners = n_cells = n_edges = n_faces = n_patches = 0 }

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
    cell[n_cells, 0] = a; cell[n_cells, 1] = b
    cell[n_cells, 2] = c; cell[n_cells, 3] = d
    n_cells++
}

# A file of the mesh with its header; the list follows.
function begin(name, class, count) {
    file = out "/" name
    printf "FoamFile\n{\n    version 2.0;\n    format ascii;\n" \
        "    class %s;\n    object %s;\n}\n%d\n(\n", class, name, count >file
}

function finish() { print ")" >file; close(file) }

# Edges: the first cell that has one owns it, the second is its neighbour.
function find_edges(   c, i, a, b, key) {
    for (c = 0; c < n_cells; c++)
        for (i = 0; i < 4; i++) {
            a = cell[c, i]; b = cell[c, (i + 1) % 4]
            key = a < b ? a " " b : b " " a
            if (key in edge) { beyond[edge[key]] = c; continue }
            edge[key] = n_edges
            from[n_edges] = a; to[n_edges] = b
            owner[n_edges] = c; beyond[n_edges] = -1
            n_edges++
        }
}

function put_edge(e) {
    n_faces++
    face[n_faces] = "4(" from[e] " " to[e] " " to[e] + n_corners " " \
        from[e] + n_corners ")"
    own[n_faces] = owner[e]
    other[n_faces] = beyond[e]
}

function put_end(c, upper,   i, text) {
    for (i = 0; i < 4; i++)
        text = text (i ? " " : "") \
            cell[c, upper ? i : 3 - i] + (upper ? n_corners : 0)
    n_faces++
    face[n_faces] = "4(" text ")"
    own[n_faces] = c
}

# The faces in the order of the files: the inner ones, then patch by patch.
function order_faces(   e, p, c, k, name) {
    for (e = 0; e < n_edges; e++)
        if (beyond[e] >= 0) put_edge(e)
    n_inner = n_faces
    for (e = 0; e < n_edges; e++) {
        if (beyond[e] >= 0) continue
        name = side(0.5 * (px[from[e]] + px[to[e]]), 0.5 * (py[from[e]] + py[to[e]]))
        if (!(name in count)) patch[++n_patches] = name
        list[name, count[name]++] = e
    }
    for (p = 1; p <= n_patches; p++) {
        first[p] = n_faces
        for (k = 0; k < count[patch[p]]; k++) put_edge(list[patch[p], k])
    }
    patch[++n_patches] = "ends"
    count["ends"] = 2 * n_cells
    first[n_patches] = n_faces
    for (k = 0; k < 2; k++)
        for (c = 0; c < n_cells; c++) put_end(c, k)
}

function write_mesh(depth,   i, k, p) {
    find_edges()
    order_faces()
    begin("points", "vectorField", 2 * n_corners)
    for (k = 0; k < 2; k++)
        for (i = 0; i < n_corners; i++)
            printf "(%.12g %.12g %.12g)\n", px[i], py[i], k * depth >file
    finish()
    begin("faces", "faceList", n_faces)
    for (i = 1; i <= n_faces; i++) print face[i] >file
    finish()
    begin("owner", "labelList", n_faces)
    for (i = 1; i <= n_faces; i++) print own[i] >file
    finish()
    begin("neighbour", "labelList", n_inner)
    for (i = 1; i <= n_inner; i++) print other[i] >file
    finish()
    begin("boundary", "polyBoundaryMesh", n_patches)
    for (p = 1; p <= n_patches; p++)
        printf "    %s\n    {\n        type %s;\n        nFaces %d;\n" \
            "        startFace %d;\n    }\n", patch[p], \
            patch[p] == "ends" ? "empty" : "patch", count[patch[p]], first[p] >file
    finish()
}

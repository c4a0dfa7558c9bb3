# Writes each row of the array as a case file, FOLDER/LETTER-NUMBER.cfg, and a
# line for it in FOLDER/list: its name, its choices, and behind a # what the
# program should say against it.
#
#   awk -v letter=c -v seed=1 -v folder=. -f array.awk -f keys.awk -f choices.awk -f case.awk
#
# All boxes are about 12 mm wide, particles 1 mm (or 0.4 mm, where there are
# many), a run is ten steps of 0.2 ms.

function is(name, words) { return index(" " words " ", " " v[name] " ") > 0 }
function on(name) { return name in v && v[name] != "off" && v[name] != "none" }
function put(text) { print text >file }
function real(x,    t) { t = sprintf("%.9g", x); return t ~ /[.e]/ ? t : t ".0" }
function vec(x, y, z) { return "[" real(x) ", " real(y) ", " real(z) "]" }

# Where the share (a, b, c) of the box is; an oblique one leans along x over y.
function at(a, b, c) {
    return vec(a * size[1] + lean * b * size[2], b * size[2], c * size[3])
}

function set_size(x, y, z, nx, ny, nz, along) {
    size[1] = x; size[2] = y; size[3] = z
    cells = "[" nx ", " ny ", " nz "]"
    lean = along
}

function put_mesh(    i, p) {
    set_size(0.012, 0.016, 0.012, 4, 6, 4, 0)
    if (on("bodies")) set_size(0.012, 0.016, 0.012, 8, 11, 8, 0)
    if (is("mesh", "thin")) set_size(0.012, 0.016, 0.0048, 4, 6, 1, 0)
    if (is("mesh", "sheared")) set_size(0.012, 0.016, 0.012, 4, 6, 4, 0.2)
    if (is("mesh", "dual")) set_size(0.012, 0.012, 0.012, 0, 0, 0, 0)
    if (is("mesh", "cyclic")) set_size(0.012, 0.012, 0.0024, 0, 0, 0, 0)
    if (is("mesh", "slanted")) set_size(0.012, 0.012, 0.006, 0, 0, 0, 0.4)
    for (i = 1; i <= 3; i++)
        round[i] = on("periodic") && index(v["periodic"], substr("xyz", i, 1)) > 0
    if (is("mesh", "dual cyclic slanted")) {
        put("mesh = { polymesh = \"" v["mesh"] "\"; };")
        return
    }
    put("mesh = { size = " vec(size[1], size[2], size[3]) "; cells = " cells ";")
    if (is("mesh", "graded")) put("  grading = [2.0, 0.5, 1.5];")
    if (is("mesh", "sheared")) put("  shear = [0.2, 0.0, 0.0];")
    for (i = 1; i <= 3; i++) p = p (i > 1 ? ", " : "") (round[i] ? "true" : "false")
    if (on("periodic")) put("  periodic = [" p "];")
    put("};")
}

function side(name, what) { put("  " name " = " what ";") }

# 1 if the flow is driven at side number k.
function acts(k) {
    return (is("drive", "wall turning") && k == 6) || (k == 3 && \
        is("drive", "through parabola formula table ramp pressure")) || \
        (k == 4 && is("drive", "through parabola formula table ramp pressure outlet"))
}

function put_sides(    i, k, name, what, ends) {
    ends = "left right bottom top back front"
    split(ends, name, " ")
    for (k = 1; k <= 6; k++) {
        if (round[int((k + 1) / 2)] && !acts(k)) continue
        what = is("sides", "slip") || (is("sides", "mixed") && k % 2) ? \
            "\"slip\"" : "\"no-slip\""
        if (is("drive", "wall") && k == 6) what = "{ wall = [0.1, 0.0, 0.0]; }"
        if (is("drive", "turning") && k == 6) # about an axis across it
            what = "{ rotation = [0.0, 0.0, 10.0]; centre = " at(0.5, 0.5, 0.0) "; }"
        if (is("drive", "pressure") && k == 3) what = "{ pressure = 1.0; }"
        if (is("drive", "table") && k == 3)
            what = "{ inlet = 0.2; profile = \"table\"; table = ((0.0, 1.0), (0.012, 0.5)); along = [1.0, 0.0, 0.0]; }"
        if (is("drive", "through parabola formula") && k == 3)
            what = "{ inlet = 0.2;" (is("drive", "parabola") ? \
                " profile = \"parabola\";" : is("drive", "formula") ? \
                " profile = \"formula\"; formula = \"1+0.5*sin(300*x+900*t)\";" : "") " }"
        if (is("drive", "ramp") && k == 3)
            what = "{ inlet = ((0.0, 0.0), (1e-3, 0.3), (2e-3, 0.1)); }"
        if (is("drive", "through parabola formula table ramp pressure outlet") && k == 4)
            what = "{ outlet = 0.0; }"
        side(name[k], what)
    }
}

function put_fluid(    i, d) {
    put("fluid = {")
    put(is("medium", "air") ? "  density = 1.2; viscosity = 1.8e-5;" : \
        "  density = 500; viscosity = 1e-3;")
    put("  step = " step ";")
    for (i = 1; i <= 3; i++) d[i] = 0
    d[round[1] || !(round[2] || round[3]) ? 1 : round[2] ? 2 : 3] = 1
    if (is("drive", "gradient"))
        put("  mean_gradient = " vec(-50 * d[1], -50 * d[2], -50 * d[3]) ";")
    if (is("drive", "flow"))
        put("  mean_flow = " vec(0.1 * d[1], 0.1 * d[2], 0.1 * d[3]) ";")
    put_sides()
    put("};")
}

function material(density) {
    return density (is("particles.contact", "hertz") ? " young = 1e5; poisson = 0.3;" : \
        " stiffness = 20.0;" (is("materials", "several") ? " tangential_ratio = 0.4;" : "")) " restitution = 0.8; friction = 0.3;" \
        (on("rolling") ? " rolling_friction = 0.1;" : "")
}

function put_bodies(    where) { # above the particles, where there are any
    where = letter != "f" ? 0.83 : is("bodies", "cylinder") ? 0.4 : 0.5
    put("bodies = {")
    if (is("bodies", "cylinder"))
        put("  cylinders = ({ position = " at(0.5, where, 0.5) "; diameter = " (letter != "f" ? "0.003" : "0.005") ";" \
            " length = 0.03; axis = [1.0, 0.0, 1.0]; });")
    else if (is("bodies", "box"))
        put("  boxes = ({ position = " at(0.5, where, 0.5) "; size = [0.005, 0.005, 0.006]; rotation = [0.3, 0.0, 0.5];" \
            " motion = \"spring\"; spring = [1.0, 0.0, 1.0]; density = 2500; velocity = [0.1, 0.0, 0.0]; });")
    else if (is("bodies", "clump"))
        put("  clumps = ({ file = \"pair.spheres\"; position = " at(0.5, where, 0.5) "; density = 2500; spin = [0.0, 1.0, 2.0]; });")
    else if (is("bodies", "surface solid"))
        put("  surfaces = ({ file = \"eight.stl\"; scale = 1e-3; position = " at(0.5, where, 0.5) \
            (is("bodies", "solid") ? "; motion = \"free\"; density = 2500;" : \
             "; motion = \"prescribed\"; velocity = [0.1, 0.2, -0.1];") " spin = [5.0, 1.0, 0.0]; });")
    else
        put("  spheres = ({ position = " at(0.5, where, 0.5) "; diameter = 0.0047;" \
            (is("bodies", "fixed") ? " motion = \"fixed\";" : \
             is("bodies", "free") ? " density = 2500;" : \
             " motion = \"prescribed\"; velocity = [0.1, 0.2, -0.1]; spin = [0.0, 1.0, 0.0];") " });")
    put("};")
}

function put_materials() {
    charge = is("count", "crowd") ? " charge = 1e-12;" : " charge = 1e-11;" # of smaller grains
    if (!is("cohesion", "electrostatic all")) charge = ""
    put("  grains = {" material(" density = 1000;") charge " };")
    if (is("materials", "one")) return
    put("  materials = ( { name = \"felt\";" material(" density = 2000;") charge " } );")
    if (is("materials", "wall")) put("  walls = { material = \"felt\"; };")
    if (is("materials", "pairs"))
        put("  pairs = ( { between = \"grains\"; and = \"felt\"; restitution = 0.5;" \
            " friction = 0.1;" (on("rolling") ? " rolling_friction = 0.2;" : "") \
            (is("particles.contact", "linear") ? " stiffness = 15.0; tangential_ratio = 0.3;" : "") " } );")
}

# Each diameter about that of a grain. (A parcel is l grains wide, and has the
# place and the diameter d of a sphere without parcels.)
function put_sizes(    s, d) {
    if (is("sizes", "equal")) return
    d = grain
    s = is("sizes", "uniform") ? sprintf("min = %g; max = %g;", 0.8 * d, 1.2 * d) : \
        is("sizes", "normal") ? sprintf("mean = %g; deviation = %g; min = %g; max = %g;", d, 0.1 * d, 0.7 * d, 1.3 * d) : \
        is("sizes", "lognormal") ? sprintf("median = %g; ratio = 1.1; min = %g; max = %g;", d, 0.7 * d, 1.3 * d) : \
        sprintf("points = ((%g, %s), (%g, %s)); by = \"mass\";", 0.8 * d, \
            is("sizes", "table") ? "0.0" : "0.4", 1.2 * d, \
            is("sizes", "table") ? "1.0" : "0.6")
    put("  sizes = ( { name = \"some\"; distribution = \"" v["sizes"] "\"; " s " } );")
}

function sized() {
    return (on("clumps") ? "clump = \"egg\"; " : "") \
        (is("sizes", "equal") ? "diameter = " grain ";" : "sizes = \"some\";")
}

function sphere(where, velocity, i) {
    return "{ position = " where "; velocity = " velocity "; " \
        (on("clumps") && i % 2 ? "clump = \"egg\"; rotation = [0.0, 0.0, " i / 2 "]; " : "") \
        "diameter = " grain * (is("sizes", "equal") ? 1 : 0.7 + 0.1 * i) * (on("clumps") ? 0.85 : 1) ";" \
        (is("materials", "several pairs") && i % 2 ? " material = \"felt\";" : "") \
        (i == 2 ? " spin = [10.0, -20.0, 300.0];" : "") " }"
}

# Two that meet along x, two along y, one that flies to the left side and one to
# the bottom.
function put_few(    g) {
    g = 0.55 * d
    put("  place = (")
    put(sphere(at(0.3 - g / size[1], 0.3, 0.5), "[0.3, 0.0, 0.0]", 1) ",")
    put(sphere(at(0.3 + g / size[1], 0.3, 0.5), "[-0.3, 0.05, 0.0]", 2) ",")
    put(sphere(at(0.7, 0.6 - g / size[2], 0.5), "[0.0, 0.3, 0.02]", 3) ",")
    put(sphere(at(0.7, 0.6 + g / size[2], 0.5), "[0.0, -0.3, 0.0]", 4) ",")
    put(sphere(at(0.07, 0.7, 0.5), "[-0.5, 0.0, 0.0]", 5) ",")
    put(sphere(at(0.5, 0.06, 0.5), "[0.0, -0.5, 0.0]", 6) (on("bodies") ? "" : ","))
    if (!on("bodies")) # which are there
        put(sphere(at(0.5, 0.6 + (d + 2e-4) / size[2], 0.5), "[0.0, -0.5, 0.0]", 3))
    put("  );")
}

function put_particles_there() {
    if (is("count", "few")) put_few()
    if (is("count", "one"))
        put("  place = ( " sphere(at(0.5, 0.07, 0.5), "[0.1, -0.4, 0.0]", 3) " );")
    if (is("count", "none"))
        put("  bed = { count = 0; " sized() " };")
    if (is("count", "sixty"))
        put("  bed = { count = " 60 * l ^ 3 "; " sized() " settle = 0.0; };")
    if (is("count", "settled"))
        put("  bed = { count = " 40 * l ^ 3 "; " sized() " settle = 0.01; jitter = 1.0; };")
    if (is("count", "crowd"))
        put("  bed = { count = " 1100 * l ^ 3 "; " sized() " seed = 2; settle = 0.0; };")
}

function place(a, b, c,    w) {
    w = at(a, b, c)
    gsub(/[\[\],]/, "", w)
    return w
}

function put_list(to, c) {
    print place(0.2, 0.8, c), d >to
    print place(on("bodies") && !is("mesh", "sheared") ? 0.88 : 0.6, 0.85, c), d >to
    close(to)
}

function put_insert() {
    if (!on("insert")) return
    if (is("insert", "file moved")) {
        put_list(folder "/" name ".spheres", is("insert", "file") ? 0.5 : -0.5)
        put("  insert = ( { file = \"" name ".spheres\"; " \
            (is("insert", "moved") ? "offset = " vec(0, 0, size[3]) "; " : "") "} );")
        return
    }
    put("  insert = ( { " sized() " velocity = [0.0, -0.2, 0.0];" \
        " from = " at(0.1, 0.75, 0.1) "; to = " vec(0.9 * size[1], 0.97 * size[2], 0.9 * size[3]) "; " \
        (is("insert", "once") ? "count = " 5 * l ^ 3 ";" : \
         is("insert", "mass") ? "count = " 50 * l ^ 3 "; mass_rate = 2e-3; seed = 2;" : "count = " 50 * l ^ 3 "; rate = " real(4000 * l ^ 3) ";") \
        (is("insert", "late") ? " start = 1e-3;" : "") \
        (is("materials", "several") ? " material = \"felt\";" : "") " } );")
}

function put_sinks(    a, b) {
    a = "{ side = \"bottom\"; }"
    b = "{ from = [0.0, 0.0, 0.0]; to = " vec(size[1], 0.3 * size[2], size[3]) "; }"
    if (is("sinks", "bottom")) put("  sinks = ( " a " );")
    if (is("sinks", "left")) put("  sinks = ( { side = \"left\"; } );")
    if (is("sinks", "region")) put("  sinks = ( " b " );")
    if (is("sinks", "both")) put("  sinks = ( " a ", " b " );")
}

function put_driven() {
    if (is("driven", "line"))
        put("  prescribed = ( { id = 0; velocity = [0.1, 0.0, 0.0]; from = 4e-4; } );")
    if (is("driven", "swing"))
        put("  prescribed = ( { id = 0; amplitude = [0.0, 1e-4, 0.0]; frequency = 200.0; } );")
    if (is("driven", "circle"))
        put("  prescribed = ( { id = 0; centre = " at(0.5, 0.5, 0.5) "; spin = [0.0, 0.0, 20.0]; until = 1e-3; } );")
}

function put_surface() {
    if (!on("surface")) return
    put("  surfaces = ( { name = \"extra\"; ")
    if (is("surface", "plane"))
        put("shape = \"plane\"; point = " vec(0, 0.99 * size[2], 0) "; normal = [0.0, -2.0, 0.0];")
    if (is("surface", "cylinder"))
        put("shape = \"cylinder\"; particles = \"outside\"; radius = 2e-4; axis = [0.0, 0.0, 2.0]; point = " at(0.5, 0.6, 0.5) ";")
    if (is("surface", "stl moving turning loaded"))
        put("shape = \"stl\"; file = \"sheet.stl\"; scale = 1e-3; point = " at(0.5, 0.6, 0.5) ";")
    if (is("surface", "moving"))
        put("velocity = [0.01, 0.0, 0.0]; amplitude = [0.0, 2e-4, 0.0]; frequency = 100.0; from = 2e-4;")
    if (is("surface", "turning"))
        put("spin = [0.0, 10.0, 0.0]; centre = " at(0.5, 0.6, 0.5) "; until = 1e-3;")
    if (is("surface", "loaded"))
        put("load = [0.0, -1e-3, 0.0]; load_speed = 0.02;")
    if (is("surface", "cylinder stl turning loaded"))
        put("hardness = 1e8; cutting = 0.5; archard = 0.02;")
    put((is("materials", "pairs several") ? "material = \"felt\"; " : "") "} );")
}

function put_particles() {
    d = is("count", "crowd") ? 4e-4 : 1e-3
    l = on("parcel") ? 2 : 1
    grain = d / l
    put("particles = {")
    put("  step = " (is("count", "crowd") ? 2.5e-6 : 1e-5) / (on("clumps") ? 2 : 1) ";")
    if (is("particles.integrator", "adaptive-heun")) put("  shortest_step = 1e-6;")
    if (on("parcel"))
        put("  parcel = { grains = 8; restitution = \"" v["parcel"] "\"; };")
    if (on("clumps"))
        put("  clumps = ( { name = \"egg\"; half_axes = " vec(0.54 * d, 0.4 * d, 0.4 * d) "; balls = 3; share = 2.0; } );")
    put_materials()
    put_sizes()
    put_particles_there()
    put_insert()
    put_sinks()
    put_driven()
    put_surface()
    put("};")
}

function put_averaging() {
    put("averaging = {")
    put(is("width", "delta_05") ? "  delta_05 = 0.006;" : "  bandwidth = 0.004;")
    if (is("width", "cells grains")) put("  bandwidth_variation = \"" v["width"] "\";")
    if (is("width", "regions"))
        put("  regions = ( { low = [0.0, 0.0, 0.0]; high = " at(0.5, 0.5, 0.5) "; bandwidth = 0.002; } );")
    # What the iterations leave is a share of k u, and exchange_residual a share
    # of k (u - v), which was seen to be twenty times less.
    if (is("averaging.method", "diffusion")) put("  tolerance = 1e-8;")
    if (on("effects.saffman") && on("effects.magnus")) put("  gradient_bandwidth = 0.005;")
    put("};")
}

# The laws and shapes that are no choice of their own, one after the other.
function put_exchange(    n) {
    n = split(values_of("exchange.drag", "syamlal-obrien gidaspow schiller-naumann beetstra"), word, " ")
    if (is("drag", "another")) v["drag"] = word[1 + n_cases % n]
    put("exchange = { drag = \"" v["drag"] "\";")
    n = split(values_of("exchange.shape"), word, " ")
    if (on("clumps")) put("  shape = \"" word[1 + n_cases % n] "\";")
    put("};")
}

function put_attraction(name, asks,    n, group) {
    if (!is("cohesion", name " all")) return
    n = split(effect("effects." name, asks), group, " ")
    put("  " name " = " group[is("cohesion", "all") ? n : 2] ";")
}

function put_effects() {
    put("effects = {")
    if (is("gravity", "down")) put("  gravity = [0.0, -9.81, 0.0];")
    if (is("gravity", "oblique")) put("  gravity = [3.0, -8.0, 2.0];")
    put_attraction("electrostatic", "range=5e-4;")
    put_attraction("van_der_waals", "hamaker=1e-19;range=1e-5;")
    put_attraction("capillary", "tension=0.01;range=5e-5;")
    put("};")
}

# Each direction of a profile, and each of its two places.
function course(i) {
    if (i == 1) return "z = " 0.4 * size[3]
    if (i == 2) return "height = 1e-3; measured = ((0.001, 0.5), (0.002, 0.6))"
    if (i == 3) return "along = \"y\"; z = " 0.4 * size[3]
    if (i == 4) return "along = \"y\"; x = " 0.4 * size[1]
    if (i == 5) return "along = \"z\"; x = " 0.4 * size[1]
    return "along = \"z\"; height = 1e-3"
}

function put_output(    h, p, i, n, f) {
    put("output = { end = " 10 * step "; every = " (is("every", "each") ? step : 10 * step) ";")
    h = is("history", "each") ? step : is("history", "second") ? 2 * step : 20 * step
    if (letter != "p") put("  history = " h ";")
    n = split(is("exchange.coupling", "two-way") ? "eps_f p u_x eps_s us_y" : "eps_f p u_y", f, " ")
    if (on("profiles")) {
        put("  profiles = (")
        for (i = 1; i <= n; i++)
            put("    { field = \"" f[i] "\"; " course(i % 6 + 1) "; from = 1e-3; }" (i < n ? "," : ""))
        put("  );")
    }
    if (on("probes")) {
        put("  probes = (")
        for (i = 1; i <= n; i++)
            put("    { field = \"" f[i] "\"; position = " at(0.5, 0.15 * i, 0.5) "; }" (i < n ? "," : ""))
        put("  );")
    }
    if (on("forces"))
        put("  forces = ( { name = \"walls\"; velocity = 0.2; area = 1e-4; length = 0.012; " \
            "drag = [0.0, 1.0, 0.0]; lift = [1.0, 0.0, 0.0]; axis = [0.0, 1.0, 1.0]; }" \
            (on("surface") ? ", { surfaces = \"extra\"; centre = " at(0.1, 0.2, 0.3) "; }" : "") \
            " ); walls = true;")
    if (on("contacts")) put("  contacts = true;")
    if (v["shown"] == "all")
        put("  sorted = true; particles = \"mass material contact_force contact_number" \
            (letter == "c" ? " fluid_force" : "") "\";")
    if (on("statistics"))
        put("  statistics = { from = " 3 * step "; blocks = 2;" \
            (letter == "c" ? " lags = " 4 * step "; plateau = " step ";" : "") " };")
    put("};")
}

function use_row(why,    k) {
    for (k in v) delete v[k]
    line = ""
    for (k = 1; k <= n_names; k++) {
        v[names[k]] = value[k, row[k]]
        line = line " " names[k] "=" v[names[k]]
    }
    name = sprintf("%s-%03d", letter, ++n_cases)
    file = folder "/" name ".cfg"
    step = 2e-4
    print name line (why != "" ? " # " why : "") >>(folder "/list")
    put("title = \"" name "\";")
    put_mesh()
    if (letter != "p") put_fluid()
    if (on("bodies")) put_bodies()
    if (letter != "f") { put_particles(); put_effects() }
    if (letter ~ /[cm]/) { put_averaging(); put_exchange() }
    put_output()
    close(file)
    print other_keys() >(folder "/" name ".set")
    close(folder "/" name ".set")
}

BEGIN {
    state = seed
    exit cover() > 0
}

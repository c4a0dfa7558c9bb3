# What must hold of history.csv, whatever the case is. Prints what does not.
#
#   awk -F, -v line="NAME choice=value ..." -f verdict.awk history.csv

function wrong(what) { print "row " FNR - 1 ": " what }

# The column of this name, as a number; a table without it counts as fallback.
function get(name, fallback) { return name in col ? $col[name] + 0 : fallback }

function size(name) {
    return sqrt(get(name "_x", 0) ^ 2 + get(name "_y", 0) ^ 2 + \
                get(name "_z", 0) ^ 2)
}

FNR == 1 {
    for (i = 1; i <= NF; i++) { split($i, part, " "); col[part[1]] = i }
    next
}

{
    for (i = 1; i <= NF; i++)
        if ($i !~ /^-?[0-9]+(\.[0-9]*)?(e[-+]?[0-9]+)?$/)
            wrong("no finite number in column " i ": " $i)
}

# What a step leaves of continuity is 1e-8, fluid.tolerance, of what its pressure
# was asked to mend: of the flow of this step or, where that comes to rest, of
# the one before. Where nothing flows there is nothing to compare with.
{ flow = get("max_cfl", 0) }
flow > 1e-6 && get("mass_residual", 0) * flow > \
               1e-6 * (flow > before ? flow : before) {
    wrong("mass_residual " get("mass_residual", 0))
}
{ before = flow }

# Momentum of the fluid changes by forces: to rounding, over the sum of their
# sizes. In the step in which a fluid at rest begins to move an explicit drag
# has paid nothing yet, and nothing is compared with nothing. What is nearly
# still adds up to less than its parts: up to 2e-10 was seen; a force that is
# lost is 1e-3 and more.
moved && get("momentum_residual", 0) > 1e-8 {
    wrong("momentum_residual " get("momentum_residual", 0))
}
{ moved = get("kinetic_energy_fluid", 0) > 1e-25 }

# Gathering is the adjoint of spreading: to rounding, or where diffusion is
# solved by iteration to averaging.tolerance, 1e-8 of the fluid's velocity: of
# the slip that is up to a hundred times more.
get("exchange_residual", 0) > (line ~ /=diffusion/ ? 1e-6 : 1e-12) {
    wrong("exchange_residual " get("exchange_residual", 0))
}

# eps_f is one less what the particles take: no rounding beyond 1.
"eps_f_lowest" in col && !(get("eps_f_lowest", 1) > 0 && \
                           get("eps_f_lowest", 1) <= 1) {
    wrong("eps_f " get("eps_f_lowest", 1))
}

# The first row is of the start: nobody has gone, and who comes at t = 0 is there.
FNR == 2 { start = get("particles", 0) - get("particles_in", 0) }
"particles" in col && get("particles", 0) != \
        start + get("particles_in", 0) - get("particles_out", 0) {
    wrong("particles: " get("particles", 0) " are not " start " + " \
          get("particles_in", 0) " - " get("particles_out", 0))
}
(get("particles_in", 0) > 0) != (get("mass_in", 0) > 0) ||
        (get("particles_out", 0) > 0) != (get("mass_out", 0) > 0) {
    wrong("particles come or go without a mass, or a mass without them")
}

# In a closed periodic box momentum changes by what comes and goes, and by what
# averaging moves between cells. The scale is that of the particles: a
# milligram of them with their energy; a contact that one of two does not feel
# is 1e-2 of it and more, and what iterations leave of the diffusion, 1e-6 of
# the unpaid impulse, less than 1e-9.
line ~ /^m/ {
    scale = 0
    sum = 0
    for (k = 1; k <= 3; k++) {
        axis = substr("xyz", k, 1)
        now = get("momentum_" axis, 0) - get("momentum_brought_" axis, 0)
        if (FNR == 2) first[k] = now
        sum += (now - first[k]) ^ 2
    }
    energy = get("kinetic_energy_particles", 0)
    most = energy > most ? energy : most
    if (sqrt(sum) > 1.000001 * get("relabelled_momentum", 0) + \
            1e-7 * sqrt(2e-6 * most))
        wrong("momentum is off by " sqrt(sum) " N s")
}

END { if (FNR < 2) print "history.csv has no rows" }

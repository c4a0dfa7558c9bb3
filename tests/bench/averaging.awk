# The tables of tests/bench/averaging.sh, from `name value` lines of four meshes.
function part(name, m) { return v[name, m] / whole[m] * 100 }

function over(t, o) { return o == 0 ? "-" : sprintf("%.2f", t / o) }

$1 == "cells" { mesh++ }
$1 == "copies" { if (!many) many = mesh } # the meshes end here
{ v[$1, mesh] = $2 }

function by_the_sphere(first, last,  m, n) {
    print "# cells  spheres   kernel, 2.5 cells   dpvm"
    for (m = first; m <= last; m++) {
        n = v["spheres", m] * 1e-9
        printf "%7d %8d %12.0f %12.0f\n", v["cells", m], v["spheres", m],
            (v["kernel", m] + v["kernel-bind", m]) / n, (v["dpvm", m] + v["dpvm-bind", m]) / n
    }
}

END {
    all_of_them = mesh
    if (many) mesh = many
    split("12 5 2 1", cfd); split("26 27 25 27", dem); split("14.8 6.4 2.8 1.5", cg)
    print "# seven fields: ms, over our step of the fluid, over that of icoFoam"
    print "# cells  a cell   fluid icoFoam  exponential          series" \
        "               Crank-Nicolson 3      hosts   pcm"
    for (m = 1; m <= mesh; m++) {
        f = v["fluid", m]
        o = v["icofoam", m]
        printf "%7d %5.1f %8.1f %7.1f", v["cells", m],
            v["spheres", m] / v["cells", m], 1e3 * f, 1e3 * o
        split("exponential series crank-nicolson", way)
        for (k = 1; k <= 3; k++) {
            t = v[way[k], m] - v["pcm", m]
            printf "  %6.1f %5.2f %5s", 1e3 * t, t / f, over(t, o)
        }
        printf " %6.1f %5.1f\n", 1e3 * v["pcm-bind", m], 1e3 * v["pcm", m]
        whole[m] = f + v["particles", m] + v["averaging", m] + v["exchange", m]
    }
    print "\n# one step of the whole: parts in per cent, then those of SX15 Table 3"
    print "# cells  fluid  particles  averaging  the rest    CFD  DEM  coarse graining"
    for (m = 1; m <= mesh; m++) {
        all = (cfd[m] + dem[m] + cg[m]) / 100
        printf "%7d %6.1f %9.1f %10.1f %9.1f  %5.0f %4.0f %6.0f\n", v["cells", m],
            part("fluid", m), part("particles", m), part("averaging-all", m),
            part("averaging", m) + part("exchange", m) - part("averaging-all", m),
            cfd[m] / all, dem[m] / all, cg[m] / all
    }
    print "\n# ns a sphere to find its cells and spread seven fields: coarser meshes, then"
    print "# the coarsest one with two, four and eight of the bed side by side"
    by_the_sphere(mesh + 1, all_of_them)
}

#!/bin/sh
# Long runs of the resolved bodies: spheres in a cubic array at three solid
# fractions and four resolutions, the drag against the step with each method, the
# falls of [Cate02], and light and heavy spheres. About an hour on one core, of which the falls are most.
#
#   sh tests/validate/resolved.sh build/winnow [PART...]
#
# Writes figures/24/24-*.txt and fails where a band is left.
. "$(dirname "$0")/runs.inc"
[ $# -gt 0 ] || set -- arrays methods places falls courses densities

pi=3.14159265358979

# NAME CASE OVERRIDES...
run() {
    to=$out/$1 scene=$2
    shift 2
    winnow run "$scene" -o "$to" --quiet "$@" >"$to.log" 2>&1 || {
        tail -n 3 "$to.log" >&2
        exit 1
    }
}

# FORMAT EXPRESSION
calc() { awk "BEGIN { pi = $pi; printf(\"$1\", $2) }"; }

# PROGRAM RUN/TABLE VARIABLE=VALUE...: awk on the rows of a table of a run; at[NAME] is the
# number of a column.
rows() {
    program=$1 table=$out/$2
    shift 2
    awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) { split($i, w, " "); at[w[1]] = i } next }'"$program" \
        pi=$pi "$@" "$table"
}

# SOLID CELLS VN END OVERRIDES...: the drag over that of Stokes, after END [s] and
# 120 steps at least
drag() {
    solid=$1 cells=$2 vn=$3
    step=$(calc %.9g "$vn / ($cells * $cells)")
    end=$(calc %g "120 * $step > $4 ? 120 * $step : $4")
    shift 4
    d=$(calc %.6f "exp(log(6 * $solid / pi) / 3)")
    run array cases/sphere-array.cfg -s "mesh.cells=[$cells,$cells,$cells]" \
        -s "fluid.step=$step" -s "output.end=$end" -s "output.every=$end" \
        -s "bodies.spheres.0.diameter=$d" "$@"
    rows '{ F = $at["force_on_bodies_x"]; U = $at["mean_flow_x"] }
        END { printf "%.4f", F / (3 * pi * d * U) }' array/history.csv d="$d"
}

# [ZH82] Table: solid fraction, drag; then the time to become steady.
arrays() {
    echo "# solid  cells  d/h     drag      [ZH82]  error %"
    while read -r solid exact end list; do
        for n in $list; do
            found=$(drag "$solid" "$n" 1 "$end")
            calc '%7s %6d %6.2f %9s %9s %8.2f\n' "$solid, $n, $n * exp(log(6 * $solid / pi) / 3), \"$found\", \"$exact\", 100 * ($found / $exact - 1)"
        done
        echo
        echo
    done <<TABLE
0.064 2.810 0.8 16 24 32
0.216 7.442 0.4 11 16 22 32
0.45 28.1 0.15 8 12 17 24
TABLE
}

# A step of nu dt / h^2 = VN, 12 cells in a diameter.
methods() {
    echo "# nu dt / h^2, drag over that of [ZH82]: hold, fictitious-domain, piso-ib"
    for vn in 0.03 0.1 0.3 1 3 10; do
        printf '%5s' $vn
        end=$(calc %g "$vn > 3 ? 0.8 : 0.3")
        for method in hold fictitious-domain piso-ib; do
            found=$(drag 0.216 16 $vn "$end" -s bodies.method=$method -s fluid.time=euler)
            calc ' %8.4f' "$found / 7.442"
        done
        echo
    done
}

# The sphere moved by a third of a cell in eight directions, in two arrays.
places() {
    echo "# solid fraction, shift of the sphere in cells: x, y, z; drag over that of [ZH82]"
    while read -r solid exact end n; do
        for x in 0 0.333; do for y in 0 0.333; do for z in 0 0.333; do
            at=$(calc '[%.7f,%.7f,%.7f]' "0.5 + $x / $n, 0.5 + $y / $n, 0.5 + $z / $n")
            found=$(drag "$solid" "$n" 1 "$end" -s "bodies.spheres.0.position=$at")
            calc '%6s %6s %6s %6s %8.4f\n' "$solid, $x, $y, $z, $found / $exact"
        done; done; done
    done <<TABLE
0.216 7.442 0.2 16
0.45 28.1 0.15 12
TABLE
}

# The same array with a sphere that is free: a mean gradient carries its weight, and the
# drag is that of the slip. Density ratios, with 8 cells in a diameter; ten seconds.
carried() {
    echo "# rho_p/rho  velocity of the sphere, mean flow, slip over nu/d; drag over that of Stokes, of one that is held"
    held=$(drag 0.064 16 1 0.8 -s "bodies.spheres.0.position=[0.53,0.5,0.47]")
    for ratio in 0.2 3 20; do
        gradient=$(calc %.12g "-($ratio - 1) * 0.064e-6")
        run carried cases/sphere-array.cfg -s fluid.step=0.00390625 -s fluid.tolerance=1e-8 \
            -s "fluid.mean_gradient=[$gradient,0.0,0.0]" -s output.end=0.8 -s output.every=0.8 \
            -s fluid.piso_tolerance=1e-4 -s effects.gravity=[-1e-6,0.0,0.0] \
            -s bodies.spheres.0.position=[0.53,0.5,0.47] -s bodies.spheres.0.diameter=0.496285 \
            -s 'bodies.spheres.0.motion="free"' -s bodies.spheres.0.density=$ratio
        rows '{ U = $at["mean_flow_x"] } END { print U }' carried/history.csv |
            { read -r U && rows '{ v = $6 }
            END { d = 0.496285; printf "%5s %11.3e %11.3e %11.3e  %.4f %s\n", r, v * d, U * d, (U - v) * d,
                         (r - 1) * 0.064e-6 / (3 * pi * d * (U - v)), held }' carried/bodies.csv r=$ratio held="$held" U="$U"; }
    done
}

# [Cate02] Table: density and viscosity of the oil, largest velocity measured.
falls() {
    echo "# case  cells/d  step [s]  largest velocity  measured [m/s]  error %"
    while read -r name rho mu measured end step; do
        for cells in "30,48,30 4.5" "50,80,50 7.5"; do
            mesh=${cells% *} per=${cells#* }
            once "fall-$name-$per" cases/falling-sphere.cfg -s "mesh.cells=[$mesh]" \
                -s "fluid.density=$rho" -s "fluid.viscosity=$mu" \
                -s "fluid.step=$step" -s "output.end=$end" -s output.every=10
            rows '-$7 > most { most = -$7 }
                END { printf "%6s %8s %9s %12.5f %15s %11.2f\n", name, per, dt, most, U, 100 * (most / U - 1) }' \
                "fall-$name-$per/bodies.csv" name="$name" per="$per" dt="$step" U="$measured"
            rows 'NR % 4 == 2 { printf "%.3f %.6f %.5f\n", $1, $4 - 0.0075, $7 }' \
                "fall-$name-$per/bodies.csv" >"$out/fall-$name-$per.course"
        done
    done <<TABLE
E1 970 0.373 0.0360 2.4 0.008
E2 965 0.212 0.0572 2.0 0.008
E3 962 0.113 0.0873 1.5 0.006
E4 960 0.058 0.1222 1.4 0.004
TABLE
}

# The courses of the falls at 7.5 cells, which must be there.
courses() {
    for name in E1 E2 E3 E4; do
        printf '# %s: time [s], gap to the floor [m], velocity [m/s]\n' $name
        cat $out/fall-$name-7.5.course
        printf '\n\n'
    done
}

# Density ratios from 0.01 to 100: the velocity after the same fall or rise.
densities() {
    echo "# rho_p/rho  step [s]  velocity at 0.2 s and 0.4 s [m/s]"
    for ratio in 0.01 0.1 0.5 1.02 1.17 8 100; do
        for step in 0.008 0.002; do
            rho=$(calc %g "960 * $ratio")
            g=$(calc %.4f "$ratio > 1 ? -1.6 / ($ratio - 1) : -1.6 / (1 - $ratio)")
            run density cases/falling-sphere.cfg -s "mesh.cells=[24,38,24]" \
                -s "fluid.step=$step" -s output.end=0.4 -s output.every=10 \
                -s "effects.gravity=[0.0,$g,0.0]" -s "bodies.spheres.0.density=$rho" \
                -s "bodies.spheres.0.position=[0.05,0.08,0.05]"
            rows '$1 < 0.2001 { half = $7 } END { printf "%8s %9s %10.5f %10.5f\n", r, dt, half, $7 }' \
                density/bodies.csv r="$ratio" dt="$step"
        done
    done
}

# NAME GRAINS CELLS STEP SEED MATERIAL BODIES REST: EW18's grains at random places of a
# periodic box of so many cells, PER in each diameter (12), in units of d, u_in and the
# density of the fluid; carried by the mean gradient. MATERIAL is what each has instead of
# a density of 10. The viscosity and the weight of a volume are those of the liquid.
nu=0.125 weight="9 * 6.046875"
periodic() {
    name=$1 n=$2 c=$3
    L=$(calc %.6f "$c / ${PER:-12}")
    awk -v n="$n" -v L="$L" -v seed="$5" -f tests/validate/suspension.awk |
        sed "s/density = 10.0/$6/" >"$out/$name.spheres"
    cat >"$out/$name.cfg" <<CASE
title = "$name";
mesh = { size = [$L, $L, $L]; cells = [$c, $c, $c]; periodic = [true, true, true]; };
fluid = { density = 1.0; viscosity = $nu; step = $4; time = "bdf2"; convection = "linear"; tolerance = 1e-6;
  mean_gradient = [0.0, $(calc %.9g "-$weight * $n * pi / 6 / ($c / ${PER:-12}) ^ 3"), 0.0]; };
bodies = { $7 spheres = (
@include "$name.spheres"
  ); };
$8
CASE
    once "$name" "$out/$name.cfg"
}

# LAW EPS RE FORMAT: the whole force on such grains over that of the law
over_law() {
    F=$(winnow eval "drag:$1" eps_f="$2" Re="$3" | awk '{ print $3 }')
    calc "$4" "$weight * pi / 6 / (3 * pi * $nu * $3 * $nu / $2 * $F)"
}

# NAME FROM
samples() {
    awk -F, -v nu=$nu -v from="$2" -f tests/validate/samples.awk "$out/$1/history.csv" "$out/$1/bodies.csv"
}

# NAME: the drag on grains that are resolved; of each line of the input the grains, cells,
# step and end of a box. With numbers of grains in the environment, GRAINS="97 52", only
# those boxes are computed, and the others keep the rows that they have.
boxes() {
    part_of=$1
    echo "# eps  whole force over Beetstra's, Di Felice's of 1994, and as EW18 prints it; then as tests/validate/samples.awk says"
    while read -r n cells step end; do
        case " ${GRAINS:-$n} " in
        *" $n "*) ;;
        *)
            awk -v n="$n" '!/^#/ && $(NF - 1) == n' "figures/24/24-$part_of.txt"
            continue
            ;;
        esac
        name=$part_of-$n-$cells
        periodic "$name" "$n" "$cells" "$step" 1 "density = 10.0" \
            "filter = 2.0; stiffness = 30000.0; restitution = 0.9; friction = 0.3; virtual_mass = 0.5;" \
            "effects = { gravity = [0.0, -6.046875, 0.0]; }; output = { end = $end; every = $end; };"
        found=$(samples "$name" 6)
        eps=$(calc %.5f "1 - $n * pi / 6 / ($cells / 12) ^ 3")
        ratios=
        for law in beetstra di-felice di-felice-printed; do
            ratios="$ratios $(over_law $law "$eps" "${found%% *}" %.3f)"
        done
        echo "$eps $ratios  $found"
    done
}

# At four fluid fractions: an hour.
suspension() {
    boxes suspension <<TABLE
97 56 0.010 16
95 60 0.008 9.72
52 54 0.008 10.4
35 54 0.008 12
TABLE
}

# EW18's gas (density ratio 85, Re_in = 25): 22 and 18 grains in boxes of three diameters,
# the smallest that have what Figs. 6b, 8b, 10 and 12b show. Their sigma of this gas beside
# ours. Ten minutes; the blocks of the figures go to 24-gas-GRAINS.txt.
gas() {
    nu=0.04 weight="84 * 0.49"
    echo "# eps  whole force over Beetstra's, Di Felice's of 1994, and as EW18 prints it; then as"
    echo "# tests/validate/samples.awk says; sigma(C_d), and the line of EW18's authors from Re_p 16.5 to 28"
    for n in 22 18; do
        periodic gas-$n $n 36 0.008 1 "density = 85.0" \
            "filter = 2.0; stiffness = 255000.0; restitution = 0.9; friction = 0.3; virtual_mass = 0.5;" \
            "effects = { gravity = [0.0, -0.49, 0.0]; }; output = { end = 16.0; every = 16.0; history = 0.008; picture = false; };"
        found=$(samples gas-$n 8)
        eps=$(calc %.5f "1 - $n * pi / 6 / 27")
        for law in beetstra di-felice di-felice-printed; do
            eps="$eps $(over_law $law "${eps%% *}" "${found%% *}" %.3f)"
        done
        echo "$eps  $found" | awk '{ printf "%s  %.2f %s\n", $0, $11 * $12,
            $6 < 30 ? sprintf("%.2f", 43.9 - 27.9 * ($6 - 16.54) / 11.46) : "beyond 28" }'
        { made gas; awk -F, -v from=8 -v nu=$nu -v box=1 -v weight="$(calc %.9g "$weight * pi / 6")" \
            -f tests/validate/drag-samples.awk $out/gas-$n/bodies.csv; } >figures/24/24-gas-$n.txt
        laws figures/24/24-gas-$n.txt >>figures/24/24-gas-$n.txt
    done
}

# What the mesh makes of the drag on each of 22 grains that are held at random places of a
# periodic box, in a flow of Re = 8: 8, 12 and 16 cells in a diameter. A minute; with
# CELLS="8 12 16 24" in the environment three.
frozen() {
    list=${CELLS:-8 12 16}
    for c in $list; do
        PER=$c periodic frozen-$c 22 $((3 * c)) 0.01 1 'motion = "fixed"' "" \
            "output = { end = 1.5; every = 1.5; history = 0.5; picture = false; };"
    done
    echo "# cells in d, Re of the flow after 1 and 1.5, whole force over Beetstra's; of the forces on the single grains the"
    echo "# deviation, and the root mean square of what differs from those of the last row, both over their mean"
    eps=$(calc %.5f "1 - 22 * pi / 6 / 27")
    for c in $list; do
        Re=$(rows '{ before = now; now = $at["mean_flow_y"] / 0.125 } END { printf "%.4f %.4f", before, now }' frozen-$c/history.csv)
        ratio=$(over_law beetstra "$eps" "${Re#* }" %.4f)
        awk -F, -v c=$c -v Re="$Re" -v ratio="$ratio" '
            FNR == 1 { file++; next }
            $1 < 1.499 { next }
            file == 1 { best[$2] = $13; next }
            { n++; s += $13; q += $13 ^ 2; e += ($13 - best[$2]) ^ 2 }
            END { m = s / n; printf "%2d  %s  %s  %.4f %.4f\n", c, Re, ratio, sqrt(q / n - m * m) / m, sqrt(e / n) / m }' \
            "$out/frozen-${list##* }/bodies.csv" $out/frozen-$c/bodies.csv
    done
}

# RATIO SEED MATERIAL STEP END FROM: 22 grains in a periodic box of 3 d, under the weight of
# EW18's liquid bed whatever the ratio of the densities is. Prints this and the Stokes
# number, then what stands above `boxes` without the laws.
stokes_row() {
    name=stokes-$1-$2 stiffness='' gravity=''
    [ "$1" = 1 ] || {
        stiffness="stiffness = $(calc %.9g "3000 * $1");"
        gravity="effects = { gravity = [0.0, $(calc %.9g "-9 * 6.046875 / ($1 - 1)"), 0.0]; };"
    }
    periodic "$name" 22 36 "$4" "$2" "$3" "filter = 2.0; restitution = 0.9; friction = 0.3; virtual_mass = 0.5; $stiffness" \
        "$gravity output = { end = $5; every = $5; history = $4; picture = false; };"
    # shellcheck disable=SC2046 # words
    set -- "$1" "$2" $(samples "$name" "$6")
    Re=$3
    calc '%4s %7.2f  %d  %.3f  %.3f  %.3f  %.3f %.3f\n' "$1 == 1 ? \"held\" : $1, $1 == 1 ? 0 : $1 * $Re / 18, $2, $Re,
        $(over_law beetstra 0.57335 "$Re" %.9f), $7 / $6, ${13}, ${14}"
}

# Does a grain that is free bear what one bears that is held? Held at random places of eight
# seeds; and, for two of them, with three ratios of the densities, and so of the Stokes
# number, under the same weight. Half an hour.
stokes() {
    echo "# rho_r  St  seed  Re of the slip  whole force over Beetstra's  sigma(C_d)/C_d  roots of the granular temperature along, across"
    for seed in 1 2 3 4 5 6 7 8; do
        stokes_row 1 $seed 'motion = "fixed"' 0.01 1.5 1.2
    done
    for seed in 1 2; do
        stokes_row 2 $seed "density = 2.0" 0.008 16 6
        stokes_row 10 $seed "density = 10.0" 0.008 16 6
        stokes_row 40 $seed "density = 40.0" 0.008 20 8
    done
}

# sigma(Re_p, eps) and the integral time for effects.stochastic_drag, from the samples of
# `suspension`. The error of sigma is that of so many samples that are 2 T apart.
coefficients() {
    awk '
        BEGIN { print "# eps  Re_p  C_d  sigma(C_d)  error  over C_d  T to the first zero, mean over 4 to 5 [d/u_in]; sigma by EW18s authors" }
        /^#/ { next }
        {
            eps = $7; Re = $6; C = $11; sigma = $11 * $12; dt = $17 == 97 ? 0.01 : 0.008
            error = sigma / sqrt(2 * $10 * dt / (2 * $13))
            printf "%.4f %6.2f %7.2f %6.2f %5.2f  %.3f  %.3f %.3f  %.2f\n", eps, Re, C, sigma, error, sigma / C, $13, $14, 512.875 * Re ^ -1.54919
            n++; x = log(Re); y = log(sigma); sx += x; sy += y; xx += x * x; xy += x * y; T += $13
            if (n == 1) low = Re
            high = Re
        }
        END {
            b = (n * xy - sx * sy) / (n * xx - sx * sx); a = exp((sy - b * sx) / n)
            printf "# sigma = %.1f Re_p^%.3f\n", a, b
            printf "# sigma_low = %.2f; Re_low = %.2f; sigma_high = %.2f; Re_high = %.2f; time = %.2f;\n", a * low ^ b, low, a * high ^ b, high, T / n
        }' figures/24/24-suspension.txt
}

# The rebound from a floor over the Stokes number, for rough and for smooth spheres:
# speed after over that before, at a tenth of the diameter above the floor, over the
# restitution of dry ones. Two minutes.
rebound() {
    echo "# roughness over R  St at 0.1 d  rebound over dry  exp(-35/St) of [Legendre05]"
    for rough in 1e-3 1e-5; do
        for st in 10 20 40 100 300 1000; do
            mu=$(calc %g "8 / 9 / $st")
            run rebound cases/rebound-in-oil.cfg -s "fluid.viscosity=$mu" \
                -s "bodies.roughness=$rough"
            rows '{ z = $4 - 0.5 }
                z > 0.1 && !near { u = -$7 }
                z < 0.05 { near = 1 }
                near && $7 > back { back = $7 }
                END { st = 8 * u / (9 * mu)
                      printf "%6s %7.2f %8.3f %8.3f\n", rough, st, back / u / 0.97, exp(-35 / st) }' \
                rebound/bodies.csv rough=$rough mu="$mu"
        done
    done
}

# A sphere without losses bounces off a wall in a thin fluid: the virtual mass adds nothing.
# Each density ratio, C_v, and steps that the impact lasts, by the mass with 1/2; half a
# minute.
impact() {
    echo "# rho_p/rho  C_v  steps of an impact  speed after over before"
    while read -r rho C n; do
        step=$(calc %g "0.04 / $n")
        stiffness=$(calc %g "($rho + 0.5) * pi * pi * pi / 6 / 0.0016")
        cat >$out/impact.cfg <<CASE
title = "An impact";
mesh = { size = [4.0, 4.0, 4.0]; cells = [24, 24, 24]; };
fluid = { density = 1.0; viscosity = 1e-4; step = $step; time = "bdf2"; convection = "upwind"; tolerance = 1e-6;
          sides = "slip"; front_back = "slip"; bottom = "slip"; top = "slip"; };
bodies = { restitution = 1.0; virtual_mass = $C; stiffness = $stiffness; lubrication = false;
           spheres = ( { position = [2.0, 0.6, 2.0]; diameter = 1.0; density = $rho.0; velocity = [0.0, -1.0, 0.0]; } ); };
output = { end = 0.2; every = 0.2; history = $step; };
CASE
        run impact $out/impact.cfg
        rows '$4 > 0.5 && $7 < 0 { before = -$7 }
            $4 > 0.5 && $7 > 0 && !after { after = $7 }
            END { printf "%6s %6s %4s %12.3f\n", r, C, n, after / before }' impact/bodies.csv r="$rho" C="$C" n="$n"
    done <<TABLE
8 0 8
8 0.5 8
8 2 8
8 8 8
8 2 4
8 2 16
4 0.5 8
4 2 8
20 0.5 8
20 2 8
TABLE
}

# NAME RHO_R V WIDTH BODIES: the added mass C_a of a body whose velocity the others are
# opposite to, from the changes D of its velocity after a kick:
# (rho_r + C_v) D_n+1 - (1 + C_v) D_n = (1 + C_a) (D_n-1 / 2 - 3 D_n / 2).
swing_row() {
    cat >$out/swing.cfg <<CASE
title = "A kick";
mesh = { size = [4.0, 4.0, 4.0]; cells = [32, 32, 32]; };
fluid = { density = 1.0; viscosity = 1e-5; step = 0.05; time = "bdf2"; convection = "upwind"; tolerance = 1e-8;
          sides = "slip"; front_back = "slip"; bottom = "slip"; top = "slip"; };
bodies = { virtual_mass = 0.0; lubrication = false; $5 };
output = { end = 0.6; every = 0.6; history = 0.05; };
CASE
    run swing $out/swing.cfg
    C=$(winnow check $out/swing.cfg | awk '/largest virtual mass/ { print $4 }')
    rows '$2 == 0 { v[++n] = $7 }
        END {
            for (i = 5; i < n; i++) {
                D = v[i] - v[i - 1]; x = 0.5 * (v[i - 1] - v[i - 2]) - 1.5 * D
                y = (r + C) * (v[i + 1] - v[i]) - (1 + C) * D
                xy += x * y; xx += x * x
            }
            printf "%-28s %5.2f %8.2f %8.2f %8.2f\n", name, r, C, 0.5 * sqrt(6 * V / pi / width ^ 3), xy / xx - 1
        }' swing/bodies.csv name="$1" r="$2" C="$C" V="$3" width="$4"
}

# What fluid a body that is kicked accelerates with it, alone and beside another one.
swing() {
    echo "# body, rho_r, C_v that it gets, its C_a by (24.11), and measured"
    V=0.5235988
    up='density = 1.0; velocity = [0.0, 0.001, 0.0];'
    down='density = 1.0; velocity = [0.0, -0.001, 0.0];'
    swing_row "sphere" 1 $V 1 "spheres = ( { position = [2.0, 2.0, 2.0]; diameter = 1.0; $up } );"
    swing_row "sphere, a cell from a wall" 1 $V 1 "spheres = ( { position = [2.0, 0.625, 2.0]; diameter = 1.0; $up } );"
    for z in 2 1 0.25; do
        swing_row "two spheres, gap $z h" 1 $V 1 "spheres = ( { position = [2.0, $(calc %g "2.5 + $z / 16"), 2.0]; diameter = 1.0; $up },
            { position = [2.0, $(calc %g "1.5 - $z / 16"), 2.0]; diameter = 1.0; $down } );"
    done
    swing_row "cube" 1 1 1 "boxes = ( { position = [2.0, 2.0, 2.0]; size = [1.0, 1.0, 1.0]; motion = \"free\"; $up } );"
    swing_row "rod, 1:2" 1 1.570796 1 "cylinders = ( { position = [2.0, 2.0, 2.0]; diameter = 1.0; length = 2.0; axis = [1.0, 0.0, 0.0]; motion = \"free\"; $up } );"
    plate='size = [1.5, 0.5, 1.5]; motion = "free";'
    swing_row "plate, 1:3" 1 1.125 0.5 "boxes = ( { position = [2.0, 2.0, 2.0]; $plate $up } );"
    swing_row "two plates, gap 1 h" 1 1.125 0.5 "boxes = ( { position = [2.0, 2.3125, 2.0]; $plate $up }, { position = [2.0, 1.6875, 2.0]; $plate $down } );"
}

# Sixteen spheres five times as heavy as the fluid settle on a floor: how nearly they come
# to rest. Half a minute.
pile() {
    echo "# rho_r  C_v of the case, that a sphere gets, cells in d; root of the mean square of the speed [m/s] after 6, 12, 18, 24 s"
    for how in "5 2 1" "5 0.5 1" "1.3 0.5 2" "0.1 2 2"; do
        # shellcheck disable=SC2086 # three words
        set -- $how
        awk -v rho="$1" -v C="$2" -v f="$3" 'BEGIN {
            printf "title = \"A pile\"; mesh = { size = [1.0, 1.6, 1.0]; cells = [%d, %d, %d]; };\n", 12 * f, 19 * f, 12 * f
            printf "fluid = { density = 1.0; viscosity = 0.02; step = %g; time = \"bdf2\";\n", 0.01 / f
            print "  sides = \"no-slip\"; bottom_top = \"no-slip\"; front_back = \"no-slip\"; };"
            printf "bodies = { virtual_mass = %g; spheres = (", C
            srand(3)
            for (y = 0.25; y < 1.4; y += 0.36) for (x = 0.25; x < 0.9; x += 0.42) for (z = 0.25; z < 0.9; z += 0.42)
                printf "%s{ position = [%.4f, %.4f, %.4f]; diameter = 0.33; density = %.1f; }", n++ ? ",\n" : "", x + 0.08 * rand(), y, z + 0.08 * rand(), rho
            printf " ); };\neffects = { gravity = [0.0, %.6f, 0.0]; };\n", -4 / (rho > 1 ? rho - 1 : 1 - rho)
            print "output = { end = 24.0; every = 24.0; history = 0.5; };"
        }' >$out/pile.cfg
        run pile $out/pile.cfg
        got=$(winnow check $out/pile.cfg | awk '/largest virtual mass/ { printf "%.2f", $4 }')
        awk -F, -v rho="$1" -v C="$2" -v got="$got" -v f="$3" 'NR > 1 { t = sprintf("%.1f", $1); sum[t] += $6 ^ 2 + $7 ^ 2 + $8 ^ 2; n[t]++ }
            END { printf "%4s %4s %5s %4.1f ", rho, C, got, 0.33 * 12 * f
                  for (t = 6; t < 25; t += 6) { k = sprintf("%.1f", t); printf " %8.5f", sqrt(sum[k] / n[k]) }
                  print "" }' $out/pile/bodies.csv
    done
}

# Drafting, kissing, tumbling: when the gap closes, and when the order has changed.
two() {
    run two cases/two-spheres-fall.cfg
    rows '$2 == 0 { x = $3; y = $4; z = $5; v = $7; next }
        { dx = $3 - x; dy = $4 - y; dz = $5 - z; gap = sqrt(dx * dx + dy * dy + dz * dz) - 1
          row = sprintf("%5.1f %8.3f %8.3f %7.3f %6.0f", $1, v, $7, gap, atan2(sqrt(dx * dx + dz * dz), dy) * 180 / pi)
          if (++n % 5 == 1) rows = rows row "\n"
          if (gap < 0.01 && !kiss) kiss = $1
          if (dy < 0 && !over) over = $1 }
        END { print "# time  velocity of the lower, of the upper one  gap  tilt [degrees]"
              printf "%s", rows
              printf "# they touch at %.1f; the upper one is ahead from %.1f on\n", kiss, over }' two/bodies.csv
}

# Fifty free spheres, carried as a whole by the mean gradient: the momentum of fluid
# and bodies, which is 0 at the start, for two tolerances of the pressure.
fifty() {
    awk 'BEGIN {
        srand(7)
        while (m < 50) {
            for (k = 0; k < 3; k++) x[m, k] = 5 * rand()
            for (j = ok = 0; j < m; j++) {
                for (k = r = 0; k < 3; k++) {
                    d = x[m, k] - x[j, k]; d -= 5 * (d > 2.5) - 5 * (d < -2.5); r += d * d
                }
                if (r < 1.1) break
            }
            if (j == m) m++
        }
        for (j = 0; j < m; j++)
            printf "%s{ position = [%.5f, %.5f, %.5f]; diameter = 1.0; density = %g; }\n",
                   j ? "," : "", x[j, 0], x[j, 1], x[j, 2], 2 + j % 3
    }' >$out/fifty.spheres
    gradient=$(calc %.12f "-99 * pi / 6 / 125")
    cat >$out/fifty.cfg <<CASE
title = "Fifty free spheres";
mesh = { size = [5.0, 5.0, 5.0]; cells = [30, 30, 30]; periodic = [true, true, true]; };
fluid = { density = 1.0; viscosity = 0.05; step = 0.04; time = "bdf2"; convection = "linear";
          mean_gradient = [0.0, $gradient, 0.0]; };
bodies = { stiffness = 3000.0; restitution = 0.9; friction = 0.3; spheres = (
@include "fifty.spheres"
); };
effects = { gravity = [0.0, -1.0, 0.0]; };
output = { end = 16.0; every = 16.0; history = 0.4; };
CASE
    echo "# tolerance  time  momentum_y over that of the bodies  rows with contacts  deepest overlap"
    for how in "1e-6 16" "1e-8 4"; do
        run fifty $out/fifty.cfg -s fluid.tolerance=${how% *} -s output.end=${how#* }
        awk -F, -v tolerance=${how% *} '
            FNR == 1 { file++ }
            file == 1 && FNR > 1 { v = $7 < 0 ? -$7 : $7; if ($1 > t) { t = $1; sum = 0 }
                                   sum += (2 + $2 % 3) * v * 3.14159265358979 / 6 }
            file == 2 && FNR == 1 { for (i = 1; i <= NF; i++) { split($i, w, " "); at[w[1]] = i } }
            file == 2 && FNR > 1 { if ($at["max_overlap_of_bodies"] > deep) deep = $at["max_overlap_of_bodies"]
                                   touched += $at["contacts_of_bodies"] > 0; P = $at["momentum_y"]; t = $1 }
            END { printf "%s %5.1f %10.2g %4d %8.4f\n", tolerance, t, P / sum, touched, deep }' \
            $out/fifty/bodies.csv $out/fifty/history.csv
    done
}

# NAME OVERRIDES...: a sphere of six grains in a narrow bed
narrow_bed() {
    to=$1
    shift
    run "bed-$to" cases/sphere-in-bed.cfg -s mesh.size=[0.014,0.028,0.014] \
        -s mesh.cells=[14,28,14] -s particles.bed.count=1500 \
        -s bodies.spheres.0.position=[0.007,0.007,0.007] \
        -s bodies.spheres.0.diameter=0.006 -s output.end=0.6 -s output.every=0.3 "$@"
}

# Light, as the bed, heavy: a minute.
bed() {
    echo "# density [kg/m^3]: height of the centre [mm] after 0, 0.1, ... 0.6 s"
    for rho in 1100 1700 2300; do
        narrow_bed $rho -s bodies.spheres.0.density=$rho
        printf '%s:' $rho
        rows '(NR - 2) % 100 == 0 { printf " %.2f", 1e3 * $4 } END { print "" }' "bed-$rho/bodies.csv"
    done
}

# The case itself, of ten grains: light, nearly as the bed, as the bed, heavy, and one that is
# held. Twelve minutes.
ten() {
    echo "# time [s], height of the centre [mm] of 1100, 1700, 1850, 2300 kg/m^3, twice the mean height of the grains"
    for rho in 1100 1700 1850 2300; do
        once ten-$rho cases/sphere-in-bed.cfg -s bodies.spheres.0.density=$rho \
            -s output.end=0.5 -s output.every=0.25 -s output.history=0.01
    done
    once ten-held cases/sphere-in-bed.cfg -s bodies.spheres.0.motion=fixed \
        -s output.end=0.5 -s output.every=0.25 -s output.history=0.01
    awk -F, '
        FNR == 1 { file++; for (i = 1; i <= NF; i++) { split($i, w, " "); at[w[1]] = i } next }
        file < 5 { y[file, sprintf("%.3f", $1)] = 1e3 * $4; next }
        { t = sprintf("%.3f", $1); H = 2e3 * $at["mean_height"]
          printf "%.2f %.3f %.3f %.3f %.3f %.2f\n", t, y[1, t], y[2, t], y[3, t], y[4, t], H }' \
        $out/ten-1100/bodies.csv $out/ten-1700/bodies.csv $out/ten-1850/bodies.csv \
        $out/ten-2300/bodies.csv \
        $out/ten-1700/history.csv
    echo "# held: time [s]; fluid, grains, sum over V g [kg/m^3]; as in the table of the held ones"
    for span in "0.2 0.0" "0.5 0.2"; do
        # shellcheck disable=SC2086 # two words
        { printf '# '; held_of ten-held 22 8000 0.018 0.010 $span; }
    done
}

# WIDTH COUNT VELOCITY END: a sphere of six grains that is held in the middle of a bed,
# 14 mm deep when it is packed; means from 0.6 s on, or over the second half.
held_in() {
    W=$1 n=$2 u=$3 end=$4 half=$(calc %g "$1 / 2000")
    run "held-$W-$u" cases/sphere-in-bed.cfg \
        -s "mesh.size=[0.0$W,0.032,0.0$W]" -s "mesh.cells=[$W,32,$W]" \
        -s "particles.bed.count=$n" -s "fluid.bottom.inlet=$u" \
        -s "bodies.spheres.0.position=[$half,0.0075,$half]" \
        -s bodies.spheres.0.diameter=0.006 -s bodies.spheres.0.motion=fixed \
        -s "output.end=$end" -s "output.every=$end"
}

# NAME WIDTH COUNT VELOCITY DIAMETER END FROM: what the fluid and the grains give it.
held_of() {
    rows '$1 > from && $1 < end + 1e-6 {
            n++; f += $at["force_on_bodies_y"]; g += $at["force_of_grains_y"]
            p += $at["pressure_drop"]; H += 2 * $at["mean_height"] }
        END { V = pi * D ^ 3 / 6; Vg = 9.81 * V
              eps = 1 - N * 3.14159265358979e-9 / 6 / (W * W * 1e-6 * H / n - V)
              printf "%2d %5s  %3.1f to %4.2f  %4.0f %4.0f %4.0f  %5.3f %4.0f   %5.2f %5.2f\n", W, u, from, end,
                     f / n / Vg, g / n / Vg, (f + g) / n / Vg, eps, 1500 * (1 - eps),
                     (f + g) / n / Vg / (1500 * (1 - eps)), f / n / V / (p / H) }' \
        "$1/history.csv" W="$2" N="$3" u="$4" D="$5" end="$6" from="$7"
}

# WIDTH COUNT VELOCITY END FROM
held_row() {
    held_of "held-$1-$3" "$1" "$2" "$3" 0.006 "$4" "$5"
}

# Beds of two widths, fluidized and packed: five minutes.
held() {
    echo "# width [mm], u [m/s], time [s]: fluid, grains, sum over V g [kg/m^3]; eps, the bed less the water [kg/m^3];"
    echo "# sum over that; force of the fluid over V and the mean pressure gradient of the bed"
    for bed in "14 3000" "20 6100"; do
        # shellcheck disable=SC2086 # two words
        {
            held_in $bed 0.018 1.05
            held_row $bed 0.018 0.2 0.0
            held_row $bed 0.018 0.4 0.2
            held_row $bed 0.018 1.05 0.6
            held_in $bed 0.005 0.3
            held_row $bed 0.005 0.3 0.2
        }
    done
}

for part; do
    { made "$part"; $part; } >$out/24-"$part".txt
    cp $out/24-"$part".txt figures/24/24-"$part".txt
done

# The bands: 3 % at 12 cells in a diameter (9 % in the densest array), a spread of
# 1 % over the places in a cell, 0.3 % of the drag from step to step up to
# nu dt / h^2 = 3, 4 % of the largest velocity at 7.5 cells but for E1.
awk '
    function off(x) { return x < 0 ? -x : x }
    function want(ok, what) { if (!ok) { print "out of its band: " what; bad = 1 } }
    /^#/ || NF == 0 { next }
    FILENAME ~ /arrays/ && $3 > 11 { want(off($6) <= ($1 > 0.4 ? 9 : 3), FILENAME ": " $0) }
    FILENAME ~ /methods/ && $1 >= 0.1 && $1 <= 3 {
        if (!held) held = $2
        want(off($2 / held - 1) <= 0.003, FILENAME ": " $0)
    }
    FILENAME ~ /places/ && $1 < 0.4 { if (!first) first = $5; want(off($5 / first - 1) <= 0.01, FILENAME ": " $0) }
    FILENAME ~ /falls/ && $2 > 7 && $1 != "E1" { want(off($6) <= 4, FILENAME ": " $0) }
    END { exit bad }' figures/24/24-arrays.txt figures/24/24-methods.txt figures/24/24-places.txt figures/24/24-falls.txt

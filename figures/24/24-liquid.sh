#!/bin/sh
# The beds in a liquid with resolved flow, a line for each file of
# tests/validate/resolved-bed.sh: velocity, width in diameters and cells in one; height,
# Reynolds number and fluid fraction in the mean; force over weight; of the samples near
# these two their number, C_d over that of Beetstra's law, and its deviation over itself;
# the integral time of the force to the first zero [d/u_in].
set -eu
echo "# Re_in width cells  height  Re_p  eps  force/weight  samples  C_d/Beetstra  sigma/C_d  T"
for file in figures/24/24-liquid-*[0-9].txt; do
    case $file in *times*) continue ;; esac
    name=${file#figures/24/24-liquid-}
    name=${name%.txt}
    case $name in *-*) ;; *) name=$name-4-8 ;; esac
    awk -v name="$name" '
        function after(text) {
            return substr($0, index($0, text) + length(text)) + 0
        }
        NR == 2 {
            height = after("height "); re = after("Re_p "); eps = after("eps ")
            carried = after("weight ")
        }
        NR == 3 {
            n = after("(0.01): "); C = after("C_d "); s = after("deviation ")
            law = after("Beetstra ")
        }
        /^# integral time/ { T = after("zero ") }
        END {
            split(name, a, "-")
            printf "%4d %4d %5d  %6.2f %6.2f %5.3f %6.3f %6d %8.3f %8.3f %8.3f\n", a[1],
                a[2], a[3], height, re, eps, carried, n, C / law, s / C, T
        }' "$file"
done | sort -n -k1,1 -k2,2 -k3,3

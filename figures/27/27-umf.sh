#!/bin/sh
# At which velocity is the small bed carried, for Gaussians of several widths? The air
# grows from 0 to 1.2 m/s in 6 s. Columns: b [mm], b / d, height of the bed over b, the
# velocity at which the pressure drop first equals the weight, and the one at which the
# mean height has grown by 2 per cent [m/s].
. "$(dirname "$0")/../here.sh"
echo "# b [mm], b / d, h / b, U at the weight, U at 1.02 of the height [m/s]"
for b in 1.2 2.4 3.6 4.8 6.6 9.6; do
    winnow run cases/small-bed.cfg --quiet -o out/27-umf/$b -s averaging.bandwidth=${b}e-3 \
        -s 'fluid.bottom.inlet=((0.0,0.0),(6.0,1.2))' -s output.end=6.0 \
        -s output.history=0.005 -s output.every=6.0 >/dev/null 2>&1
    columns out/27-umf/$b/history.csv inlet_velocity mean_height pressure_drop bed_weight | awk -v b=$b '
        { u = $1; h = $2 }
        u < 0.2 { rest = h }
        !carried && $3 >= $4 { carried = u }
        !lifted && u > 0.2 && h > 1.02 * rest { lifted = u }
        END { printf "%4.1f %5.2f %6.2f %6.3f %6.3f\n", b, b / 1.2, 2000 * rest / b, carried, lifted }'
done

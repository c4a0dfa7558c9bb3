#!/bin/sh
# Van Wachem's bed, one choice after the other, to 6 s: what moves the rate at which it
# pulsates?
#
#   sh figures/27/27-wachem-vary.sh run [NAME ...]     into out/27-wachem-vary
#   sh figures/27/27-wachem-vary.sh table              spread, strongest, pulses of each
#
# On one quiet core a choice takes a quarter of an hour, the stiff one three. Told again, an
# interrupted run goes on, and a run that is done is not made again.
. "$(dirname "$0")/../here.sh"
out=out/27-wachem-vary

choices() {
    cat <<END
as-it-is
seed-2 -s particles.bed.seed=2
seed-3 -s particles.bed.seed=3
gidaspow -s exchange.drag=gidaspow
di-felice -s exchange.drag=di-felice
beetstra -s exchange.drag=beetstra
bandwidth-1.5d -s averaging.bandwidth=2.32e-3
bandwidth-3d -s averaging.bandwidth=4.64e-3
friction-0.1 -s particles.grains.friction=0.1
friction-0.5 -s particles.grains.friction=0.5
no-slip-front -s fluid.front_back=no-slip
slip-sides -s fluid.sides=slip
restitution-0.8 -s particles.grains.restitution=0.8
whole -s effects={gravity=[0.0,-9.81,0.0];whole_drag={};}
young-1.2e6 -s particles.grains.young=1.2e6 -s particles.step=1e-5
END
}

run() { # NAME ...
    choices | while read -r name change; do
        [ $# -eq 0 ] || case " $* " in *" $name "*) ;; *) continue ;; esac
        ! grep -q '"exit_reason": "done"' "$out/$name/summary.json" 2>/dev/null || continue
        [ ! -e "$out/$name/checkpoint" ] || change="$change --resume"
        # shellcheck disable=SC2086 # words
        winnow run cases/van-wachem-bed.cfg --quiet -j 1 -o "$out/$name" \
            -s output.end=6.0 $change </dev/null >/dev/null || return
    done
}

table() {
    choices | while read -r name change; do
        [ -s "$out/$name/probes.csv" ] || continue
        printf '%-16s' "$name"
        python3 figures/27/27-pulse.py "$out/$name/probes.csv" 1 1
    done
}

todo=$1
shift
mkdir -p $out
"$todo" "$@"

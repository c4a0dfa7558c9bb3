#!/bin/sh
# Runs the four scenes and draws moments of them: a minute.
#
#   sh figures/14/14-view.sh
. "$(dirname "$0")/../here.sh"
for scene in chute fed-chute stirred-box collision-3d; do
    winnow run cases/$scene.cfg -o out/$scene --quiet
done
view() {
    xvfb-run -a /usr/bin/python3 figures/14/scene.py "$@"
}
view out/chute figures/14/14-chute.png 0.5,0.45,1 speed:1.5 430 330 1.25 0 0.2 0.4
view out/stirred-box figures/14/14-stirred-box.png 0,0,1 id:108 300 340 1.3 \
    0 0.5 0.7 0.9
view out/collision-3d figures/14/14-collision-3d.png 0.2,0.3,1 speed:2 420 240 \
    1.1 0 0.036 0.12
view out/fed-chute figures/14/14-worn.png -0.2,1,0.35 \
    worn_depth:1e-8,normal_stress:80,shear_stress:30 430 240 1.4 1.2

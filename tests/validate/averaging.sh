#!/bin/sh
# Long runs of the averaging: the Mueller bed on five meshes, by pcm and by
# diffusion, over 18 s as SX15 fig. 4-7 have it. Hours.
#
#   sh tests/validate/averaging.sh build/winnow [END]
set -eu
PATH=$(cd "$(dirname "$1")" && pwd):$PATH
out=out/validate-averaging.txt
mkdir -p out/21-mueller
sh figures/21-loop.sh mueller "${2:-18}" | tee $out
echo "in $out; figures/21-mueller.txt has what was run last" >&2

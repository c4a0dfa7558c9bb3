#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The spouted bed, computed and measured.

    27-spouted.py TABLE

For each height, in rows: the fastest of the measured and of the computed speeds; the
widths of the spout, where the speed is more than half of that; the root mean square of
the difference at the measured places, in the spout (up to 20 mm from the middle) and
beside it; and the mirror error of both, half the difference of left and right.
"""
import math
import sys

from profile_lines import at, rms

DATA = "figures/data/yue-2020.txt"
DEPTH = 200.0
SPOUT = 20.0


def rows(path):
    return [[float(w) for w in row.split()] for row in open(path) if row[0] != "#"]


def width(line):
    """Between the outermost places where the speed crosses half of its largest value."""
    half = max(y for _, y in line) / 2
    middle = max(line, key=lambda p: p[1])[0]
    ends = []
    for side in (reversed([p for p in line if p[0] <= middle]), [p for p in line if p[0] >= middle]):
        last = None
        for x, y in side:
            if y < half:
                ends.append(last[0] + (half - last[1]) / (y - last[1]) * (x - last[0]))
                break
            last = x, y
    return abs(ends[1] - ends[0]) if len(ends) == 2 else math.nan


def mirror(line):
    return rms([(y - at(line, -x)) / 2 for x, y in line])


measured, computed = {}, {}
for h, x, u in rows(DATA):
    measured.setdefault(round(h * DEPTH), []).append((x, u))
for h, x, ux, uy in rows(sys.argv[1]):
    computed.setdefault(round(h), []).append((x, math.hypot(ux, uy)))

print("# height [mm]: fastest, measured and computed [m/s]; width [mm]; rms in the spout,")
print("# beside it; mirror error, measured and computed [m/s]")
for h, line in sorted(measured.items()):
    ours = sorted(computed[h])
    off = [(x, at(ours, x) - u) for x, u in line]
    print("%4d  %.2f %.2f  %4.0f %4.0f  %.3f %.3f  %.3f %.3f" % (
        h, max(u for _, u in line), max(u for _, u in ours), width(line), width(ours),
        rms([d for x, d in off if abs(x) <= SPOUT]),
        rms([d for x, d in off if abs(x) > SPOUT]), mirror(line), mirror(ours)))

# SPDX-License-Identifier: GPL-3.0-or-later
"""Profiles as lists of points (x, y), for the scripts that compare beds."""
import math


def rms(values):
    return math.sqrt(sum(v * v for v in values) / len(values)) if values else math.nan


def at(line, x):
    """Of points (x, y), linear between them and constant beyond the last."""
    if x <= line[0][0]:
        return line[0][1]
    for (x1, y1), (x2, y2) in zip(line, line[1:]):
        if x <= x2:
            return y1 + (x - x1) / (x2 - x1) * (y2 - y1)
    return line[-1][1]

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How strongly and how often a signal pulses.

    27-pulse.py FILE [COLUMN [FROM]]

FILE is a table of time [s] and value, or a csv of winnow, of which COLUMN is the number
and FROM [s] the first time that counts. Prints the spread, the frequency with the most
power, and the number of crossings of the mean from below, each of which needs to fall
back by half a spread before it counts again, over the time.
"""
import math
import sys


def read(path, column, begin):
    points = []
    for row in open(path):
        words = row.replace(",", " ").split()
        try:
            point = float(words[0]), float(words[column])
        except (ValueError, IndexError):
            continue
        if point[0] >= begin:
            points.append(point)
    return points


def even(points, n=2048):
    """The signal at n even times, linear in between, less its mean."""
    t0, t1 = points[0][0], points[-1][0]
    values, i = [], 0
    for k in range(n):
        t = t0 + (t1 - t0) * k / (n - 1)
        while i < len(points) - 2 and points[i + 1][0] < t:
            i += 1
        (a, x), (b, y) = points[i], points[i + 1]
        values.append(x + (y - x) * (t - a) / (b - a))
    mean = sum(values) / n
    return [v - mean for v in values], t1 - t0


def power(signal, cycles):
    """Of a wave with so many cycles in the whole, under a Hann window."""
    n, re, im = len(signal), 0.0, 0.0
    for k, v in enumerate(signal):
        w = 0.5 - 0.5 * math.cos(2 * math.pi * k / n)
        re += w * v * math.cos(2 * math.pi * cycles * k / n)
        im += w * v * math.sin(2 * math.pi * cycles * k / n)
    return re * re + im * im


def main(path, column="1", begin="0"):
    signal, length = even(read(path, int(column), float(begin)))
    spread = math.sqrt(sum(v * v for v in signal) / len(signal))
    tried = [c / 4 for c in range(4, int(40 * length))]  # from one cycle to 10 Hz
    strongest = max(tried, key=lambda c: power(signal, c)) / length
    low, crossings = False, 0
    for v in signal:
        if v < -spread / 2:
            low = True
        if low and v > 0:
            low, crossings = False, crossings + 1
    print(f"spread {spread:.0f}, strongest {strongest:.2f} 1/s, "
          f"pulses {crossings / length:.2f} 1/s, in {length:.2f} s")


if __name__ == "__main__":
    main(*sys.argv[1:])

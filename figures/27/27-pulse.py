#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How strongly and how often a signal pulses.

    27-pulse.py FILE [COLUMN [FROM [TABLE]]]

FILE is a table of time [s] and value, or a csv of winnow, of which COLUMN is the number
and FROM [s] the first time that counts. Prints the spread, the frequency with the most
power, and the number of crossings of the mean from below, each of which needs to fall
back by half a spread before it counts again, over the time. With TABLE it prints the
ranges of these numbers over windows as long as TABLE, read only at the times of TABLE.
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


def pulses(points):
    """Spread, strongest frequency, crossings a time, length."""
    signal, length = even(points)
    spread = math.sqrt(sum(v * v for v in signal) / len(signal))
    tried = [c / 4 for c in range(4, int(40 * length))]  # from one cycle to 10 Hz
    strongest = max(tried, key=lambda c: power(signal, c)) / length
    low, crossings = False, 0
    for v in signal:
        if v < -spread / 2:
            low = True
        if low and v > 0:
            low, crossings = False, crossings + 1
    return spread, strongest, crossings / length, length


def windows(points, as_read):
    """The signal as it would have been read from a curve of that length at those times,
    one reading every half second."""
    offsets = [t - as_read[0][0] for t, _ in as_read]
    begin, i = points[0][0], 0
    while begin + offsets[-1] <= points[-1][0]:
        read_at, i = [], 0
        for t in (begin + o for o in offsets):
            while i < len(points) - 2 and points[i + 1][0] < t:
                i += 1
            (a, x), (b, y) = points[i], points[i + 1]
            read_at.append((t, x + (y - x) * (t - a) / (b - a)))
        yield pulses(read_at)
        begin += 0.5


def main(path, column="1", begin="0", as_read=None):
    points = read(path, int(column), float(begin))
    if as_read:
        found = list(windows(points, read(as_read, 1, 0.0)))
        spread, strongest, rate, length = zip(*found)
        print(f"spread {min(spread):.0f} to {max(spread):.0f}, strongest {min(strongest):.2f} to "
              f"{max(strongest):.2f} 1/s, pulses {min(rate):.2f} to {max(rate):.2f} 1/s, "
              f"in {len(found)} windows of {length[0]:.2f} s")
        return
    print("spread {:.0f}, strongest {:.2f} 1/s, pulses {:.2f} 1/s, in {:.2f} s".format(
        *pulses(points)))


if __name__ == "__main__":
    main(*sys.argv[1:])

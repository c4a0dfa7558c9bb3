#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mueller's bed, computed and measured: what of the distance is offset, what is
shape, what is chance; and whether what was measured can be true.

    27-compare.py distance TABLE [FROM]    of each run in TABLE (27-mueller.sh collect)
    27-compare.py flux TABLE               of solids through a height
    27-compare.py seeds TABLE              between runs that differ by their seed
    27-compare.py profile TABLE            the even part of the profiles, to compare with
    27-compare.py sides TABLE              which way round the bed goes, every 2 s
    27-compare.py vary TABLE               what one choice after the other moves
    27-compare.py forms END TABLE...       offsets on mesh C up to END, with errors
    27-compare.py mean NAME,... FIELD HEIGHT TABLE...   of runs, 2 to 16 s: x [mm], mean, its error

Means are from FROM [s], 1 if not given. In the columns: the root mean square of the
difference at the measured places; offset, its mean; shape, what is left of it; even, the
root mean square for the mean of the profile and its mirror image; mirror, half the
difference of the two sides; blocks, the error of the mean by blocks of 2 s from 2 s on. sediFoam
is without its points in the outermost 3.5 mm, where it is interpolated to a wall at which
there are no spheres; like ours it is constant beyond the last point.
"""
import math
import re
import sys

from profile_lines import at, rms

DATA = "figures/data/mueller-2009.txt"
WIDE = "figures/26/26-mueller.txt"
WIDTH = 0.044
LINES = [("eps_f", 16.4), ("eps_f", 31.2), ("us_y", 15.0), ("us_y", 25.0)]


def references():
    found = {}
    for row in open(DATA):
        if row[0] == "#":
            continue
        who, field, height, x, y = row.split()
        found.setdefault((who, field, float(height)), []).append((float(x), float(y)))
    for key, line in found.items():
        line.sort()
        if key[0] == "sediFoam":
            found[key] = [p for p in line if 0.0035 <= p[0] <= WIDTH - 0.0035]
    return found


class Run:
    """Means of one run, and of parts of it: of the sums since two times."""

    def __init__(self, words):
        i = words.index("end")
        self.name, self.U, self.seed, self.b, self.cells = words[1:6]
        self.else_, self.end = " ".join(words[6:i]), float(words[i + 1])
        self.sums = {}

    def add(self, since, field, height, x, mean):
        self.sums.setdefault((float(since), field, float(height)), {})[float(x)] = float(mean)

    def since(self):
        return sorted({key[0] for key in self.sums if key[0] < self.end})

    def mean(self, field, height, begin, end=None):
        """Points (x, mean from begin to end); a velocity is weighted by solids."""
        end = self.end if end is None else end

        def total(begin, x, power):  # of eps_s, or of eps_s us_y
            if begin >= self.end:
                return 0.0
            eps = self.sums[begin, "eps_s", height][x]
            of = 1.0 if power == 0 else self.sums[begin, "us_y", height][x]
            return (self.end - begin) * eps * of

        line = []
        for x in sorted(self.sums[begin, "eps_s", height]):
            amount = total(begin, x, 0) - total(end, x, 0)
            if field == "eps_f":
                line.append((x, 1.0 - amount / (end - begin)))
            else:
                line.append((x, (total(begin, x, 1) - total(end, x, 1)) / amount))
        return line

    def blocks(self, field, height):
        """Of 2 s each, from 2 s on."""
        times = [t for t in self.since() + [self.end] if t % 2 == 0]
        return [self.mean(field, height, a, b) for a, b in zip(times, times[1:])]


def runs(table):
    found = {}
    for row in open(table):
        words = row.split()
        if words and words[0] == "run":
            found[words[1]] = Run(words)
        elif words and words[0] == "from":
            found[words[1]].add(*words[2:])
    return found.values()


def parts(line, seen):
    """rms, offset and shape of the difference from what was seen."""
    off = [at(line, x) - y for x, y in seen]
    mean = sum(off) / len(off)
    return rms(off), mean, rms([d - mean for d in off])


def even(line):
    """The mean with the mirror image."""
    return [(x, (y + at(line, WIDTH - x)) / 2) for x, y in line]


def mirror(line):
    return rms([(y - at(line, WIDTH - x)) / 2 for x, y in line])


def block_error(blocks):
    m = len(blocks)
    if m < 3:
        return math.nan
    errors = []
    for column in zip(*blocks):
        values = [y for _, y in column]
        mean = sum(values) / m
        errors.append(math.sqrt(sum((v - mean) ** 2 for v in values) / (m * (m - 1))))
    return rms(errors)


def wide(field, height):
    """By diffusion with b of 4 d on mesh C, 1 to 18 s."""
    rows = (row.split() for row in open(WIDE))
    return [(float(w[5]), float(w[6])) for w in rows
            if w[:4] == ["at", "C", "diffusion", field] and float(w[4]) == height]


def distance(table, begin="1"):
    seen = references()
    print("# name, field, height [mm]: rms, offset, shape, even, mirror, blocks [-] or [m/s]")
    for field, height in LINES:
        print(f"# {field} at {height:g} mm")
        of = seen["measured", field, height]
        for r in runs(table):
            if float(r.U) != 0.9:
                continue
            line = r.mean(field, height, float(begin))
            print(f"{r.name:14s} %6.3f %+7.3f %6.3f %6.3f %6.3f %6.3f  to {r.end:g} s" %
                  (*parts(line, of), parts(even(line), of)[0], mirror(line),
                   block_error(r.blocks(field, height))))
        line = wide(field, height)
        print("%-14s %6.3f %+7.3f %6.3f %6.3f %6.3f         to 18 s" %
              ("b = 4 d", *parts(line, of), parts(even(line), of)[0], mirror(line)))
        line = seen["sediFoam", field, height]
        print("%-14s %6.3f %+7.3f %6.3f %6.3f %6.3f" %
              ("sediFoam", *parts(line, of), parts(even(line), of)[0], mirror(line)))
        print("%-14s %29s %6.3f" % ("measured", "", mirror(of)))


def integral(line):
    """Mean over the width of points, constant beyond the last."""
    n = 440
    return sum(at(line, (i + 0.5) * WIDTH / n) for i in range(n)) / n


def flux(table):
    """eps_s us_y over the width, in mm/s: 0 over endless time, for a bed stays."""
    seen = references()
    print("# mean of eps_s us_y over a height [mm/s], and of its amount")
    for height, low, high in ((16.4, 15.0, 25.0), (31.2, 25.0, 35.0)):
        part = (height - low) / (high - low)
        eps = seen["measured", "eps_f", height]
        below, above = (seen["measured", "us_y", h] for h in (low, high))
        product = []
        for i in range(440):
            x = (i + 0.5) * WIDTH / 440
            u = (1 - part) * at(below, x) + part * at(above, x)
            product.append((x, (1 - at(eps, x)) * u))
        print("%-14s %5.1f mm %7.1f %7.1f" %
              ("measured", height, 1000 * integral(product),
               1000 * integral([(x, abs(y)) for x, y in product])))
    for r in runs(table):
        for height in (16.4, 31.2):
            eps, u = (r.mean(f, height, 1.0) for f in ("eps_f", "us_y"))
            product = [(x, (1 - e) * v) for (x, e), (_, v) in zip(eps, u)]
            mean = sum(y for _, y in product) / len(product)
            size = sum(abs(y) for _, y in product) / len(product)
            print(f"{r.name:14s} {height:5.1f} mm {1000 * mean:7.1f} {1000 * size:7.1f}")


def seeds(table):
    found = list(runs(table))
    print("# rms of the difference of two seeds: eps_f 16.4, 31.2, us_y 15, 25")
    for i, a in enumerate(found):
        for b in found[i + 1:]:
            if (a.U, a.b, a.cells, a.else_) != (b.U, b.b, b.cells, b.else_):
                continue
            off = []
            for field, height in LINES:
                one, two = a.mean(field, height, 1.0), b.mean(field, height, 1.0)
                off.append(rms([p[1] - q[1] for p, q in zip(one, two)]))
            print(f"{a.name} {b.name}  " + "  ".join(f"{o:.3f}" for o in off))


def profile(table):
    for r in runs(table):
        lines = [r.mean(field, height, 1.0) for field, height in LINES]
        print(f"# {r.name}, 1 to {r.end:g} s: x [mm], eps_f at 16.4 and 31.2 mm, us_y at 15 and "
              "25 mm [m/s]")
        folded = [even(line) for line in lines]
        for row in list(zip(*folded))[:len(lines[0]) // 2]:
            print(f"{1000 * row[0][0]:5.2f}  " + "  ".join(f"{y:+.3f}" for _, y in row))
        print("mirror " + "  ".join(f"{mirror(line):6.3f}" for line in lines))


def sides(table):
    """The mean velocity of the left half less that of the right half, halved."""
    print("# us_y at 15 mm, left less right over 2 [m/s], from 2 s on every 2 s")
    for r in runs(table):
        turns = []
        for line in r.blocks("us_y", 15.0):
            half = len(line) // 2
            left = sum(y for _, y in line[:half])
            turns.append((left - sum(y for _, y in line[-half:])) / half / 2)
        print(f"{r.name:14s} " + " ".join(f"{t:+.3f}" for t in turns))


def measures(r, end=4.0):
    """Offsets in void fraction; distances of the even part; the mirror error at 25 mm."""
    seen = references()
    lines = [r.mean(field, height, 1.0, min(end, r.end)) for field, height in LINES]
    found = [parts(line, seen["measured", *key])[1] for line, key in zip(lines[:2], LINES)]
    found += [parts(even(line), seen["measured", *key])[0] for line, key in zip(lines, LINES)]
    return found + [mirror(lines[3])]


def seeds_of(table):
    """Runs to 4 s by their names without the seed."""
    groups = {}
    for r in runs(table):
        if r.end >= 3.9:
            groups.setdefault(re.sub(r"^(seed)-\d+$|\+\d+$", r"\1", r.name), []).append(r)
    return groups


def mean_of_seeds(names, field, height, *tables):
    """Means from 2 to 16 s of these runs."""
    lines = [r.mean(field, float(height), 2.0, 16.0) for table in tables for r in runs(table)
             if r.name in names.split(",")]
    for column in zip(*lines):
        values, n = [y for _, y in column], len(column)
        mean = sum(values) / n
        error = math.sqrt(sum((y - mean)**2 for y in values) / (n - 1) / n) if n > 1 else math.nan
        print(f"{1000 * column[0][0]:5.2f} {mean:.4f} {error:.4f}")


def student(n):
    """The two-sided 95 % point of Student's distribution of n degrees of freedom, by its
    series about the normal one (within 0.02 from three on, Abramowitz & Stegun 26.7.5)."""
    z = 1.959964
    return (z + (z**3 + z) / (4 * n) + (5 * z**5 + 16 * z**3 + 3 * z) / (96 * n**2)
            + (3 * z**7 + 19 * z**5 + 17 * z**3 - 15 * z) / (384 * n**3))


def vary(table):
    """Means over the seeds of each choice. All choices are taken to scatter alike: the
    variance within the choices is pooled. A number has a star if it differs from that of
    the bed as it is by more than chance does in 95 of 100 comparisons; beside it stands
    by how much the two may differ by chance."""
    groups = {name: [measures(r) for r in found] for name, found in seeds_of(table).items()}
    means = {name: [sum(c) / len(found) for c in zip(*found)] for name, found in groups.items()}
    free = sum(len(found) - 1 for found in groups.values())
    spread = [math.sqrt(sum((found[k] - means[name][k]) ** 2
                            for name, group in groups.items() for found in group) / free)
              for k in range(len(means["seed"]))]
    same, n = means.pop("seed"), len(groups["seed"])
    print("# means over seeds: offset of eps_f at 16.4, 31.2 mm; rms of the even part: eps_f at")
    print("# 16.4, 31.2 mm, us_y at 15, 25 mm [m/s]; mirror error of us_y at 25 mm; seeds")
    print(f"{'as it is':16s} " + " ".join(f"{v:+.3f} " if k < 2 else f"{v:.3f} "
                                          for k, v in enumerate(same)) + f" {n}")
    for name, found in sorted(means.items()):
        m = len(groups[name])
        chance = [student(free) * s * math.sqrt(1 / n + 1 / m) for s in spread]
        marks = ["*" if abs(v - w) > c else " " for v, w, c in zip(found, same, chance)]
        print(f"{name:16s} " + " ".join(f"{v:+.3f}{mark}" if k < 2 else f"{v:.3f}{mark}"
                                        for k, (v, mark) in enumerate(zip(found, marks))) + f" {m}")
    for m in sorted({len(groups[name]) for name in means}):
        print(f"{f'by chance, {m}':16s} " + " ".join(
            f" {student(free) * s * math.sqrt(1 / n + 1 / m):.3f} "[k >= 2:] for k, s in
            enumerate(spread)))


def forms(end, *tables):
    """The errors are those of the mean of blocks, taken to be independent."""
    seen, last = references(), float(end)
    first = width = 1 if last <= 6 else 2
    print(f"# mesh C, means from {first} to {end} s: offset of eps_f at 16.4 and 31.2 mm, each +- its standard error")
    print(f"# by blocks of {width} s; rms there; us_y in the middle at 25 mm [m/s]; mirror error of")
    print("# eps_f at 31.2 mm and of us_y at 25 mm [m/s]")
    for r in (r for table in tables for r in runs(table)):
        if r.end < last or r.cells != "18,50,4":
            continue
        row = []
        for height in (16.4, 31.2):
            of = seen["measured", "eps_f", height]
            blocks = [parts(r.mean("eps_f", height, t, t + width), of)[1]
                      for t in map(float, range(first, int(last), width))]
            mean, n = sum(blocks) / len(blocks), len(blocks)
            row += [mean, math.sqrt(sum((x - mean)**2 for x in blocks) / n / (n - 1))]
        lines = [r.mean("eps_f", h, first, last) for h in (16.4, 31.2)]
        row += [parts(line, seen["measured", "eps_f", h])[0] for line, h in zip(lines, (16.4, 31.2))]
        rise = r.mean("us_y", 25.0, first, last)
        row += [at(rise, WIDTH / 2), mirror(lines[1]), mirror(rise)]
        print(f"{r.name:10s}  {row[0]:+.3f} +- {row[1]:.3f}  {row[2]:+.3f} +- {row[3]:.3f}  "
              + " ".join(f"{x:.3f}" for x in row[4:]))


if __name__ == "__main__":
    {"distance": distance, "flux": flux, "seeds": seeds, "sides": sides, "profile": profile,
     "vary": vary, "forms": forms, "mean": mean_of_seeds}[sys.argv[1]](*sys.argv[2:])

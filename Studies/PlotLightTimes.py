# SPDX-License-Identifier: BSD-3-Clause
"""Draws what SkylineLightTimes prints: cost against posts and against azimuths, as one SVG.

    build/bin/SkylineLightTimes 8192 > times.csv
    python3 Studies/PlotLightTimes.py times.csv cost.svg
"""
import csv
import math
import sys

WIDTH, HEIGHT, GAP = 380.0, 300.0, 64.0  # of a panel, pixels
# Okabe and Ito's colours: apart for the colour-blind too. Spikes are dashed.
COLORS = {"uniform": "#0072b2", "environment": "#d55e00", "sweep": "#e69f00", "shadow sweep": "#009e73",
          "shadow exact": "#cc79a7"}


class Axis:
    """A logarithmic axis from low to high over pixels from begin to end."""

    def __init__(self, low, high, begin, end):
        self.low, self.high, self.begin, self.end = low, high, begin, end

    def __call__(self, value):
        part = math.log(value / self.low) / math.log(self.high / self.low)
        return self.begin + part * (self.end - self.begin)


def text(x, y, words, anchor="middle", color="#222"):
    return '<text x="%.1f" y="%.1f" text-anchor="%s" fill="%s">%s</text>' % (x, y, anchor, color, words)


def apart(labels, least=12.0):
    """Labels (y, words, color) pushed down until none lies on another."""
    placed = []
    for y, words, color in sorted(labels):
        placed.append((max(y, placed[-1][0] + least) if placed else y, words, color))
    return placed


def panel(left, title, across, up, ticks, lines):
    """A chart: ticks are the values named on the axes, lines are (name, scene, points)."""
    top = 40.0
    x = Axis(*across, left, left + WIDTH)
    y = Axis(*up, top + HEIGHT, top)
    parts = [text(left + 0.5 * WIDTH, 20.0, title)]
    for value in ticks[0]:
        parts.append('<path d="M%.1f %.1fv%.1f" class="grid"/>' % (x(value), top, HEIGHT))
        parts.append(text(x(value), top + HEIGHT + 16.0, "%g" % value))
    for value in ticks[1]:
        parts.append('<path d="M%.1f %.1fh%.1f" class="grid"/>' % (left, y(value), WIDTH))
        parts.append(text(left - 6.0, y(value) + 4.0, "%g" % value, "end"))
    labels = []
    for name, scene, points in lines:
        path = "M" + "L".join("%.1f %.1f" % (x(a), y(b)) for a, b in points)
        dash = ' stroke-dasharray="5 3"' if scene == "spikes" else ""
        parts.append('<path d="%s" fill="none" stroke="%s" stroke-width="2"%s/>' % (path, COLORS[name], dash))
        labels.append((y(points[-1][1]) + 4.0, name + ", " + scene, COLORS[name]))
    parts += [text(left + WIDTH + 6.0, at, words, "start", color) for at, words, color in apart(labels)]
    return parts


def main():
    source, target = sys.argv[1:]
    with open(source, encoding="utf-8") as file:
        rows = [(row["what"], row["scene"], int(row["posts a side"]), int(row["azimuths"]),
                 float(row["CPU seconds"]), float(row["ns a post and azimuth"]))
                for row in csv.DictReader(file)]
    sides, azimuths = {}, {}
    for what, scene, side, count, seconds, cost in rows:
        if what in COLORS and scene != "tables":
            if not (side == 512 and (what, scene, side) in sides):
                sides[what, scene, side] = cost
            if side == 512 and scene == "fractal" and what in ("uniform", "environment"):
                azimuths[what, scene, count] = 1000.0 * seconds

    def lines(table):
        names = sorted({key[:2] for key in table})
        return [(*name, sorted((key[2], value) for key, value in table.items() if key[:2] == name))
                for name in names]

    largest = max(key[2] for key in sides)
    powers = [2 ** k for k in range(8, 1 + int(math.log2(largest)))]
    parts = panel(50.0, "ns a post and azimuth, against posts a side", (256.0, largest), (5.0, 200.0),
                  (powers, (5, 10, 20, 50, 100, 200)), lines(sides))
    parts += panel(50.0 + WIDTH + 140.0 + GAP, "ms of a frame of 512 x 512 posts, against azimuths",
                   (8.0, 128.0), (20.0, 2000.0), ((8, 16, 32, 64, 128), (20, 50, 100, 200, 500, 1000, 2000)),
                   lines(azimuths))
    with open(target, "w", encoding="utf-8") as file:
        file.write('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1160 370" font-family="sans-serif" '
                   'font-size="12">\n<style>.grid{stroke:#ddd;fill:none}</style>\n'
                   '<rect width="1160" height="370" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n")


if __name__ == "__main__":
    main()

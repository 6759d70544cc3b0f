# SPDX-License-Identifier: MIT
"""A little SVG for the figures of tools/bench and tools/trade: a page, scales, axes, legends."""
import html
import math

COLOURS = ("#1f6feb", "#d1570b", "#2da44e", "#8250df", "#bf3989", "#57606a")
INK, FAINT = "#24292f", "#d0d7de"


class Page:
    """Collects shapes; positions are pixels, y downwards."""

    def __init__(self, width, height, title):
        self.width, self.height = width, height
        self.shapes = [f'<rect width="{width}" height="{height}" fill="white"/>']
        self.text(16, 26, title, size=16, weight="bold")

    def text(self, x, y, words, anchor="start", size=12, colour=INK, weight="normal", turn=0):
        turned = f' transform="rotate({turn} {x:.1f} {y:.1f})"' if turn else ""
        self.shapes.append(
            f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" fill="{colour}"'
            f' font-weight="{weight}" text-anchor="{anchor}"{turned}>{html.escape(words)}</text>'
        )

    def line(self, points, colour=INK, width=1.0, dash=""):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        dashed = f' stroke-dasharray="{dash}"' if dash else ""
        self.shapes.append(
            f'<polyline points="{path}" fill="none" stroke="{colour}"'
            f' stroke-width="{width}"{dashed}/>'
        )

    def bar(self, x, y, width, height, colour):
        self.shapes.append(
            f'<rect x="{x:.1f}" y="{y:.1f}" width="{max(width, 0):.1f}" height="{height:.1f}"'
            f' fill="{colour}"/>'
        )

    def dot(self, x, y, radius, colour, hollow=False, hint=""):
        fill, stroke = ("white", colour) if hollow else (colour, "white")
        self.shapes.append(
            f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" fill="{fill}" stroke="{stroke}"'
            f' stroke-width="1.5"><title>{html.escape(hint)}</title></circle>'
        )

    def legend(self, x, y, names_and_colours):
        for i, (name, colour) in enumerate(names_and_colours):
            self.dot(x, y + 18 * i - 4, 5, colour)
            self.text(x + 12, y + 18 * i, name)

    def write(self, path):
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}"'
            f' viewBox="0 0 {self.width} {self.height}" font-family="sans-serif">\n'
            + "\n".join(self.shapes)
            + "\n</svg>\n",
            encoding="utf-8",
        )


class LogScale:
    """Takes values low..high, both above 0, to pixels start..end."""

    def __init__(self, low, high, start, end):
        if high / low < 10:  # a narrow band would have no tick to read it by
            middle = math.sqrt(low * high)
            low, high = middle / 3.2, middle * 3.2
        self.low, self.high, self.start, self.end = low, high, start, end

    def __call__(self, value):
        value = min(max(value, self.low), self.high)
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.start + share * (self.end - self.start)

    def ticks(self):
        """1, 2 and 5 times the powers of ten; the powers alone when that would be too many."""
        decades = range(math.floor(math.log10(self.low)), math.ceil(math.log10(self.high)) + 1)
        steps = (1, 2, 5) if len(decades) <= 4 else (1,)
        values = [step * 10.0**decade for decade in decades for step in steps]
        return [value for value in values if self.low * 0.999 <= value <= self.high * 1.001]


def axes(page, across, up, across_name, up_name):
    """Grid and names of two scales; `up` runs from the bottom pixel to the top one."""
    for value in across.ticks():
        page.line([(across(value), up.start), (across(value), up.end)], FAINT)
        page.text(across(value), up.start + 16, f"{value:g}", "middle", 11)
    for value in up.ticks():
        page.line([(across.start, up(value)), (across.end, up(value))], FAINT)
        page.text(across.start - 6, up(value) + 4, f"{value:g}", "end", 11)
    page.line([(across.start, up.end), (across.start, up.start), (across.end, up.start)])
    page.text((across.start + across.end) / 2, up.start + 36, across_name, "middle")
    middle = (up.start + up.end) / 2
    page.text(across.start - 52, middle, up_name, "middle", turn=-90)

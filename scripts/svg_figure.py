# SPDX-License-Identifier: Apache-2.0
"""Words for drawings of polygons and the contacts between them, as SVG. Used by scripts/figures.

A drawing is a card of its own colour, dark where the reader's page is (prefers-color-scheme), so it can stand on
any page. Colours are Okabe and Ito's, told apart by the colour-blind; what a colour says, a shape or a word says too.
Numbers are written with two decimals: the same input gives the same bytes."""
from xml.sax.saxutils import escape

CLASSES = ("edge-edge", "subject-vertex", "clip-vertex", "shared-vertex")
STYLE = """
.card { fill: #ffffff } .edge { stroke: #24292f } .text, .title { fill: #24292f } .soft { fill: #57606a } .softedge { stroke: #57606a }
.frame { stroke: #8c959f }
.k0 { fill: #0072b2; stroke: #0072b2 } .k1 { fill: #d55e00; stroke: #d55e00 } .k2 { fill: #009e73; stroke: #009e73 } .k3 { fill: #aa4499; stroke: #aa4499 }
@media (prefers-color-scheme: dark) {
.card { fill: #1b2027 } .edge { stroke: #e6edf3 } .text, .title { fill: #e6edf3 } .soft { fill: #a8b3bf } .softedge { stroke: #a8b3bf }
.frame { stroke: #6e7781 }
.k0 { fill: #56b4e9; stroke: #56b4e9 } .k1 { fill: #ff8c42; stroke: #ff8c42 } .k2 { fill: #35c79b; stroke: #35c79b } .k3 { fill: #e08bd0; stroke: #e08bd0 }
}
text { font-family: 'DejaVu Sans', Verdana, Arial, sans-serif; font-size: 12px }
.title { font-size: 13px; font-weight: bold } .small { font-size: 11px } .code { font-family: 'DejaVu Sans Mono', monospace; font-size: 10px }
.subject { fill: #56b4e9; fill-opacity: .22; stroke-width: 1.4 } .clip { fill: #e69f00; fill-opacity: .16; stroke-width: 1.4; stroke-dasharray: 5 3 }
.seen { fill: #56b4e9; fill-opacity: .45 } .minus { fill: url(#hatch) } .minus2 { fill: url(#hatch2) } .plain { fill: none; stroke-width: 1.4 }
.wire { fill: #e69f00; fill-opacity: .3 } .steel { fill: #56b4e9; fill-opacity: .3 } .strong { fill-opacity: .65 }
.hidden { fill-opacity: 0; stroke-dasharray: 2 3 }
"""


def number(x):
    text = f"{x:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def signed_area(ring):
    """Positive when the ring turns from +x towards +y."""
    return sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(ring, ring[1:] + ring[:1])) / 2


class Panel:
    """Places points: model coordinates `box` = (x0, y0, x1, y1) into a square of `scale` a unit at (left, top)."""

    def __init__(self, left, top, box, scale, up=False):
        self.left, self.top, self.box, self.scale, self.up = left, top, box, scale, up

    def __call__(self, point):
        x0, y0, _, y1 = self.box
        down = y1 - point[1] if self.up else point[1] - y0
        return self.left + (point[0] - x0) * self.scale, self.top + down * self.scale

    def path(self, *rings):
        parts = []
        for ring in rings:
            points = [self(p) for p in ring]
            parts.append("M" + "L".join(f"{number(x)} {number(y)}" for x, y in points) + "Z")
        return "".join(parts)


class Drawing:
    def __init__(self, width, height, title):
        self.width, self.height = width, height
        self.lines = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img">',
            f"<title>{escape(title)}</title>",
            f"<style>{STYLE}</style>",
            '<defs><pattern id="hatch" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">'
            '<rect width="7" height="7" fill="#d55e00" fill-opacity=".18"/>'
            '<path d="M0 0V7" stroke="#d55e00" stroke-width="2.5"/></pattern>'
            '<pattern id="hatch2" width="7" height="7" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)">'
            '<path d="M0 0V7" stroke="#d55e00" stroke-width="2.5"/></pattern></defs>',
            f'<rect class="card" width="{width}" height="{height}" rx="8"/>',
        ]

    def add(self, line):
        self.lines.append(line)

    def text(self, x, y, words, kind="text", anchor="start"):
        where = "" if anchor == "start" else f' text-anchor="{anchor}"'
        self.add(f'<text class="{kind}" x="{number(x)}" y="{number(y)}"{where}>{escape(words)}</text>')

    def label(self, x, y, letter, index, anchor="middle"):
        """A letter with an index below the line."""
        self.add(f'<text class="text" x="{number(x)}" y="{number(y)}" text-anchor="{anchor}" font-style="italic">{escape(letter)}'
                 f'<tspan dy="3" font-size="9">{escape(index)}</tspan></text>')

    def name(self, x, y, words):
        """Words on a ground of their own, so that they can be read on any colour."""
        width = 8 * len(words) + 8
        self.add(f'<rect class="card" x="{number(x - width / 2)}" y="{number(y - 8)}" width="{width}" height="16" rx="8" fill-opacity=".85"/>')
        self.text(x, y + 4.5, words, "text", "middle")

    def shorten(self, height):
        """Ends the card at `height`, where less was needed than it was begun with."""
        self.lines = [line.replace(f'{self.width} {self.height}"', f'{self.width} {height}"').replace(f'height="{self.height}"', f'height="{height}"')
                      for line in self.lines]

    def region(self, path, kind, rule="nonzero"):
        self.add(f'<path class="{kind}" d="{path}" fill-rule="{rule}"/>')

    def arrows(self, panel, ring, kind="text"):
        """The direction of travel: a small head in the middle of each edge."""
        points = [panel(p) for p in ring]
        for (px, py), (qx, qy) in zip(points, points[1:] + points[:1]):
            length = ((qx - px) ** 2 + (qy - py) ** 2) ** 0.5
            if length < 24:
                continue
            dx, dy = (qx - px) / length, (qy - py) / length
            x, y = (px + qx) / 2 + 4 * dx, (py + qy) / 2 + 4 * dy
            corners = [(x, y), (x - 8 * dx - 3 * dy, y - 8 * dy + 3 * dx), (x - 8 * dx + 3 * dy, y - 8 * dy - 3 * dx)]
            self.add(f'<path class="{kind}" d="M' + "L".join(f"{number(a)} {number(b)}" for a, b in corners) + 'Z"/>')

    def contact(self, x, y, kind, turns):
        """One mark: its colour is the class, its shape the turn."""
        colour = f"k{CLASSES.index(kind)}"
        at = f'cx="{number(x)}" cy="{number(y)}"'
        if turns == {"touch"}:
            d = f"M{number(x - 3.5)} {number(y - 3.5)}l7 7m0 -7l-7 7"
            self.add(f'<path class="{colour}" d="{d}" style="fill:none" stroke-width="2"/>')
            return
        self.add(f'<circle class="card" {at} r="7"/>')
        if "leave" in turns:
            self.add(f'<circle class="{colour}" {at} r="5.2" style="fill:none" stroke-width="2.2"/>')
            if "enter" in turns:
                self.add(f'<circle class="{colour}" {at} r="2"/>')
        else:
            self.add(f'<circle class="{colour}" {at} r="6" stroke-width="0"/>')

    def legend_of_classes(self, x, y):
        for i, kind in enumerate(CLASSES):
            self.add(f'<rect class="k{i}" x="{number(x)}" y="{number(y + 20 * i)}" width="12" height="12"/>')
            self.text(x + 20, y + 20 * i + 10.5, f"({i + 1}) {kind}")

    def legend_of_turns(self, x, y, both=False, touch=True):
        rows = [({"enter"}, "A enters B"), ({"leave"}, "A leaves B")]
        rows += [({"enter", "leave"}, "one, then the other, in two steps")] if both else []
        rows += [({"touch"}, "they touch: no intersection")] if touch else []
        for i, (turns, words) in enumerate(rows):
            cx, cy = x + 6, y + 20 * i + 6
            if turns == {"touch"}:
                self.add(f'<path class="softedge" d="M{number(cx - 3.5)} {number(cy - 3.5)}l7 7m0 -7l-7 7" fill="none" stroke-width="2"/>')
            elif turns == {"enter"}:
                self.add(f'<circle class="soft" cx="{number(cx)}" cy="{number(cy)}" r="6"/>')
            else:
                self.add(f'<circle class="softedge" cx="{number(cx)}" cy="{number(cy)}" r="5.2" fill="none" stroke-width="2.2"/>')
                if len(turns) == 2:
                    self.add(f'<circle class="soft" cx="{number(cx)}" cy="{number(cy)}" r="2"/>')
            self.text(x + 20, y + 20 * i + 10.5, words)

    def finish(self):
        return "\n".join(self.lines + ["</svg>", ""])

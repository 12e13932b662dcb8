"""svg_text.py SVG...: no text of a figure may leave its canvas, and no two texts may overlap. Extents are those of
DejaVu Sans, whose widths are read from the font's own tables. Prints one line per fault, then the counts; exit
status 1 if there is a fault. `--symbol` also refuses the font Symbol, which browsers do not have."""
import math
import os
import re
import struct
import sys
import xml.etree.ElementTree as tree

FOLDER = "/usr/share/fonts/truetype/dejavu/"
SVG = "{http://www.w3.org/2000/svg}"
CAP, DROP = 0.73, 0.0  # [em] of the box that counts: capitals above the baseline


class Font:
    """Advance widths [em] of a TrueType font with a format 4 or 12 character map."""

    def __init__(self, path):
        data = open(path, "rb").read()
        tables = {}
        for k in range(struct.unpack(">H", data[4:6])[0]):
            tag, _, start, size = struct.unpack(">4sLLL", data[12 + 16 * k:28 + 16 * k])
            tables[tag] = data[start:start + size]
        self.unit = struct.unpack(">H", tables[b"head"][18:20])[0]
        n = struct.unpack(">H", tables[b"hhea"][34:36])[0]
        self.advance = [struct.unpack(">H", tables[b"hmtx"][4 * k:4 * k + 2])[0] for k in range(n)]
        self.glyph = self.read_map(tables[b"cmap"])

    @staticmethod
    def read_map(cmap):
        glyph = {}
        for k in range(struct.unpack(">H", cmap[2:4])[0]):
            start = struct.unpack(">L", cmap[8 + 8 * k:12 + 8 * k])[0]
            if struct.unpack(">H", cmap[start:start + 2])[0] != 12:
                continue
            for g in range(struct.unpack(">L", cmap[start + 12:start + 16])[0]):
                low, high, first = struct.unpack(">LLL", cmap[start + 16 + 12 * g:start + 28 + 12 * g])
                glyph.update((c, first + c - low) for c in range(low, high + 1))
        return glyph

    def width(self, text):
        return sum(self.advance[min(self.glyph.get(ord(c), 0), len(self.advance) - 1)] for c in text) / self.unit


FONTS = {bold: Font(FOLDER + ("DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf")) for bold in (False, True)}


def number(text, usual):
    return float(re.sub("[^0-9.e+-]", "", text)) if text else usual


def place_of(transform):
    """Matrix of translate(x,y) and an optional rotate(angle) behind it."""
    x, y, angle = 0.0, 0.0, 0.0
    for name, values in re.findall(r"(\w+)\(([^)]*)\)", transform or ""):
        v = [float(a) for a in re.split("[ ,]+", values.strip())]
        if name == "translate":
            x, y = x + v[0], y + (v[1] if len(v) > 1 else 0)
        elif name == "rotate":
            angle = v[0]
    return x, y, math.radians(angle)


def box_of(text, size, anchor, place):
    """Words of the text and its corners' extremes on the canvas, or None if it is blank."""
    x, words, low, high = 0.0, "", 0.0, 0.0
    base = 0.0
    for span in text.iter(SVG + "tspan"):
        now = number(span.get("font-size"), size)
        base += number(span.get("dy"), 0.0)
        part = span.text or ""
        if part.strip():
            low, high = min(low, base - CAP * now), max(high, base + DROP * now)
        x += now * FONTS[span.get("font-weight") == "bold"].width(part)
        words += part
    if not words.strip():
        return None
    blank = size * FONTS[False].width(" ")
    left = blank * (len(words) - len(words.lstrip()))
    right = x - blank * (len(words) - len(words.rstrip()))
    shift = {"start": 0, "middle": x / 2, "end": x}[anchor]
    px, py, turn = place
    corners = [(px + math.cos(turn) * u - math.sin(turn) * v, py + math.sin(turn) * u + math.cos(turn) * v)
               for u in (left - shift, right - shift) for v in (low, high)]
    xs, ys = zip(*corners)
    along = [x * math.cos(turn) + y * math.sin(turn) for x, y in corners]
    across = [y * math.cos(turn) - x * math.sin(turn) for x, y in corners]
    return words.strip(), (min(xs), min(ys), max(xs), max(ys)), turn, (min(along), min(across), max(along), max(across))


def boxes(root):
    for group in root.iter(SVG + "g"):
        for text in group.findall(SVG + "text"):
            box = box_of(text, number(group.get("font-size"), 12.0), group.get("text-anchor", "start"),
                         place_of(group.get("transform")))
            if box:
                yield box


def faults_of(path, symbol):
    root = tree.parse(path).getroot()
    _, _, width, height = (float(v) for v in root.get("viewBox").split())
    found = list(boxes(root))
    for words, (x0, y0, x1, y1), _, _ in found:
        if x0 < 0 or y0 < 0 or x1 > width or y1 > height:
            yield "'%s' leaves the canvas: %.0f..%.0f, %.0f..%.0f of %g x %g" % (words, x0, x1, y0, y1, width, height)
    for k, a in enumerate(found):
        for b in found[:k]:
            how = 3 if a[2] == b[2] else 1  # turned alike: along and across the line of text
            low, high = [max(a[how][i], b[how][i]) for i in (0, 1)], [min(a[how][i], b[how][i]) for i in (2, 3)]
            if high[0] - low[0] > 1 and high[1] - low[1] > 1:
                yield "'%s' and '%s' overlap at %.0f, %.0f" % (b[0], a[0], a[1][0], a[1][1])
    if symbol and "Symbol" in open(path, encoding="utf-8").read():
        yield "asks for the font Symbol"


names = [a for a in sys.argv[1:] if a != "--symbol"]
wrong = 0
for name in names:
    for fault in faults_of(name, "--symbol" in sys.argv):
        wrong += 1
        print("%s: %s" % (os.path.basename(name), fault))
print("%d figures, %d faults" % (len(names), wrong))
sys.exit(1 if wrong or not names else 0)

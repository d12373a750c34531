"""Reads the files of sheet packs as a cutter would and rebuilds the foams from them.

Usage: read_sheets.py FOLDER... Each folder holds sheets/, and case.csv with one line:
ny,nz,sy,sz,kerf,spacing,margin,dowel,dowel_edge. Writes rebuilt.csv (half,j,k,first,end) beside it; exits with 1
and says what is wrong where the files contradict themselves. Stands on Python alone, so that it shares nothing
with what wrote the files.
"""

import csv
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

TINY = 2e-3  # mm; the files round to fewer digits


def check(holds, message):
    if not holds:
        raise SystemExit(f"{folder}: {message}")


def length_mm(text):
    check(text.endswith("mm"), f"{text} is no length in mm")
    return float(text[:-2])


def read_svg(path):
    root = ElementTree.parse(path).getroot()
    width, height = length_mm(root.get("width")), length_mm(root.get("height"))
    box = [float(word) for word in root.get("viewBox").replace(",", " ").split()]
    check(box == [0, 0, width, height], f"{path}: one unit is not 1 mm")
    shapes = []
    names = []

    def walk(element, layer):
        tag = element.tag.rpartition("}")[2]
        if tag == "g":
            layer = element.get("id") or layer
            if layer not in names:
                names.append(layer)
            check(element.get("transform") is None, f"{path}: a transform")
        if tag == "path":
            data = element.get("d")
            check(not re.search("[^MLHVZ0-9eE+. ,\\-\n]", data), f"{path}: curves or relative steps: {data[:80]}")
            for part in re.findall("M[^M]*", data):
                shapes.append((layer, "loop" if "Z" in part else "line", points_of(part)))
        if tag in ("polygon", "polyline"):
            numbers = [float(n) for n in re.findall("[-+.0-9eE]+", element.get("points"))]
            shapes.append((layer, "loop" if tag == "polygon" else "line", list(zip(numbers[::2], numbers[1::2]))))
        if tag == "circle":
            shapes.append((layer, "circle", tuple(float(element.get(name)) for name in ("cx", "cy", "r"))))
        for child in element:
            walk(child, layer)

    walk(root, "")
    return (width, height), shapes, names


def points_of(part):
    points = []
    x = y = 0.0
    for command, numbers in re.findall("([MLHV])([^MLHVZ]*)", part):
        values = [float(n) for n in re.findall("[-+]?[.0-9]+(?:[eE][-+]?[0-9]+)?", numbers)]
        if command == "H":
            for x in values:
                points.append((x, y))
        elif command == "V":
            for y in values:
                points.append((x, y))
        else:
            for x, y in zip(values[::2], values[1::2]):
                points.append((x, y))
    return points


def read_dxf(path, height):
    lines = path.read_text("ascii").splitlines()
    pairs = [(int(code), value.strip()) for code, value in zip(lines[::2], lines[1::2])]
    check(pairs[-1] == (0, "EOF"), f"{path}: no end")
    entities = []
    section = None
    variables = {}
    for i, (code, value) in enumerate(pairs):
        if (code, value) == (0, "SECTION"):
            section = pairs[i + 1][1]
        if section == "HEADER" and code == 9:
            variables[value] = pairs[i + 1]
        if section != "ENTITIES":
            continue
        if code == 0:
            entities.append((value, {}))
        elif entities:
            entities[-1][1].setdefault(code, []).append(value)
    # A version that has the unit, and the unit: millimetres.
    check(variables.get("$ACADVER") == (1, "AC1015"), f"{path}: {variables}")
    check(variables.get("$INSUNITS") == (70, "4"), f"{path}: {variables}")
    check(variables.get("$MEASUREMENT") == (70, "1"), f"{path}: {variables}")
    shapes = []
    for kind, values in entities:
        points = [(float(x), height - float(y)) for x, y in zip(values.get(10, []), values.get(20, []))]
        if kind == "LWPOLYLINE":
            check(len(points) == int(values[90][0]), f"{path}: {values[90]} corners")
            shapes.append((values[8][0], "loop" if int(values[70][0]) & 1 else "line", points))
        elif kind == "CIRCLE":
            shapes.append((values[8][0], "circle", (*points[0], float(values[40][0]))))
        else:
            check(kind in ("SECTION", "ENDSEC"), f"{path}: {kind}")
    return shapes


def same_shapes(svg, dxf):
    """The same cuts in both files, in any order."""

    def key(shapes):
        rounded = []
        for layer, kind, points in shapes:
            if layer.startswith("cut") and kind == "loop":
                corners = sorted((round(x, 2), round(y, 2)) for x, y in points)
                rounded.append((layer, kind, len(points), corners))
            elif layer.startswith("cut"):
                rounded.append((layer, kind, 1, [tuple(round(v, 2) for v in points)]))
        return sorted(rounded, key=lambda shape: (shape[0], shape[1], shape[2], shape[3][0]))

    a, b = key(svg), key(dxf)
    if len(a) != len(b):
        return False
    return all(
        p[:3] == q[:3] and all(abs(u - v) < 0.03 for m, n in zip(p[3], q[3]) for u, v in zip(m, n))
        for p, q in zip(a, b)
    )


def signed_area(loop):
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, loop[1:] + loop[:1])) / 2


def contains(loop, x, y):
    inside = False
    for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
        if (ay > y) != (by > y) and x < ax + (y - ay) / (by - ay) * (bx - ax):
            inside = not inside
    return inside


def check_simple(loop, name, kerf):
    """Sides are upright or level and cross no other; brute force, except that side by side needs no look."""
    sides = list(zip(loop, loop[1:] + loop[:1]))
    upright, level = [], []
    for number, ((ax, ay), (bx, by)) in enumerate(sides):
        check(abs(ax - bx) < TINY or abs(ay - by) < TINY, f"{name}: a slanted side")
        check(abs(ax - bx) + abs(ay - by) > TINY, f"{name}: a side without length")
        if abs(ax - bx) < TINY:
            upright.append((number, ax, min(ay, by), max(ay, by)))
        else:
            level.append((number, ay, min(ax, bx), max(ax, bx)))
    check(len(upright) == len(level) and len(sides) >= 4, f"{name}: sides do not alternate")
    for i, x, low, high in upright:
        for j, y, left, right in level:
            next_to = abs(i - j) in (1, len(sides) - 1)
            if not next_to and left - TINY < x < right + TINY and low - TINY < y < high + TINY:
                check(False, f"{name}: crosses or touches itself at {x}, {y}")


class Part:
    def __init__(self, row):
        self.copy = int(row["copy"])
        self.name, self.half = f"{row['piece']} of copy {self.copy}", row["half"]
        self.sheet, self.stock = int(row["sheet"]), int(row["stock"])
        self.x, self.y = float(row["x_mm"]), float(row["y_mm"])
        self.column, self.row = int(row["first_column"]), int(row["first_row"])
        self.columns, self.rows, self.cells = (int(row[name]) for name in ("columns", "rows", "cells"))
        self.point = float(row["point_x_mm"]), float(row["point_y_mm"])
        self.host = row["in_offcut_of"]
        self.outer, self.holes, self.circles = None, [], []

    def kept(self, sy, sz):
        """The cells whose centre the outlines hold: (row, column) in the half as it is seen."""
        crossings = [[] for _ in range(self.rows)]
        for loop in [self.outer, *self.holes]:
            for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
                if abs(ax - bx) < TINY:
                    low, high = min(ay, by), max(ay, by)
                    for row in range(self.rows):
                        if low < self.y + (row + 0.5) * sy < high:
                            crossings[row].append(ax)
        cells = set()
        for row, xs in enumerate(crossings):
            xs.sort()
            check(len(xs) % 2 == 0, f"{self.name}: an outline is open")
            for left, right in zip(xs[::2], xs[1::2]):
                for column in range(self.columns):
                    if left < self.x + (column + 0.5) * sz < right:
                        cells.add((self.row + row, self.column + column))
        return cells


def assign(parts, shapes):
    outer = [loop for layer, kind, loop in shapes if kind == "loop" and signed_area(loop) > 0]
    holes = [loop for layer, kind, loop in shapes if kind == "loop" and signed_area(loop) < 0]
    circles = [circle for layer, kind, circle in shapes if kind == "circle"]
    check(len(outer) == len(parts), f"{len(outer)} outlines for {len(parts)} pieces")

    def innermost(x, y):
        around = [loop for loop in outer if contains(loop, x, y)]
        check(around, f"nothing lies around {x}, {y}")
        return id(min(around, key=signed_area))

    by_outline = {}
    for part in parts:
        found = innermost(*part.point)
        check(found not in by_outline, f"{part.name} has another piece's outline")
        by_outline[found] = part
        part.outer = next(loop for loop in outer if id(loop) == found)
    for hole in holes:
        (ax, ay), (bx, by) = hole[0], hole[1]  # a point of the foam beside the hole's first side
        dx, dy = (bx > ax) - (bx < ax), (by > ay) - (by < ay)
        x, y = (ax + bx) / 2 - dy * 0.01, (ay + by) / 2 + dx * 0.01
        by_outline[innermost(x, y)].holes.append(hole)
    for x, y, radius in circles:
        by_outline[innermost(x, y)].circles.append((x, y, radius))


def check_part(part, cells, case):
    kerf, sy, sz = case["kerf"], case["sy"], case["sz"]
    check(len(cells) == part.cells, f"{part.name}: {len(cells)} cells instead of {part.cells}")
    for loop in [part.outer, *part.holes]:
        check_simple(loop, part.name, kerf)
    # The outlines are the cells' own, moved into the waste by half the kerf: foam area plus a border.
    for loop in [part.outer, *part.holes]:
        for (ax, ay), (bx, by) in zip(loop, loop[1:] + loop[:1]):
            upright = abs(ax - bx) < TINY
            side = (ax - part.x) / sz if upright else (ay - part.y) / sy
            waste = ((by > ay) - (by < ay)) if upright else ((ax > bx) - (ax < bx))
            exact = side - waste * kerf / 2 / (sz if upright else sy)
            check(abs(exact - round(exact)) < TINY, f"{part.name}: a side is not on a cell's edge: {exact}")
    least = case["dowel"] / 2 + case["dowel_edge"]
    for x, y, radius in part.circles:
        check(abs(2 * radius + kerf - case["dowel"]) < TINY, f"{part.name}: a dowel hole of {2 * radius} mm")
        for dx in (-1, 0, 1):
            for dy in (-1, 0, 1):
                column = int((x + dx * (least - TINY) - part.x) // sz) + part.column
                row = int((y + dy * (least - TINY) - part.y) // sy) + part.row
                check((row, column) in cells, f"{part.name}: a dowel hole at the edge of the foam")


def check_layout(parts, kept, size, case):
    """Brute force: no two pieces' foam nearer than kerf + spacing, all within the margins."""
    sy, sz, gap = case["sy"], case["sz"], case["kerf"] + case["spacing"]
    border = case["margin"] + case["kerf"]
    boxes = []
    for part in parts:
        for row, column in kept[part.name]:
            x, y = part.x + (column - part.column) * sz, part.y + (row - part.row) * sy
            boxes.append((x, y, x + sz, y + sy, part.name))
            check(
                x >= border - TINY and y >= border - TINY,
                f"{part.name} lies in the margin",
            )
            check(x + sz <= size[0] - border + TINY and y + sy <= size[1] - border + TINY, f"{part.name} sticks out")
    buckets = {}
    for box in boxes:
        for column in range(int(box[0] // 50), int((box[2] + gap) // 50) + 1):
            for row in range(int(box[1] // 50), int((box[3] + gap) // 50) + 1):
                for other in buckets.setdefault((column, row), []):
                    if other[4] == box[4]:
                        continue
                    apart = max(box[0] - other[2], other[0] - box[2], box[1] - other[3], other[1] - box[3])
                    check(apart > gap - TINY, f"{box[4]} and {other[4]} are {apart} mm apart")
                buckets[(column, row)].append(box)


def check_order(shapes, parts):
    """A cut comes before the cut that frees the foam around it."""
    cuts = [shape for layer in ("cut-inner", "cut-outer") for shape in shapes if shape[0] == layer]
    loops = [loop for layer, kind, loop in cuts if kind == "loop"]
    for first, loop in enumerate(loops):
        for later in loops[first + 1 :]:
            check(not all(contains(loop, x, y) for x, y in later), "a cut follows the cut that frees it")


def read_case(path):
    names = ["ny", "nz", "sy", "sz", "kerf", "spacing", "margin", "dowel", "dowel_edge"]
    return dict(zip(names, (float(value) for value in (path / "case.csv").read_text().split(","))))


def rebuild(path):
    case = read_case(path)
    ny, nz = int(case["ny"]), int(case["nz"])
    with open(path / "sheets" / "index.csv", encoding="utf-8", newline="") as file:
        parts = [Part(row) for row in csv.DictReader(file)]
    check(len({part.name for part in parts}) == len(parts), "a piece stands twice in the index")
    kept = {}
    stocks = sorted(path.glob("sheets/*.svg"))
    check(len(stocks) == max(part.stock for part in parts), "a stock sheet without pieces, or none for some")
    for number, file in enumerate(stocks, 1):
        size, shapes, names = read_svg(file)
        cuts = [layer for layer in names if layer.startswith("cut")]
        check(cuts in (["cut-inner", "cut-outer"], ["cut-outer"]), f"{file}: layers {names}")
        check(same_shapes(shapes, read_dxf(file.with_suffix(".dxf"), size[1])), f"{file}: not what the DXF says")
        here = [part for part in parts if part.stock == number]
        assign(here, [shape for shape in shapes if shape[0].startswith("cut")])
        for part in here:
            kept[part.name] = part.kept(case["sy"], case["sz"])
            check_part(part, kept[part.name], case)
        check_layout(here, kept, size, case)
        check_order(shapes, here)
    copies = [sorted((part.name.split()[0], sorted(kept[part.name])) for part in parts if part.copy == copy)
              for copy in range(1, max(part.copy for part in parts) + 1)]
    check(all(copy == copies[0] for copy in copies), "copies differ")
    parts = [part for part in parts if part.copy == 1]
    check_dowels(parts, case)
    sheets = {}
    for part in parts:
        for row, column in kept[part.name]:
            j = row if part.half == "lower" else ny - 1 - row
            sheets.setdefault((part.half, j, column), []).append(part.sheet)
    with open(path / "rebuilt.csv", "w", encoding="utf-8") as file:
        for half in ("lower", "lid"):
            for j in range(ny):
                for k in range(nz):
                    stack = sorted(sheets.get((half, j, k), []))
                    first = stack[0] - 1 if stack else 0
                    end = first + len(stack)
                    check(stack == list(range(first + 1, end + 1)), f"{half} {j} {k}: sheets {stack}")
                    file.write(f"{half},{j},{k},{first},{end}\n")
    return len(stocks)


def check_dowels(parts, case):
    """The same places in all sheets of a half that have dowels, the first ones without a gap."""
    for half in ("lower", "lid"):
        by_sheet = {}
        for part in parts:
            if part.half != half:
                continue
            places = by_sheet.setdefault(part.sheet, [])
            for x, y, radius in part.circles:
                places.append((x - part.x + part.column * case["sz"], y - part.y + part.row * case["sy"]))
        with_dowels = [sheet for sheet in sorted(by_sheet) if by_sheet[sheet]]
        check(with_dowels == list(range(1, len(with_dowels) + 1)), f"{half}: dowels in sheets {with_dowels}")
        for sheet in with_dowels:
            check(
                len(by_sheet[sheet]) == len(by_sheet[1])
                and all(
                    any(abs(x - a) < TINY and abs(y - b) < TINY for a, b in by_sheet[1]) for x, y in by_sheet[sheet]
                ),
                f"{half}: other dowel holes in sheet {sheet}",
            )


for name in sys.argv[1:]:
    folder = pathlib.Path(name)
    rebuild(folder)

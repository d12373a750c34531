"""What the maps of a pack show, read by nothing of the program's own."""

import re
import xml.etree.ElementTree as ElementTree

NUMBER = re.compile(r"[MLHVZmlhvz]|-?[0-9.]+(?:e-?[0-9]+)?")


def loops_of(path_data):
    """The points of every loop of an SVG path that has straight lines only."""
    loops, at, command, tokens = [], (0.0, 0.0), "", NUMBER.findall(path_data)
    i = 0
    while i < len(tokens):
        if tokens[i].isalpha():
            command = tokens[i]
            i += 1
            if command in "zZ":
                at = loops[-1][0]
                continue
        relative = command.islower()
        x, y = at if relative else (0.0, 0.0)
        if command in "hH":
            at = (x + float(tokens[i]), at[1])
            i += 1
        elif command in "vV":
            at = (at[0], y + float(tokens[i]))
            i += 1
        else:
            at = (x + float(tokens[i]), y + float(tokens[i + 1]))
            i += 2
        if command in "mM":
            loops.append([at])
            command = "l" if relative else "L"
        else:
            loops[-1].append(at)
    return loops


def area_of(loop):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, loop[1:] + loop[:1]))) / 2


class Map:
    """A map at true size: what its layers show, in mm."""

    def __init__(self, path, layer):
        root = ElementTree.parse(path).getroot()
        self.width, self.height = (float(root.get(side).removesuffix("mm")) for side in ("width", "height"))
        self.view = [float(v) for v in root.get("viewBox").split()]
        self.texts = {}
        self.rectangles, edges = [], []

        def walk(node, layer_name):
            name = node.get("{http://www.inkscape.org/namespaces/inkscape}label") or layer_name
            tag = node.tag.split("}")[1]
            if tag == "text":
                self.texts.setdefault("".join(node.itertext()), (float(node.get("x") or 0), float(node.get("y") or 0)))
            if tag == "path" and name == layer and node.get("fill", "none") != "none":
                self.rectangles += loops_of(node.get("d"))
            if tag == "path" and name == "edge":
                edges.append((node, loops_of(node.get("d"))))
            for child in node:
                walk(child, name)

        walk(root, "")
        outline = edges[0][1][0]
        self.left, self.top = min(p[0] for p in outline), min(p[1] for p in outline)
        self.right, self.bottom = max(p[0] for p in outline), max(p[1] for p in outline)
        filled = [loops[0] for node, loops in edges if node.get("fill", "none") != "none"]
        self.odd_corner = filled[0]

    def cells(self, row_mm, column_mm):
        found = set()
        for loop in self.rectangles:
            x0, x1 = min(p[0] for p in loop), max(p[0] for p in loop)
            y0, y1 = min(p[1] for p in loop), max(p[1] for p in loop)
            for row in range(round((y0 - self.top) / row_mm), round((y1 - self.top) / row_mm)):
                for column in range(round((x0 - self.left) / column_mm), round((x1 - self.left) / column_mm)):
                    found.add((row, column))
        return found


def layers_named(path):
    """lower-03.svg: 3 to 3; lid-04-06.svg: 4 to 6."""
    numbers = [int(part) for part in path.stem.split("-")[1:]]
    return numbers[0], numbers[-1]

"""Objects that tests write, by nothing of the program's own."""

import itertools
import struct

# An L of boxes, so that turning and mirroring show.
BOXES = [((0, 0, 0), (120, 40, 30)), ((0, 40, 0), (40, 60, 30))]
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def l_shape():
    vertices, triangles = [], []
    for low, size in BOXES:
        first = len(vertices)
        vertices += [tuple(low[i] + size[i] * bits[2 - i] for i in range(3))
                     for bits in itertools.product((0, 1), repeat=3)]
        for a, b, c, d in QUADS:
            triangles += [(first + a, first + b, first + c), (first + a, first + c, first + d)]
    return vertices, triangles


def write_stl(path, vertices, triangles):
    data = bytes(80) + struct.pack("<I", len(triangles))
    for t in triangles:
        data += struct.pack("<12fH", 0, 0, 0, *(x for v in t for x in vertices[v]), 0)
    path.write_bytes(data)


def write_sparse_stl(path, megabytes):
    """A few triangles and very many that lie in one point, which take no room on the disk."""
    vertices, triangles = l_shape()
    write_stl(path, vertices, triangles)
    count = (megabytes << 20) // 50
    with open(path, "r+b") as file:
        file.truncate(84 + 50 * count)
        file.seek(80)
        file.write(struct.pack("<I", count))


def prism(outline, x0, x1):
    """An OFF file: a polygon in (y, z), from x0 to x1. The caps are fans, so the outline must be star-shaped
    about its first corner."""
    n = len(outline)
    vertices = [(x, y, z) for x in (x0, x1) for y, z in outline]
    faces = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    faces += [(0, i + 1, i) for i in range(1, n - 1)] + [(n, n + i, n + i + 1) for i in range(1, n - 1)]
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"] + ["%g %g %g" % v for v in vertices]
    return "\n".join(lines + [" ".join(map(str, (len(f), *f))) for f in faces]) + "\n"


# An L, its foot towards +z and +y; star-shaped about its inner corner.
LETTER_L = [(10, -10), (10, 40), (40, 40), (40, -40), (-40, -40), (-40, -10)]

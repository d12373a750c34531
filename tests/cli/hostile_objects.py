"""Objects of at most 1 MiB that ask for much more work than their size tells. Each is a function that returns
the bytes of a file for the design space of the program's defaults, 450 x 270 x 396 mm."""

import random
import struct

BYTES = 1 << 20
SIZE = (450, 270, 396)
STL_TRIANGLES = (BYTES - 84) // 50
PLY_FACES = (BYTES - 8192) // 13  # beside a few hundred vertices


def stl(triangles):
    assert len(triangles) <= STL_TRIANGLES
    records = (struct.pack("<12fH", 0, 0, 0, *(c for corner in t for c in corner), 0) for t in triangles)
    return bytes(80) + struct.pack("<I", len(triangles)) + b"".join(records)


def ply(vertices, faces):
    header = (
        f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\n"
        "property float x\nproperty float y\nproperty float z\n"
        f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    points = (struct.pack("<3f", *v) for v in vertices)
    return header.encode() + b"".join(points) + b"".join(struct.pack("<B3i", 3, *f) for f in faces)


def within(numbers, share=0.95):
    return tuple(numbers.uniform(-side / 2, side / 2) * share for side in SIZE)


def coincident_tetrahedra():
    """One tetrahedron as often as the file holds it."""
    corners = [(-200, -120, -180), (200, -120, -180), (-200, 120, -180), (-200, -120, 180)]
    return ply(corners, [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)] * (PLY_FACES // 4))


def layers():
    """Sheets across everything, one close above the other."""
    count = STL_TRIANGLES // 2
    a, b, c, d = (-130, -190), (130, -190), (130, 190), (-130, 190)
    triangles = []
    for i in range(count):
        x = -200 + 400 * i / count
        triangles += [((x, *a), (x, *b), (x, *c)), ((x, *a), (x, *c), (x, *d))]
    return stl(triangles)


def large_triangles(seed):
    numbers = random.Random(seed)
    vertices = [within(numbers) for _ in range(300)]
    return ply(vertices, [numbers.sample(range(300), 3) for _ in range(PLY_FACES)])


def flush_boxes(seed):
    """Boxes whose sides lie on the blocks' faces."""
    numbers = random.Random(seed)
    steps = ((15, 30), (15, 18), (22, 18))  # the default blocks: mm, how many
    triangles = []
    while len(triangles) + 12 <= STL_TRIANGLES:
        ends = [sorted(numbers.sample(range(count + 1), 2)) for _, count in steps]
        low, high = (
            tuple((end[i] - count / 2) * mm for end, (mm, count) in zip(ends, steps)) for i in range(2)
        )
        triangles += box(low, high)
    return stl(triangles)


def box(low, high):
    corners = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])]
    sides = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))
    return [tuple(corners[i] for i in t) for a, b, c, d in sides for t in ((a, b, c), (a, c, d))]

"""Solids as the program writes them, read by nothing of its own."""

import collections
import struct


def read_ply(path):
    """Vertices and triangles of a binary PLY as the program writes it, by nothing of the program's own."""
    header, data = path.read_bytes().split(b"end_header\n", 1)
    counts = [int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")]
    colour = b"red" in header
    step = 15 if colour else 12
    vertices = [struct.unpack_from("<3f", data, i * step) for i in range(counts[0])]
    faces = [struct.unpack_from("<B3i", data, counts[0] * step + i * 13) for i in range(counts[1])]
    assert len(data) == counts[0] * step + counts[1] * 13 and all(face[0] == 3 for face in faces)
    return vertices, [face[1:] for face in faces]


def read_stl(path):
    """The corners of a binary STL's triangles, welded by being equal."""
    data = path.read_bytes()
    count = struct.unpack_from("<I", data, 80)[0]
    assert len(data) == 84 + 50 * count
    triangles = [struct.unpack_from("<12x9f", data, 84 + 50 * i) for i in range(count)]
    return [[tuple(t[i:i + 3]) for i in (0, 3, 6)] for t in triangles]


def edge_balance(triangles):
    """For each undirected edge: how many triangles run each way."""
    ways = collections.defaultdict(lambda: [0, 0])
    for t in triangles:
        for a, b in ((t[0], t[1]), (t[1], t[2]), (t[2], t[0])):
            ways[min(a, b), max(a, b)][a < b] += 1
    return ways.values()


def is_closed(triangles):
    return all(one_way == other_way for one_way, other_way in edge_balance(triangles))


def signed_volume(triangles):
    def determinant(a, b, c):
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return sum(determinant(*t) for t in triangles) / 6

type Point = [number, number, number];

/** A binary STL of triangles. */
export function stl(triangles: [Point, Point, Point][]): Blob {
  const view = new DataView(new ArrayBuffer(84 + triangles.length * 50));
  view.setUint32(80, triangles.length, true);
  triangles.forEach((corners, t) => {
    corners.flat().forEach((value, i) => view.setFloat32(84 + t * 50 + 12 + i * 4, value, true));
  });
  return new Blob([view.buffer]);
}

/** The box from the origin to `size`, closed, outward. */
export function box([x, y, z]: Point): Blob {
  const corner = (bits: number): Point => [bits & 1 ? x : 0, bits & 2 ? y : 0, bits & 4 ? z : 0];
  const faces = [
    [0, 2, 3], [0, 3, 1], [4, 5, 7], [4, 7, 6], [0, 1, 5], [0, 5, 4],
    [2, 6, 7], [2, 7, 3], [0, 4, 6], [0, 6, 2], [1, 3, 7], [1, 7, 5],
  ] as const;
  return stl(faces.map(([a, b, c]) => [corner(a), corner(b), corner(c)]));
}

/** A closed torus of 2 x rings x around triangles with a wavy surface, its axis z. */
export function torus(rings: number, around: number, radius = 90, thickness = 45): Blob {
  const point = (ring: number, step: number): Point => {
    const u = ((ring % rings) / rings) * 2 * Math.PI;
    const v = ((step % around) / around) * 2 * Math.PI;
    const r = radius + thickness * (1 + 0.05 * Math.sin(9 * u)) * Math.cos(v);
    return [r * Math.cos(u), r * Math.sin(u), thickness * Math.sin(v)];
  };
  const triangles: [Point, Point, Point][] = [];
  for (let ring = 0; ring < rings; ring++) {
    for (let step = 0; step < around; step++) {
      const [a, b] = [point(ring, step), point(ring + 1, step)];
      const [c, d] = [point(ring + 1, step + 1), point(ring, step + 1)];
      triangles.push([a, b, c], [a, c, d]);
    }
  }
  return stl(triangles);
}

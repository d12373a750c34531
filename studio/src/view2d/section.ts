import type {DisplayMesh} from '../engine/api';

/** Where the placed mesh meets the plane at `x`: segments (y, z, y, z) after each other, design coordinates; across y
 *  (x, z, x, z). `placement`: column-major 4 x 4. */
export function section(mesh: DisplayMesh, placement: readonly number[], x: number, across: 0 | 1 = 0): Float64Array {
  const placed = placedCoordinates(mesh, placement);
  const segments: number[] = [];
  const {indices} = mesh;
  const others = across === 0 ? [1, 2] : [0, 2];
  const side = (corner: number) => ((placed[(indices[corner] ?? 0) * 3 + across] ?? 0) < x ? 1 : 0);
  for (let i = 0; i < indices.length; i += 3) {
    // Half-open, so that a vertex on the plane belongs to one side only.
    const below = side(i) + side(i + 1) + side(i + 2);
    if (below === 0 || below === 3) continue;
    for (let edge = 0; edge < 3; edge++) {
      const a = (indices[i + edge] ?? 0) * 3;
      const b = (indices[i + ((edge + 1) % 3)] ?? 0) * 3;
      const [xa, xb] = [placed[a + across] ?? 0, placed[b + across] ?? 0];
      if (xa < x === xb < x) continue;
      const t = (x - xa) / (xb - xa);
      for (const axis of others) {
        const from = placed[a + axis] ?? 0;
        segments.push(from + t * ((placed[b + axis] ?? 0) - from));
      }
    }
  }
  return Float64Array.from(segments);
}

/** x, y, z of every vertex in the design space. */
export function placedCoordinates({positions}: DisplayMesh, m: readonly number[]): Float64Array {
  const placed = new Float64Array(positions.length);
  const at = (i: number) => m[i] ?? 0;
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [positions[i] ?? 0, positions[i + 1] ?? 0, positions[i + 2] ?? 0];
    for (let row = 0; row < 3; row++)
      placed[i + row] = at(row) * x + at(row + 4) * y + at(row + 8) * z + at(row + 12);
  }
  return placed;
}

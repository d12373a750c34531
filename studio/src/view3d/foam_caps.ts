import type {Packing} from '../engine/api';

/** A plane through a piece of foam, as it lies in the space: across an axis, mm along it, and which way the cut faces. */
export interface Cut {
  axis: 0 | 1 | 2;
  at: number;
  facing: 1 | -1;
}

export interface Cap {
  positions: Float32Array;
  normals: Int8Array;
  indices: Uint32Array;
}

/** From a cut to the side that is left, so that it is no part of what is taken away. */
const BEHIND_MM = 0.02;

type Rectangle = [x0: number, x1: number, y0: number, y1: number, z0: number, z1: number];

/** The foam that a plane cuts, in the plane; null: it cuts none. */
export function foamCap(packing: Packing, piece: number, {axis, at, facing}: Cut): Cap | null {
  const {blocks, block_mm, pieces} = packing;
  const {first, end} = pieces[piece] ?? {first: [], end: []};
  const [, ny, nz] = blocks;
  const edge = (along: 0 | 1 | 2, number: number) => (number - blocks[along] / 2) * block_mm[along];
  const cell = Math.floor(at / block_mm[axis] + blocks[axis] / 2 - facing * 1e-6);
  if (cell < 0 || cell >= blocks[axis]) return null;
  const plane = at - facing * BEHIND_MM;
  const all: Rectangle[] = [];
  const run = (j: number, k: number): [number, number] => {
    const [low, high] = [first[j * nz + k] ?? 0, end[j * nz + k] ?? 0];
    if (axis > 0) return [low, Math.max(high, low)];
    return low <= cell && cell < high ? [cell, cell + 1] : [0, 0];
  };
  // Cells beside each other that keep the same, as one.
  const line = (count: number, at: (i: number) => [number, number], add: (from: number, to: number, run: [number, number]) => void) => {
    let from = 0;
    for (let i = 1; i <= count; i++) {
      const [low, high] = at(from);
      const next = i < count ? at(i) : [-1, -1];
      if (next[0] === low && next[1] === high) continue;
      if (high > low) add(from, i, [low, high]);
      from = i;
    }
  };
  const alongZ = (j: number, y0: number, y1: number) =>
    line(nz, (k) => run(j, k), (k0, k1, [low, high]) => {
      const [x0, x1] = axis === 0 ? [plane, plane] : [edge(0, low), edge(0, high)];
      all.push([x0, x1, y0, y1, edge(2, k0), edge(2, k1)]);
    });
  if (axis === 0) for (let j = 0; j < ny; j++) alongZ(j, edge(1, j), edge(1, j + 1));
  else if (axis === 1) alongZ(cell, plane, plane);
  else line(ny, (j) => run(j, cell), (j0, j1, [low, high]) => all.push([edge(0, low), edge(0, high), edge(1, j0), edge(1, j1), plane, plane]));
  return all.length > 0 ? arrays(all, axis, facing) : null;
}

function arrays(all: readonly Rectangle[], axis: 0 | 1 | 2, facing: 1 | -1): Cap {
  const positions = new Float32Array(all.length * 12);
  const normals = new Int8Array(all.length * 12);
  const indices = new Uint32Array(all.length * 6);
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  all.forEach((ends, i) => {
    [[0, 0], [1, 0], [1, 1], [0, 1]].forEach(([a, b], corner) => {
      const to = 12 * i + 3 * corner;
      positions[to + axis] = ends[2 * axis]!;
      positions[to + u] = ends[2 * u + a!]!;
      positions[to + v] = ends[2 * v + b!]!;
      normals[to + axis] = 127 * facing;
    });
    indices.set([0, 1, 2, 0, 2, 3].map((corner) => 4 * i + corner), 6 * i);
  });
  return {positions, normals, indices};
}

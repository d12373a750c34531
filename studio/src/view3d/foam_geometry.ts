import type {Triple} from '../design/design';
import type {Packing} from '../engine/api';

// A foam half as quads for drawing: what a person sees of a height field, flat runs merged. The library's solids
// are the true ones; these need no closedness, only looks.

export type Half = 'lower' | 'upper';

export interface Quads {
  /** Four corners a quad, design coordinates. */
  positions: Float32Array;
  /** One outward normal a corner, as signed bytes. */
  normals: Int8Array;
  /** 1 where the quad faces what is cut away; 0 where it faces the case or the other half. */
  inner: Uint8Array;
  indices: Uint32Array;
  /** How many columns each way were drawn as one; 1 if all were drawn. */
  coarsened: number;
}

interface Field {
  ny: number;
  nz: number;
  /** How high a cell reaches from the own side; 0 outside of the space. */
  at(j: number, k: number): number;
  /** Where it begins: above 0 where a case has no room for its outer blocks. */
  base(j: number, k: number): number;
  y(j: number): number;
  z(k: number): number;
  x(height: number): number;
  /** Outward, as the cavity faces. */
  up: 1 | -1;
  /** Whether the block of a column at this height from the own side is cut away. */
  cut(j: number, k: number, height: number): boolean;
  /** One quad a block's face instead of merged runs. */
  split: boolean;
}

/** At most about `mostTriangles`; beyond that neighbouring columns are drawn as one, as deep as the deepest, so
 *  that no cavity vanishes. `split`: one quad for each block's face, for colouring them one by one. */
export function foamQuads(packing: Packing, half: Half, mostTriangles: number, split = false): Quads {
  for (let share = 1; ; share *= 2) {
    const quads = collect(field(packing, half, share, split), mostTriangles / 2);
    if (quads) return {...arrays(quads), coarsened: share};
  }
}

/** The middles of the quads, x, y, z after each other. */
export function quadCentres({positions}: Quads): Float32Array<ArrayBuffer> {
  const centres = new Float32Array(positions.length / 4);
  for (let i = 0; i < centres.length; i++) {
    const first = Math.floor(i / 3) * 12 + (i % 3);
    centres[i] = ((positions[first] ?? 0) + (positions[first + 6] ?? 0)) / 2;
  }
  return centres;
}

function field(packing: Packing, half: Half, share: number, split: boolean): Field {
  const {blocks, block_mm, lower, upper, cutFirst, cutEnd} = packing;
  const [nx, ny, nz] = blocks;
  const [sx, sy, sz] = block_mm;
  const kept = half === 'lower' ? lower : upper;
  const rows = Math.ceil(ny / share);
  const columns = Math.ceil(nz / share);
  const bases = basesOf(packing, half);
  const coarse = share === 1 ? {kept, bases} : keptByAll(kept, bases, ny, nz, share);
  const up = half === 'lower' ? 1 : -1;
  return {
    ny: rows,
    nz: columns,
    at: (j, k) => (j < 0 || k < 0 || j >= rows || k >= columns ? 0 : (coarse.kept[j * columns + k] ?? 0)),
    base: (j, k) => (j < 0 || k < 0 || j >= rows || k >= columns ? 0 : (coarse.bases[j * columns + k] ?? 0)),
    y: (j) => (Math.min(j * share, ny) - ny / 2) * sy,
    z: (k) => (Math.min(k * share, nz) - nz / 2) * sz,
    x: (height) => up * (height - nx / 2) * sx,
    up,
    cut: (j, k, height) => {
      const column = Math.min(j * share, ny - 1) * nz + Math.min(k * share, nz - 1);
      const level = half === 'lower' ? height : nx - 1 - height;
      return level >= (cutFirst[column] ?? 0) && level < (cutEnd[column] ?? 0);
    },
    split,
  };
}

/** Blocks of each column, from the half's side, that a case has no room for; 0 where it keeps none at all. */
function basesOf({blocks, lower, upper, existsFirst, existsEnd}: Packing, half: Half): Uint16Array {
  if (half === 'lower') return lower.map((height, column) => (height > 0 ? (existsFirst[column] ?? 0) : 0));
  return upper.map((height, column) => (height > 0 ? blocks[0] - (existsEnd[column] ?? blocks[0]) : 0));
}

interface Columns {
  kept: Uint16Array;
  bases: Uint16Array;
}

/** What all columns of a cell keep. */
function keptByAll(kept: Uint16Array, bases: Uint16Array, ny: number, nz: number, share: number): Columns {
  const columns = Math.ceil(nz / share);
  const size = Math.ceil(ny / share) * columns;
  const coarse = {kept: new Uint16Array(size).fill(0xffff), bases: new Uint16Array(size)};
  for (let j = 0; j < ny; j++) {
    const row = Math.floor(j / share) * columns;
    for (let k = 0; k < nz; k++) {
      const cell = row + Math.floor(k / share);
      coarse.kept[cell] = Math.min(coarse.kept[cell] ?? 0, kept[j * nz + k] ?? 0);
      coarse.bases[cell] = Math.max(coarse.bases[cell] ?? 0, bases[j * nz + k] ?? 0);
    }
  }
  for (let cell = 0; cell < size; cell++)
    if ((coarse.bases[cell] ?? 0) >= (coarse.kept[cell] ?? 0)) coarse.bases[cell] = coarse.kept[cell] = 0;
  return coarse;
}

interface Quad {
  corners: [Triple, Triple, Triple, Triple];
  normal: Triple;
  inner: boolean;
}

/** Null as soon as there are more than `most`. */
function collect(f: Field, most: number): Quad[] | null {
  const quads: Quad[] = [];
  for (let j = 0; j <= f.ny; j++) {
    addFlats(quads, f, j);
    addStepsAlongZ(quads, f, j);
    if (quads.length > most) return null;
  }
  for (let k = 0; k <= f.nz; k++) {
    addStepsAlongY(quads, f, k);
    if (quads.length > most) return null;
  }
  return quads;
}

/** Calls use(first, end) for each run of equal values, or for each value. */
function runs(
  count: number,
  split: boolean,
  value: (i: number) => number,
  use: (first: number, end: number) => void,
) {
  let first = 0;
  for (let i = 1; i <= count; i++) {
    if (!split && i < count && value(i) === value(first)) continue;
    use(first, i);
    first = i;
  }
}

/** Floors of the cavity, and the side that lies on the case. */
function addFlats(quads: Quad[], f: Field, j: number) {
  if (j === f.ny) return;
  const flat = (height: number, first: number, end: number, normal: 1 | -1, inner: boolean) => {
    const x = f.x(height);
    quads.push({
      corners: [
        [x, f.y(j), f.z(first)],
        [x, f.y(j + 1), f.z(first)],
        [x, f.y(j + 1), f.z(end)],
        [x, f.y(j), f.z(end)],
      ],
      normal: [normal, 0, 0],
      inner,
    });
  };
  runs(
    f.nz,
    f.split,
    (k) => f.at(j, k),
    (first, end) => {
      const height = f.at(j, first);
      if (height > 0) flat(height, first, end, f.up, f.cut(j, first, height));
    },
  );
  runs(
    f.nz,
    false,
    (k) => (f.at(j, k) > 0 ? 1 + f.base(j, k) : 0),
    (first, end) => {
      if (f.at(j, first) > 0) flat(f.base(j, first), first, end, f.up === 1 ? -1 : 1, false);
    },
  );
}

/** Walls between row j - 1 and row j. */
function addStepsAlongZ(quads: Quad[], f: Field, j: number) {
  const step = (k: number) => pairOf(f, [j - 1, k], [j, k]);
  runs(f.nz, f.split, step, (first, end) => {
    eachStep(f, [j - 1, first], [j, first], (a, b, height, before) =>
      quads.push({
        corners: [
          [a, f.y(j), f.z(first)],
          [b, f.y(j), f.z(first)],
          [b, f.y(j), f.z(end)],
          [a, f.y(j), f.z(end)],
        ],
        normal: [0, before ? 1 : -1, 0],
        inner: j > 0 && j < f.ny && f.cut(before ? j : j - 1, first, height),
      }),
    );
  });
}

/** Walls between column k - 1 and column k. */
function addStepsAlongY(quads: Quad[], f: Field, k: number) {
  const step = (j: number) => pairOf(f, [j, k - 1], [j, k]);
  runs(f.ny, f.split, step, (first, end) => {
    eachStep(f, [first, k - 1], [first, k], (a, b, height, before) =>
      quads.push({
        corners: [
          [a, f.y(first), f.z(k)],
          [b, f.y(first), f.z(k)],
          [b, f.y(end), f.z(k)],
          [a, f.y(end), f.z(k)],
        ],
        normal: [0, 0, before ? 1 : -1],
        inner: k > 0 && k < f.nz && f.cut(first, before ? k : k - 1, height),
      }),
    );
  });
}

type At = [j: number, k: number];

/** One number for what two neighbours keep. */
function pairOf(f: Field, ...cells: [At, At]): number {
  return cells.reduce((sum, [j, k]) => (sum * 4097 + f.at(j, k)) * 4097 + f.base(j, k), 0);
}

/** The walls between two neighbours, where one has foam and the other none, whole or block by block: use(x, x, the
 *  lower height, whether the first of them has the foam). */
function eachStep(
  f: Field,
  one: At,
  other: At,
  use: (a: number, b: number, height: number, before: boolean) => void,
) {
  const wall = (low: number, high: number, before: boolean) => {
    const by = f.split ? 1 : high - low;
    for (let height = low; height < high; height += by) use(f.x(height), f.x(height + by), height, before);
  };
  for (const [foam, beside, before] of [
    [one, other, true],
    [other, one, false],
  ] as const) {
    const [base, top] = [f.base(...foam), f.at(...foam)];
    const [besideBase, besideTop] = [f.base(...beside), f.at(...beside)];
    if (besideTop === 0) wall(base, top, before);
    else {
      wall(base, Math.min(top, besideBase), before);
      wall(Math.max(base, besideTop), top, before);
    }
  }
}

function arrays(quads: Quad[]): Omit<Quads, 'coarsened'> {
  const positions = new Float32Array(quads.length * 12);
  const normals = new Int8Array(quads.length * 12);
  const inner = new Uint8Array(quads.length * 4);
  const indices = new Uint32Array(quads.length * 6);
  quads.forEach(({corners, normal, inner: faces}, quad) => {
    corners.forEach((corner, i) => {
      positions.set(corner, quad * 12 + i * 3);
      normals.set(
        normal.map((n) => n * 127),
        quad * 12 + i * 3,
      );
    });
    inner.fill(faces ? 1 : 0, quad * 4, quad * 4 + 4);
    const first = quad * 4;
    indices.set([first, first + 1, first + 2, first, first + 2, first + 3], quad * 6);
  });
  return {positions, normals, inner, indices};
}

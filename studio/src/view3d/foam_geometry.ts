import type {Triple} from '../design/design';
import type {Packing, Runs} from '../engine/api';
import {isCut, kindOf} from '../engine/pieces';

// A piece of foam as quads for drawing: what a person sees of a field of runs, flat ones merged. The library's solids
// are the true ones; these need no closedness, only looks.

export interface Quads {
  /** Four corners a quad, design coordinates. */
  positions: Float32Array;
  /** One outward normal a corner, as signed bytes. */
  normals: Int8Array;
  /** 1 where the quad faces what is cut away; 0 where it faces the case or another piece. */
  inner: Uint8Array;
  indices: Uint32Array;
  /** How many columns each way were drawn as one; 1 if all were drawn. */
  coarsened: number;
}

interface Field {
  ny: number;
  nz: number;
  /** The run of levels that a cell keeps; 0 to 0 where that is none, and outside of the space. */
  first(j: number, k: number): number;
  end(j: number, k: number): number;
  x(level: number): number;
  y(j: number): number;
  z(k: number): number;
  /** Whether the block of a cell at this level is cut away. */
  cut(j: number, k: number, level: number): boolean;
  /** One quad a block's face instead of merged runs, where items may lie: what faces the case stays merged. */
  split: {below: boolean; beside: boolean; above: boolean};
}

/** `piece`: counted from the lowest. At most about `mostTriangles`; beyond that neighbouring columns are drawn as one,
 *  which keeps what all of them keep, so that no cavity vanishes. `split`: one quad for each block's face, for colouring
 *  them one by one. */
export function foamQuads(packing: Packing, piece: number, mostTriangles: number, split = false): Quads {
  for (let share = 1; ; share *= 2) {
    const quads = collect(field(packing, piece, share, split), mostTriangles / 2);
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

function field(packing: Packing, piece: number, share: number, split: boolean): Field {
  const {blocks, block_mm, pieces} = packing;
  const [nx, ny, nz] = blocks;
  const [sx, sy, sz] = block_mm;
  const kept = pieces[piece]!;
  const rows = Math.ceil(ny / share);
  const columns = Math.ceil(nz / share);
  const {first, end} = share === 1 ? kept : keptByAll(kept, ny, nz, share);
  const within = (j: number, k: number) => j >= 0 && k >= 0 && j < rows && k < columns;
  const kind = kindOf(packing, piece);
  return {
    ny: rows,
    nz: columns,
    first: (j, k) => (within(j, k) ? (first[j * columns + k] ?? 0) : 0),
    end: (j, k) => (within(j, k) ? (end[j * columns + k] ?? 0) : 0),
    x: (level) => (level - nx / 2) * sx,
    y: (j) => (Math.min(j * share, ny) - ny / 2) * sy,
    z: (k) => (Math.min(k * share, nz) - nz / 2) * sz,
    cut: (j, k, level) => isCut(packing, Math.min(j * share, ny - 1) * nz + Math.min(k * share, nz - 1), level),
    split: {below: split && kind !== 'lower', beside: split, above: split && kind !== 'upper'},
  };
}

/** What all columns of a cell keep. */
function keptByAll(kept: Runs, ny: number, nz: number, share: number): Runs {
  const columns = Math.ceil(nz / share);
  const size = Math.ceil(ny / share) * columns;
  const all = {first: new Int16Array(size), end: new Int16Array(size).fill(0x7fff)};
  for (let j = 0; j < ny; j++) {
    const row = Math.floor(j / share) * columns;
    for (let k = 0; k < nz; k++) {
      const cell = row + Math.floor(k / share);
      all.first[cell] = Math.max(all.first[cell] ?? 0, kept.first[j * nz + k] ?? 0);
      all.end[cell] = Math.min(all.end[cell] ?? 0, kept.end[j * nz + k] ?? 0);
    }
  }
  for (let cell = 0; cell < size; cell++)
    if ((all.first[cell] ?? 0) >= (all.end[cell] ?? 0)) all.first[cell] = all.end[cell] = 0;
  return all;
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

/** What faces down, and what faces up: floors of cavities, and the side that lies on the case. */
function addFlats(quads: Quad[], f: Field, j: number) {
  if (j === f.ny) return;
  const flat = (level: number, first: number, end: number, normal: 1 | -1, inner: boolean) => {
    const x = f.x(level);
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
  const isKept = (k: number) => f.end(j, k) > f.first(j, k);
  runs(
    f.nz,
    f.split.above,
    (k) => (isKept(k) ? f.end(j, k) : -1),
    (first, end) => {
      const level = f.end(j, first);
      if (isKept(first)) flat(level, first, end, 1, f.cut(j, first, level));
    },
  );
  runs(
    f.nz,
    f.split.below,
    (k) => (isKept(k) ? f.first(j, k) : -1),
    (first, end) => {
      const level = f.first(j, first);
      if (isKept(first)) flat(level, first, end, -1, f.cut(j, first, level - 1));
    },
  );
}

/** Walls between row j - 1 and row j. */
function addStepsAlongZ(quads: Quad[], f: Field, j: number) {
  const step = (k: number) => pairOf(f, [j - 1, k], [j, k]);
  runs(f.nz, f.split.beside, step, (first, end) => {
    eachStep(f, [j - 1, first], [j, first], (a, b, level, before) =>
      quads.push({
        corners: [
          [a, f.y(j), f.z(first)],
          [b, f.y(j), f.z(first)],
          [b, f.y(j), f.z(end)],
          [a, f.y(j), f.z(end)],
        ],
        normal: [0, before ? 1 : -1, 0],
        inner: j > 0 && j < f.ny && f.cut(before ? j : j - 1, first, level),
      }),
    );
  });
}

/** Walls between column k - 1 and column k. */
function addStepsAlongY(quads: Quad[], f: Field, k: number) {
  const step = (j: number) => pairOf(f, [j, k - 1], [j, k]);
  runs(f.ny, f.split.beside, step, (first, end) => {
    eachStep(f, [first, k - 1], [first, k], (a, b, level, before) =>
      quads.push({
        corners: [
          [a, f.y(first), f.z(k)],
          [b, f.y(first), f.z(k)],
          [b, f.y(end), f.z(k)],
          [a, f.y(end), f.z(k)],
        ],
        normal: [0, 0, before ? 1 : -1],
        inner: k > 0 && k < f.nz && f.cut(first, before ? k : k - 1, level),
      }),
    );
  });
}

type At = [j: number, k: number];

/** One number for what two neighbours keep. */
function pairOf(f: Field, ...cells: [At, At]): number {
  return cells.reduce((sum, [j, k]) => (sum * 4097 + f.end(j, k)) * 4097 + f.first(j, k), 0);
}

/** The walls between two neighbours, where one has foam and the other none, whole or block by block: use(x, x, the
 *  lowest level, whether the first of them has the foam). */
function eachStep(
  f: Field,
  one: At,
  other: At,
  use: (a: number, b: number, level: number, before: boolean) => void,
) {
  const wall = (low: number, high: number, before: boolean) => {
    const by = f.split.beside ? 1 : high - low;
    for (let level = low; level < high; level += by) use(f.x(level), f.x(level + by), level, before);
  };
  for (const [foam, beside, before] of [
    [one, other, true],
    [other, one, false],
  ] as const) {
    const [first, end] = [f.first(...foam), f.end(...foam)];
    const [besideFirst, besideEnd] = [f.first(...beside), f.end(...beside)];
    if (besideEnd === 0) wall(first, end, before);
    else {
      wall(first, Math.min(end, besideFirst), before);
      wall(Math.max(first, besideEnd), end, before);
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

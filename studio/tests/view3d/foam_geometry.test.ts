import {describe, expect, it} from 'vitest';
import type {Triple} from '../../src/design/design';
import type {Packing, Runs} from '../../src/engine/api';
import {foamQuads, quadCentres, type Quads} from '../../src/view3d/foam_geometry';
import {layeredPacking} from '../support/layers';
import {numbers, packingOf} from '../support/packing';

/** What the quads enclose, by the divergence theorem; their normals say where outside is. */
function volume({positions, normals}: Quads): number {
  let sum = 0;
  for (let quad = 0; quad < positions.length; quad += 12) {
    const corner = (i: number) => [0, 1, 2].map((axis) => positions[quad + i * 3 + axis] ?? 0);
    const [a, b, c] = [corner(0), corner(1), corner(3)];
    const u = b.map((value, i) => value - (a[i] ?? 0)) as Triple;
    const v = c.map((value, i) => value - (a[i] ?? 0)) as Triple;
    const area = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    const along = [0, 1, 2].reduce((total, axis) => total + (a[axis] ?? 0) * ((normals[quad + axis] ?? 0) / 127), 0);
    sum += (area * along) / 3;
  }
  return sum;
}

describe('the drawn foams', () => {
  it('enclose exactly the kept blocks, merged or block by block', () => {
    for (let seed = 1; seed <= 40; seed++) {
      const number = numbers(seed);
      const blocks: Triple = [1 + number(9), 1 + number(9), 1 + number(9)];
      const block_mm: Triple = [1 + number(20), 1 + number(20), 1 + number(20)];
      const kept = Array.from({length: blocks[1] * blocks[2]}, () => number(blocks[0] + 1));
      const other = kept.map((lower) => number(blocks[0] - lower + 1));
      const packing = packingOf(blocks, block_mm, kept, other);
      const block = block_mm[0] * block_mm[1] * block_mm[2];
      for (const [piece, field] of [kept, other].entries()) {
        const wanted = field.reduce((a, b) => a + b, 0) * block;
        for (const split of [false, true]) {
          const quads = foamQuads(packing, piece, 1e9, split);
          expect(volume(quads), `seed ${seed}, ${piece}, split ${split}`).toBeCloseTo(wanted, 3);
          expect(quadCentres(quads).length).toBe(quads.positions.length / 4);
        }
      }
    }
  });

  it('begin where a case has room for the first block', () => {
    for (let seed = 1; seed <= 40; seed++) {
      const number = numbers(seed);
      const blocks: Triple = [2 + number(8), 1 + number(9), 1 + number(9)];
      const block_mm: Triple = [1 + number(20), 1 + number(20), 1 + number(20)];
      const nx = blocks[0];
      const exists = Array.from({length: blocks[1] * blocks[2]}, () => {
        const first = number(nx);
        return [first, first + 1 + number(nx - first)] as const;
      });
      const lower = exists.map(([first, end]) => (number(4) === 0 ? 0 : first + 1 + number(end - first)));
      const upper = exists.map(([first, end], i) => {
        const from = Math.max(first, lower[i] ?? 0); // of the lid, in design levels
        return from < end ? nx - from : 0;
      });
      const packing = packingOf(blocks, block_mm, lower, upper, exists);
      const block = block_mm[0] * block_mm[1] * block_mm[2];
      const kept = [
        exists.map(([first], i) => ((lower[i] ?? 0) > 0 ? (lower[i] ?? 0) - first : 0)),
        exists.map(([, end], i) => ((upper[i] ?? 0) > 0 ? (upper[i] ?? 0) - (nx - end) : 0)),
      ];
      for (const [piece, field] of kept.entries())
        for (const split of [false, true]) {
          const wanted = field.reduce((a, b) => a + b, 0) * block;
          expect(volume(foamQuads(packing, piece, 1e9, split)), `seed ${seed}, ${piece}, split ${split}`).toBeCloseTo(wanted, 3);
        }
    }
  });

  it('stay below the wanted number of triangles, and never fill a cavity', () => {
    const number = numbers(7);
    const kept = Array.from({length: 64 * 64}, () => number(40));
    const packing = packingOf([40, 64, 64], [5, 5, 5], kept, kept.map(() => 0));
    const whole = foamQuads(packing, 0, 1e9);
    const few = foamQuads(packing, 0, 3000);
    expect(whole.coarsened).toBe(1);
    expect(few.coarsened).toBeGreaterThan(1);
    expect(few.indices.length / 3).toBeLessThanOrEqual(3000);
    expect(volume(few)).toBeLessThan(volume(whole));
  });

  it('show every face of every piece once, whatever lies between or whether a lid closes it', () => {
    for (let seed = 1; seed <= 40; seed++) {
      const packing = layeredPacking(seed, 3, seed % 2 === 0);
      packing.pieces.forEach((runs, piece) => {
        const wanted = exposed(packing, runs);
        for (const split of [false, true]) {
          const quads = foamQuads(packing, piece, 1e9, split);
          expect(unitFaces(packing, quads).map(({face}) => face).sort(), `seed ${seed}, piece ${piece}, split ${split}`).toEqual(wanted);
          expect(quads.coarsened).toBe(1);
        }
      });
    }
  });

  it('tell which faces a cavity has, block by block', () => {
    for (let seed = 1; seed <= 40; seed++) {
      const packing = layeredPacking(seed, 3, seed % 2 === 0);
      packing.pieces.forEach((_, piece) => {
        for (const {face, beyond, inner} of unitFaces(packing, foamQuads(packing, piece, 1e9, true)))
          expect(inner, `seed ${seed}, piece ${piece}, ${face}`).toBe(isCutAway(packing, beyond));
      });
    }
  });
});

/** A face of a block: the axis and the way that it faces, and the block. */
const named = (axis: number, way: number, block: readonly number[]) => `${axis} ${way} ${block.join(' ')}`;

function neighbour(block: readonly number[], axis: number, way: number): Triple {
  return block.map((at, i) => at + (i === axis ? way : 0)) as Triple;
}

const isKept = ({blocks: [, ny, nz]}: Packing, {first, end}: Runs, [i, j, k]: Triple) =>
  j >= 0 && k >= 0 && j < ny && k < nz && i >= first[j * nz + k]! && i < end[j * nz + k]!;

/** By hand: within the space, up to the surface of a tray, a block that exists and that no piece keeps. */
function isCutAway(packing: Packing, [i, j, k]: Triple): boolean {
  const [nx, ny, nz] = packing.blocks;
  const top = packing.open ? packing.partingLevels.at(-1)! : nx;
  if (i < 0 || j < 0 || k < 0 || i >= top || j >= ny || k >= nz) return false;
  return isKept(packing, packing.exists, [i, j, k]) && packing.pieces.every((runs) => !isKept(packing, runs, [i, j, k]));
}

/** The faces of a piece's blocks that no block of its own covers. */
function exposed(packing: Packing, runs: Runs): string[] {
  const [nx, ny, nz] = packing.blocks;
  const faces: string[] = [];
  for (let column = 0; column < ny * nz; column++)
    for (let i = 0; i < nx; i++) {
      const block: Triple = [i, Math.floor(column / nz), column % nz];
      if (!isKept(packing, runs, block)) continue;
      for (const axis of [0, 1, 2])
        for (const way of [-1, 1]) if (!isKept(packing, runs, neighbour(block, axis, way))) faces.push(named(axis, way, block));
    }
  return faces.sort();
}

/** Quads as the faces of blocks that they cover; `beyond`: the block that such a face looks at. */
function unitFaces({blocks, block_mm}: Packing, {positions, normals, inner}: Quads): {face: string; beyond: Triple; inner: boolean}[] {
  const level = (at: number, axis: number) => Math.round((positions[at + axis] ?? 0) / block_mm[axis]! + blocks[axis]! / 2);
  return Array.from({length: positions.length / 12}, (_, quad) => {
    const corners = [0, 1, 2, 3].map((corner) => quad * 12 + corner * 3);
    const low = [0, 1, 2].map((axis) => Math.min(...corners.map((at) => level(at, axis))));
    const high = [0, 1, 2].map((axis) => Math.max(...corners.map((at) => level(at, axis))));
    const axis = [0, 1, 2].find((each) => normals[quad * 12 + each] !== 0)!;
    const way = Math.sign(normals[quad * 12 + axis]!);
    if (way > 0) low[axis]! -= 1;
    else high[axis]! += 1;
    const faces = [];
    for (let i = low[0]!; i < high[0]!; i++)
      for (let j = low[1]!; j < high[1]!; j++)
        for (let k = low[2]!; k < high[2]!; k++) {
          const block: Triple = [i, j, k];
          faces.push({face: named(axis, way, block), beyond: neighbour(block, axis, way), inner: inner[quad * 4] === 1});
        }
    return faces;
  }).flat();
}

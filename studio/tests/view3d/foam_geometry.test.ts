import {describe, expect, it} from 'vitest';
import type {Triple} from '../../src/design/design';
import {foamQuads, quadCentres, type Quads} from '../../src/view3d/foam_geometry';
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
      for (const [half, field] of [['lower', kept], ['upper', other]] as const) {
        const wanted = field.reduce((a, b) => a + b, 0) * block;
        for (const split of [false, true]) {
          const quads = foamQuads(packing, half, 1e9, split);
          expect(volume(quads), `seed ${seed}, ${half}, split ${split}`).toBeCloseTo(wanted, 3);
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
      const packing = packingOf(blocks, block_mm, lower, upper);
      packing.existsFirst = Int16Array.from(exists.map(([first]) => first));
      packing.existsEnd = Int16Array.from(exists.map(([, end]) => end));
      const block = block_mm[0] * block_mm[1] * block_mm[2];
      const kept = {
        lower: exists.map(([first], i) => ((lower[i] ?? 0) > 0 ? (lower[i] ?? 0) - first : 0)),
        upper: exists.map(([, end], i) => ((upper[i] ?? 0) > 0 ? (upper[i] ?? 0) - (nx - end) : 0)),
      };
      for (const half of ['lower', 'upper'] as const)
        for (const split of [false, true]) {
          const wanted = kept[half].reduce((a, b) => a + b, 0) * block;
          expect(volume(foamQuads(packing, half, 1e9, split)), `seed ${seed}, ${half}, split ${split}`).toBeCloseTo(wanted, 3);
        }
    }
  });

  it('stay below the wanted number of triangles, and never fill a cavity', () => {
    const number = numbers(7);
    const kept = Array.from({length: 64 * 64}, () => number(40));
    const packing = packingOf([40, 64, 64], [5, 5, 5], kept, kept.map(() => 0));
    const whole = foamQuads(packing, 'lower', 1e9);
    const few = foamQuads(packing, 'lower', 3000);
    expect(whole.coarsened).toBe(1);
    expect(few.coarsened).toBeGreaterThan(1);
    expect(few.indices.length / 3).toBeLessThanOrEqual(3000);
    expect(volume(few)).toBeLessThan(volume(whole));
  });
});

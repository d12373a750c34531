import {expect, test} from 'vitest';
import type {Triple} from '../../src/design/design';
import {foamCap} from '../../src/view3d/foam_caps';
import {numbers, packingOf} from '../support/packing';

/** Of rectangles across an axis. */
function area({positions}: {positions: Float32Array}, axis: number): number {
  let sum = 0;
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  for (let quad = 0; quad < positions.length; quad += 12)
    sum += (positions[quad + 6 + u]! - positions[quad + u]!) * (positions[quad + 6 + v]! - positions[quad + v]!);
  return sum;
}

test('a cut through foam is as large as the blocks that it meets, and lies in its plane', () => {
  for (let seed = 1; seed <= 60; seed++) {
    const number = numbers(seed);
    const blocks: Triple = [1 + number(7), 1 + number(7), 1 + number(7)];
    const block_mm: Triple = [1 + number(20), 1 + number(20), 1 + number(20)];
    const lower = Array.from({length: blocks[1] * blocks[2]}, () => number(blocks[0] + 1));
    const upper = lower.map((height) => number(blocks[0] - height + 1));
    const packing = packingOf(blocks, block_mm, lower, upper);
    for (const axis of [0, 1, 2] as const)
      for (const piece of [0, 1]) {
        const cell = number(blocks[axis]);
        const at = (cell + 0.5 - blocks[axis] / 2) * block_mm[axis];
        let met = 0;
        for (let i = 0; i < blocks[0]; i++)
          for (let j = 0; j < blocks[1]; j++)
            for (let k = 0; k < blocks[2]; k++) {
              const column = j * blocks[2] + k;
              const there = piece === 0 ? i < lower[column]! : i >= blocks[0] - upper[column]!;
              if (there && [i, j, k][axis] === cell) met++;
            }
        const cap = foamCap(packing, piece, {axis, at, facing: 1});
        const block = (block_mm[0] * block_mm[1] * block_mm[2]) / block_mm[axis];
        expect(cap ? area(cap, axis) : 0).toBeCloseTo(met * block, 1);
        if (cap) for (let i = axis; i < cap.positions.length; i += 3) expect(cap.positions[i]).toBeCloseTo(at, 1);
      }
  }
});

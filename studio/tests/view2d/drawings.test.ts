import {describe, expect, it} from 'vitest';
import {blocksToRemove, cellAt, cellCorner, fromPage, layOut, mapsOf, shownBy, toPage} from '../../src/view2d/page';
import {section} from '../../src/view2d/section';
import {layeredPacking} from '../support/layers';
import {packingOf, piecesPacking} from '../support/packing';

const packing = packingOf([4, 3, 5], [10, 20, 8], new Array<number>(15).fill(2), new Array<number>(15).fill(2));

describe('which way round', () => {
  it('the lower foam and slices have k to the right and j downward, BACK at the top', () => {
    for (const drawing of ['lower', 'slice'] as const) {
      const page = layOut(packing, drawing, 300, 400, 10);
      const [first, right, down] = [cellCorner(page, 0, 0), cellCorner(page, 0, 1), cellCorner(page, 1, 0)];
      expect(right.x).toBeGreaterThan(first.x);
      expect(down.y).toBeGreaterThan(first.y);
      const [, back] = toPage(page, packing)(-30, 0);
      expect(back).toBeCloseTo(page.top);
    }
  });

  it('the lid has k to the right and j upward, BACK at the bottom: an L turns over, as folded paper does', () => {
    const page = layOut(packing, 'lid', 300, 400, 10);
    const [first, right, up] = [cellCorner(page, 0, 0), cellCorner(page, 0, 1), cellCorner(page, 1, 0)];
    expect(right.x).toBeGreaterThan(first.x);
    expect(up.y).toBeLessThan(first.y);
    const [, back] = toPage(page, packing)(-30, 0);
    expect(back).toBeCloseTo(page.top + page.height);
    // Folded over the BACK edge, every cell lies on its own place of the lower foam.
    const lower = layOut(packing, 'lower', 300, 400, 10);
    for (let j = 0; j < 3; j++)
      for (let k = 0; k < 5; k++) {
        const [a, b] = [cellCorner(lower, j, k), cellCorner(page, j, k)];
        expect(b.x).toBeCloseTo(a.x);
        expect(b.y + page.cellHeight - (page.top + page.height)).toBeCloseTo(-(a.y - lower.top));
      }
  });

  it('an upright section has k to the right and levels upward, and cuts what lies there', () => {
    const page = layOut(packing, 'upright', 300, 400, 10);
    const [first, right, up] = [cellCorner(page, 0, 0), cellCorner(page, 0, 1), cellCorner(page, 1, 0)];
    expect(right.x).toBeGreaterThan(first.x);
    expect(up.y).toBeLessThan(first.y);
    expect(page.cellHeight / page.cellWidth).toBeCloseTo(10 / 8);
    const [, top] = toPage(page, packing)(20, 0);
    expect(top).toBeCloseTo(page.top);
    expect(fromPage(page, packing, ...toPage(page, packing)(7, -3))).toEqual([expect.closeTo(7), expect.closeTo(-3)]);
  });

  it('a pointer finds the cell that is drawn under it, and blocks keep their proportions', () => {
    for (const drawing of ['lower', 'lid'] as const) {
      const page = layOut(packing, drawing, 500, 200, 12);
      expect(page.cellHeight / page.cellWidth).toBeCloseTo(20 / 8);
      for (let j = 0; j < 3; j++)
        for (let k = 0; k < 5; k++) {
          const {x, y} = cellCorner(page, j, k);
          expect(cellAt(page, x + page.cellWidth / 2, y + page.cellHeight / 2)).toEqual({j, k});
        }
      expect(cellAt(page, page.left - 1, page.top + 1)).toBeNull();
    }
  });
});

describe('maps', () => {
  it('say how many blocks to remove from the highest column', () => {
    const packing = packingOf([9, 2, 2], [1, 1, 1], [7, 4, 7, 0], [2, 2, 2, 2]);
    expect(blocksToRemove(packing, 0, 'above')).toEqual(Int16Array.from([0, 3, 0, 7]));
  });

  it('count no block that a case has no room for', () => {
    const packing = packingOf([9, 2, 2], [1, 1, 1], [7, 4, 0, 0], [2, 2, 0, 0], [[0, 9], [2, 9], [3, 8], [9, 9]]);
    // From 7 levels: the second column has 4 and 5 and 6 to lose, the third 3 to 6, the last has no blocks.
    expect(blocksToRemove(packing, 0, 'above')).toEqual(Int16Array.from([0, 3, 4, 0]));
    expect(blocksToRemove(packing, 1, 'below')).toEqual(Int16Array.from([0, 0, 1, 0]));
  });

  it('of a piece between two layers tell from each side what is taken out there, and a hole from both', () => {
    const nothing = [[0, 0], [0, 0], [0, 0]] as const;
    const packing = piecesPacking([9, 1, 3], [1, 1, 1], [nothing, [[2, 6], [3, 5], [0, 0]], nothing], [[0, 9], [0, 9], [0, 9]]);
    expect(mapsOf(packing)).toEqual(['lower', 'middle-1-above', 'middle-1-below', 'lid']);
    expect(shownBy('middle-1-below', packing)).toEqual({piece: 1, kind: 'middle', from: 'below'});
    expect(blocksToRemove(packing, 1, 'above')).toEqual(Int16Array.from([0, 1, 4]));
    expect(blocksToRemove(packing, 1, 'below')).toEqual(Int16Array.from([0, 1, 4]));
    expect(blocksToRemove(packing, 1, 'both')).toEqual(Int16Array.from([0, 2, 4]));
  });

  it('of both sides are what the piece does not keep of its whole block, whatever the case', () => {
    for (let seed = 1; seed <= 40; seed++) {
      const packing = layeredPacking(seed, 3, seed % 2 === 0);
      packing.pieces.forEach(({first, end}, piece) => {
        const [above, below, both] = (['above', 'below', 'both'] as const).map((from) => blocksToRemove(packing, piece, from)) as [Int16Array, Int16Array, Int16Array];
        both.forEach((remove, column) => {
          const through = first[column]! >= end[column]!;
          expect(through ? [above[column], below[column]] : above[column]! + below[column]!, `seed ${seed}`).toEqual(through ? [remove, remove] : remove);
        });
      });
    }
  });

  it('of a tray are those of the pieces that there are', () => {
    expect(mapsOf(layeredPacking(1, 1, true))).toEqual(['lower']);
    expect(mapsOf(layeredPacking(1, 2, true))).toEqual(['lower', 'middle-1-above', 'middle-1-below']);
    expect(mapsOf(null)).toEqual(['lower', 'lid']);
  });
});

describe('the section of the object', () => {
  it('through a box is its outline, whatever the placement', () => {
    const box = {
      positions: Float32Array.from([0, 1].flatMap((x) => [0, 1].flatMap((y) => [0, 1].flatMap((z) => [x, y, z])))),
      indices: Uint32Array.from([4, 5, 7, 4, 7, 6, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1]),
      deviation: 0,
    };
    // x, y, z of the object become z, x, y of the space, twice as large and shifted.
    const placement = [0, 2, 0, 0, 0, 0, 2, 0, 2, 0, 0, 0, -1, 5, 7, 1];
    const segments = section(box, placement, 0);
    let length = 0;
    for (let i = 0; i < segments.length; i += 4) {
      const [y0 = 0, z0 = 0, y1 = 0, z1 = 0] = segments.slice(i, i + 4);
      length += Math.hypot(y1 - y0, z1 - z0);
      for (const y of [y0, y1]) expect(y).toBeGreaterThanOrEqual(5 - 1e-9);
      for (const y of [y0, y1]) expect(y).toBeLessThanOrEqual(7 + 1e-9);
    }
    expect(length).toBeCloseTo(8);
    expect(section(box, placement, 1.5)).toHaveLength(0);
  });
});

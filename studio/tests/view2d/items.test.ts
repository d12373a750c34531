import {expect, test} from 'vitest';
import type {Triple} from '../../src/design/design';
import {tooNear} from '../../src/state/findings';
import {fromPage, held, itemAt, itemsIn, layOut, toPage} from '../../src/view2d/page';
import {packingOf} from '../support/packing';

// Items in the plan.

const spaceOf = (ny: number, nz: number) => packingOf([4, ny, nz], [15, 15, 22], Array(ny * nz).fill(0), Array(ny * nz).fill(0));
const box = (min: Triple, max: Triple) => ({...spaceOf(1, 1).items[0]!, bounds: {min, max}});

test('a place on the page is the place in the space that is drawn there', () => {
  const packing = spaceOf(6, 9);
  for (const drawing of ['slice', 'lid'] as const) {
    const page = layOut(packing, drawing, 300, 400, 20);
    const [x, y] = toPage(page, packing)(-31, 47);
    const [backY, backZ] = fromPage(page, packing, x, y);
    expect(backY).toBeCloseTo(-31, 9);
    expect(backZ).toBeCloseTo(47, 9);
  }
});

test('under a hand is the item whose box is there, the smaller one of two', () => {
  const items = [box([0, -40, -40], [10, 40, 40]), box([0, 0, 0], [10, 20, 20]), box([0, 0, 60], [10, 20, 80])];
  const packing = {...spaceOf(6, 9), items};
  expect(itemAt(packing, 10, 10, [0, 1, 2])).toBe(1);
  expect(itemAt(packing, -10, 10, [0, 1, 2])).toBe(0);
  expect(itemAt(packing, 10, 70, [0, 1, 2])).toBe(2);
  expect(itemAt(packing, 10, 90, [0, 1, 2])).toBeNull();
  expect(itemAt(packing, 10, 10, [0, 2])).toBe(0);
});

test('a drawing tells of the items that lie against what it shows', () => {
  const lying = (layer: number, from: number, to: number) => ({...box([from, 0, 0], [to, 9, 9]), layer});
  const items = [lying(1, -40, -10), lying(2, -15, 30), lying(1, -40, -30), lying(3, 35, 60)];
  const packing = {...spaceOf(6, 9), items};
  expect(itemsIn(packing, 'lower', 0)).toEqual([0, 2]);
  expect(itemsIn(packing, 'middle-1-below', 0)).toEqual([0, 2]);
  expect(itemsIn(packing, 'middle-1-above', 0)).toEqual([1]);
  expect(itemsIn({...packing, pieces: Array(4).fill(packing.pieces[0])}, 'lid', 0)).toEqual([3]);
  expect(itemsIn(packing, 'slice', -12)).toEqual([0, 1, 2]);
  expect(itemsIn(packing, 'slice', 31)).toEqual([1]);
  expect(itemsIn(packing, 'slice', 500)).toEqual([3]);
  // Of one layer all of them, however high the section lies.
  expect(itemsIn({...packing, items: items.map((item) => ({...item, layer: 1}))}, 'slice', 500)).toEqual([0, 1, 2, 3]);
});

test('a space that is centred anew stays where it was under the hand that moves an item', () => {
  const [from, to] = [spaceOf(6, 9), spaceOf(7, 12)];
  for (const drawing of ['lower', 'lid'] as const) {
    const page = layOut(from, drawing, 300, 400, 20);
    // What lay at (5, -30) lies at (-2, -63) now.
    const now = held(page, from, to, [0, -7, -33]);
    const [before, after] = [toPage(page, from)(5, -30), toPage(now, to)(-2, -63)];
    expect(after[0]).toBeCloseTo(before[0], 9);
    expect(after[1]).toBeCloseTo(before[1], 9);
    expect(now.cellWidth).toBeCloseTo(page.cellWidth, 9);
  }
});

test('too near are the items that such findings name, and no others', () => {
  const finding = (code: string, items?: number[]) => ({severity: 'danger', code, message: ['', ''], where: null, items}) as const;
  const findings = [finding('items_near', [0, 2]), finding('items_overlap', [2, 3]), finding('outside', [1]), finding('no_floor')];
  expect([...tooNear(findings as never)].sort()).toEqual([0, 2, 3]);
});

import {Box3, Vector3} from 'three';
import {describe, expect, test} from 'vitest';
import type {Packing} from '../../src/engine/api';
import {apart, levelsOf} from '../../src/view3d/apart';
import {piecesPacking, type Run} from '../support/packing';

// Where pieces of foam and items are drawn while the foams are opened.

const EXISTS: Run[] = [[0, 10], [0, 10], [0, 10], [0, 10]];
const columns = (...runs: Run[]) => runs;
const pair = piecesPacking([10, 2, 2], [10, 20, 20], [columns([0, 6], [0, 6], [0, 2], [0, 6]), columns([6, 10], [6, 10], [7, 10], [6, 10])], EXISTS);
const stack = piecesPacking(
  [10, 2, 2],
  [10, 20, 20],
  [columns([0, 3], [0, 3], [0, 1], [0, 3]), columns([3, 7], [3, 7], [4, 5], [3, 7]), columns([7, 10], [7, 10], [8, 10], [7, 10])],
  EXISTS,
);

function drawn(packing: Packing, opening: number): Box3[] {
  const {piece} = apart(packing, 'book', opening);
  return levelsOf(packing).map(([low, high], number) => new Box3(new Vector3(low, -20, -20), new Vector3(high, 20, 20)).applyMatrix4(piece(number)));
}

describe('an opened book', () => {
  test.each([['two pieces', pair], ['a stack', stack]] as const)('has %s on one ground, one behind the other', (_, packing) => {
    const boxes = drawn(packing, 1);
    for (const [i, {min, max}] of boxes.entries()) {
      expect(min.x).toBeCloseTo(-50);
      expect([min.z, max.z].map(Math.round)).toEqual([-20, 20]);
      if (i > 0) expect(max.y).toBeLessThan(boxes[i - 1]!.min.y);
    }
  });

  test('shows the cavity of its lid, and the items where they lie', () => {
    const {piece, layer} = apart(pair, 'book', 1);
    const [low] = levelsOf(pair)[1]!;
    // What faced the lower half is the lid's upper side, and its edge at the back is next to the lower half's.
    const edge = new Vector3(low, -20, 5).applyMatrix4(piece(1));
    expect(edge.x).toBeCloseTo(-50 + 40);
    expect(edge.y).toBeCloseTo(-20 - 0.08 * 40);
    expect(edge.z).toBeCloseTo(5);
    expect(layer(1).length()).toBeCloseTo(0);
    const [first, second] = [apart(stack, 'book', 1).layer(2), apart(stack, 'book', 1).piece(1)];
    expect(new Vector3().applyMatrix4(second).distanceTo(first)).toBeCloseTo(0);
  });

  test('is closed as it lies, and its lid passes over the lower half', () => {
    for (const [i, {min, max}] of drawn(pair, 0).entries()) expect([min.x, max.x].map(Math.round)).toEqual(levelsOf(pair)[i]!.map(Math.round));
    const edge = new Vector3(50, 20, 0).applyMatrix4(apart(pair, 'book', 0.5).piece(1));
    expect(edge.x).toBeGreaterThan(30);
  });
});

test('above each other, items are halfway between the pieces around them', () => {
  for (const packing of [pair, stack]) {
    const {piece, layer, corners} = apart(packing, 'above', 1);
    const at = (number: number) => new Vector3().applyMatrix4(piece(number)).x;
    for (let number = 1; number < packing.pieces.length; number++) {
      expect(at(number) - at(number - 1)).toBeGreaterThan(50);
      expect(layer(number).x).toBeCloseTo((at(number) + at(number - 1)) / 2);
    }
    const [low, high] = [Math.min(...corners.map(({x}) => x)), Math.max(...corners.map(({x}) => x))];
    expect(low).toBeCloseTo(at(0) - 50);
    expect(high).toBeCloseTo(at(packing.pieces.length - 1) + 50);
  }
});

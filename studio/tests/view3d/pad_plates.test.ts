import {Box3, Matrix4, type Object3D, Vector3} from 'three';
import {beforeEach, expect, test, vi} from 'vitest';
import type {PackedPad} from '../../src/engine/fit';
import {PadPlates} from '../../src/view3d/pad_plates';

// Pads in the 3D view: each where it lies, with its piece of foam.

const PADS: PackedPad[] = [
  {item: 0, piece: 0, above: false, box: {min: [-40, -30, 10], max: [-34, 10, 70]}, text: ['', '']},
  {item: 0, piece: 1, above: true, box: {min: [20, 0, -50], max: [24, 40, -20]}, text: ['', '']},
];
let plates: PadPlates;

beforeEach(() => {
  vi.stubGlobal('document', {createElement: () => ({getContext: () => null})});
  plates = new PadPlates();
  plates.show(PADS, (piece) => (piece === 0 ? 'lower' : 'upper'));
});

function drawn() {
  plates.group.updateMatrixWorld(true);
  return plates.group.children.map((lift) => new Box3().setFromObject(lift.children[0]!));
}
const number = (plate: number) => plates.group.children[plate]!.children[1]!;

/** Where a direction of the number's own points. */
function points(label: Object3D, own: [number, number, number]): number[] {
  return new Vector3(...own).applyQuaternion(label.quaternion).toArray().map((each) => Math.round(each) + 0);
}

test('plates fill the boxes of pads and go with their piece', () => {
  plates.place((piece) => new Matrix4().makeTranslation(100 * piece, 0, 0));
  for (const [i, {min, max}] of drawn().entries()) {
    const [low, high] = [PADS[i]!.box.min, PADS[i]!.box.max];
    expect(min.toArray()).toEqual([low[0] + 100 * i, low[1], low[2]].map((mm) => expect.closeTo(mm) as number));
    expect(max.toArray()).toEqual([high[0] + 100 * i, high[1], high[2]].map((mm) => expect.closeTo(mm) as number));
  }
});

test('numbers face the item, and are read as maps are: z to the right', () => {
  expect([0, 1].map((i) => points(number(i), [1, 0, 0]))).toEqual([[0, 0, 1], [0, 0, 1]]);
  expect([0, 1].map((i) => points(number(i), [0, 0, 1]))).toEqual([[1, 0, 0], [-1, 0, 0]]);
  expect(number(0).position.x).toBeGreaterThan(-34);
  expect(number(1).position.x).toBeLessThan(20);
});

test('plates are hidden with the foam that they lie on, and gone with the pads', () => {
  plates.looks = {lower: 'hidden', middle: 'shown', upper: 'glass'};
  expect(plates.group.children.map(({visible}) => visible)).toEqual([false, true]);
  plates.show(PADS.slice(1), () => 'upper');
  expect(plates.group.children).toHaveLength(1);
  plates.show([], () => 'upper');
  expect(plates.group.children).toHaveLength(0);
});

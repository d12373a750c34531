import {beforeAll, expect, test} from 'vitest';
import {errorIn, FIRST_SHAPE, KINDS, nextSolid, shapeText, type Shape} from '../../src/design/shape';
import type {EngineCore} from '../../src/engine/core';
import {isFailure} from '../../src/engine/failure';
import {good, startCore} from '../support/snug';

// What the library makes of these texts is tested beside the state that opens them.

const CAMERA = 'box 143x87x40 r5 + cylinder 63x60 at 0,0,50';

let core: EngineCore;
beforeAll(async () => {
  core = await startCore();
});

async function read(text: string): Promise<Shape> {
  return {solids: good(await core.parseShape(text)).solids, error_mm: errorIn(text)};
}

test('what was written is read back, every solid with all that it has', async () => {
  let shape: Shape = FIRST_SHAPE;
  for (const kind of KINDS) shape = {...shape, solids: [...shape.solids, nextSolid(kind, shape)]};
  const turned = shape.solids.map((solid, i) => ({...solid, turn: [10 * i, -0.5, 0] as [number, number, number]}));
  const rounded = turned.map((solid) => (solid.kind === 'box' ? {...solid, radius: 2.5} : solid));
  const pointing = rounded.map((solid) => (solid.kind === 'cone' ? {...solid, along: 'x' as const} : solid));
  for (const solids of [shape.solids, turned, rounded, pointing]) {
    const all = {...shape, solids, error_mm: 1.5};
    expect(await read(shapeText(all))).toEqual(all);
  }
});

test('what people write is read, too', async () => {
  expect(await read(CAMERA)).toEqual({
    error_mm: 0,
    solids: [
      {kind: 'box', size: [143, 87, 40], radius: 5, along: 'z', turn: [0, 0, 0], at: [0, 0, 0]},
      {kind: 'cylinder', size: [63, 60], radius: 0, along: 'z', turn: [0, 0, 0], at: [0, 0, 50]},
    ],
  });
  expect(shapeText(await read(CAMERA))).toBe(`${CAMERA}\n`);
  expect((await read('# a lens\nCone 80 X 0 x 120 along X at 1, -2, .5 # its tip\n')).solids).toEqual([
    {kind: 'cone', size: [80, 0, 120], radius: 0, along: 'x', turn: [0, 0, 0], at: [1, -2, 0.5]},
  ]);
});

test.each(['', 'box 1x2', 'ball 3x4', 'cube 1x2x3', 'box 1x2x3 at 1,2', 'box 1x2x3 +', 'box 1x2x3 cylinder 4x5'])('%j is no shape', async (text) => {
  expect(isFailure(await core.parseShape(text))).toBe(true);
});

test('another solid stands on top of the last one', () => {
  const [box] = FIRST_SHAPE.solids;
  const next = nextSolid('cylinder', FIRST_SHAPE);
  expect(next.at[2] - next.size[1]! / 2).toBe(box!.size[2]! / 2);
});

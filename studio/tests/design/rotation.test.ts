import {Quaternion, Vector3} from 'three';
import {describe, expect, it} from 'vitest';
import type {Triple} from '../../src/design/design';
import {angles, quarterTurned, quaternion, sideDown, SIDES, sideThatIsDown} from '../../src/design/rotation';
import {numbers} from '../support/packing';
import {good, startCore} from '../support/snug';

const TURNS: Triple[] = Array.from({length: 50}, (_, seed) => {
  const number = numbers(seed + 1);
  return [number(360) - 180, number(360) - 180, number(360) - 180];
});

describe('rotations', () => {
  it('are the library’s', async () => {
    const core = await startCore();
    const sample = good(await core.sampleFile('torus'));
    const design = await core.defaultDesign();
    await core.load(sample.name, new Blob([sample.bytes]), design.object);
    for (const rotation_deg of TURNS.slice(0, 12)) {
      const packing = good(await core.pack({...design, placement: {...design.placement, rotation_deg}}));
      const axes = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
      axes.forEach((axis, column) => {
        const turned = axis.applyQuaternion(quaternion(rotation_deg)).toArray();
        turned.forEach((value, row) => expect(packing.items[0]!.placement[column * 4 + row]).toBeCloseTo(value, 9));
      });
    }
  });

  it('come back from their angles', () => {
    for (const turn of TURNS) {
      const again = quaternion(angles(quaternion(turn)));
      expect(again.angleTo(quaternion(turn))).toBeLessThan(1e-4);
    }
  });

  it('four quarter turns are none, and there is one for each axis', () => {
    for (const turn of TURNS)
      for (const axis of [0, 1, 2] as const) {
        const once = quaternion(quarterTurned(turn, axis, 1));
        expect(once.angleTo(quaternion(turn))).toBeCloseTo(Math.PI / 2, 4);
        let four = turn;
        for (let i = 0; i < 4; i++) four = quarterTurned(four, axis, 1);
        expect(quaternion(four).angleTo(quaternion(turn))).toBeLessThan(1e-3);
        expect(quaternion(quarterTurned(quarterTurned(turn, axis, 1), axis, -1)).angleTo(quaternion(turn))).toBeLessThan(1e-3);
      }
  });

  it('put the named side down, and say which one is', () => {
    for (const turn of TURNS)
      for (const side of SIDES) {
        const down = sideDown(turn, side);
        expect(sideThatIsDown(down)).toBe(side);
        expect(down.every((degrees) => degrees % 90 === 0)).toBe(true);
        expect(sideDown(down, side)).toEqual(down);
        expect(quaternion(down)).toBeInstanceOf(Quaternion);
      }
  });
});

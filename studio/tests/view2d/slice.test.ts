import {expect, test} from 'vitest';
import {layerAt, middleOf} from '../../src/view2d/page';
import {numbers} from '../support/packing';

test('a slice keeps its height as near as its blocks allow, whatever they become', () => {
  const number = numbers(7);
  for (let i = 0; i < 200; i++) {
    const space = () => ({blocks: [1 + Math.floor(number(40)), 1, 1], block_mm: [0.5 + number(30), 1, 1]}) as Parameters<typeof layerAt>[1];
    const [before, after] = [space(), space()];
    const layer = Math.floor(number(before.blocks[0]));
    const height = middleOf(layer, before);
    expect(layerAt(height, before)).toBe(layer);
    const there = layerAt(height, after);
    const off = Math.abs(middleOf(there, after) - height);
    for (let other = 0; other < after.blocks[0]; other++)
      expect(Math.abs(middleOf(other, after) - height)).toBeGreaterThanOrEqual(off - 1e-9);
  }
});

import {describe, expect, it} from 'vitest';
import type {Triple} from '../../src/design/design';
import {thumbnail} from '../../src/picture/thumbnail';

describe('a thumbnail', () => {
  // A plate of 100 x 60 x 10 mm, x y z.
  const plate = () => {
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((i) => [i & 1 ? 50 : -50, i & 2 ? 30 : -30, i & 4 ? 5 : -5]);
    const quads = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    const indices = quads.flatMap(([a, b, c, d]) => [a!, b!, c!, a!, c!, d!]);
    return {positions: new Float32Array(corners), indices: new Uint32Array(indices), deviation: 0};
  };
  const extent = (rotation: Triple) => {
    const {pixels, size} = thumbnail(plate(), rotation, 64, [230, 220, 200]);
    const rows = new Set<number>();
    const columns = new Set<number>();
    for (let i = 0; i < size * size; ++i) {
      if (pixels[4 * i + 3] === 0) continue;
      rows.add(Math.floor(i / size));
      columns.add(i % size);
    }
    return {height: rows.size, width: columns.size};
  };

  it('fills its frame and stands upright where x is up', () => {
    const upright = extent([0, 0, 0]);
    expect(upright.height).toBeGreaterThan(52);
    expect(upright.height).toBeGreaterThan(upright.width);
    const lying = extent([0, 90, 0]);
    expect(lying.width).toBeGreaterThan(52);
  });
});

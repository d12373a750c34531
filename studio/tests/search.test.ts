import {describe, expect, it} from 'vitest';
import type {Triple} from '../src/engine/api';
import {colourOf} from '../src/search/scale';
import {fromDisc, near, nearest, onDisc} from '../src/search/sphere';
import {thumbnail} from '../src/search/thumbnail';

describe('the map of directions', () => {
  it('has every direction and its opposite in one place, and gives it back', () => {
    for (let i = 0; i < 500; ++i) {
      const z = 1 - (i + 0.5) / 250;
      const around = i * 2.399963;
      const wide = Math.sqrt(1 - z * z);
      const direction: Triple = [wide * Math.cos(around), wide * Math.sin(around), z];
      const at = onDisc(direction);
      const opposite = onDisc(direction.map((value) => -value) as Triple);
      expect(opposite[0]).toBeCloseTo(at[0], 9);
      expect(opposite[1]).toBeCloseTo(at[1], 9);
      const back = fromDisc(...at)!;
      const along = back.reduce((sum, value, axis) => sum + value * direction[axis]!, 0);
      expect(Math.abs(along)).toBeCloseTo(1, 9);
    }
  });

  it('gives equal parts of the sphere equal areas', () => {
    // The cap above 30 degrees of latitude is half of the half sphere.
    const [right] = onDisc([Math.sqrt(3) / 2, 0, 0.5]);
    expect(right * right).toBeCloseTo(0.5, 9);
    expect(fromDisc(0.8, 0.7)).toBeNull();
  });

  it('finds the nearest direction, whichever way it points', () => {
    const directions = new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1]);
    expect(nearest(directions, [-0.9, 0.3, 0.1])).toBe(0);
    expect(nearest(directions, [0.1, 0.2, -0.8])).toBe(2);
  });

  it('says nothing where no direction is near, as on a map that has none yet', () => {
    const directions = new Float32Array([1, 0, 0, 0, 1, 0]);
    expect(near(directions, [-0.99, 0.1, 0])).toBe(0);
    expect(near(directions, [0, 0, 1])).toBeNull();
    expect(near(new Float32Array(), [0, 0, 1])).toBeNull();
  });

  it('gets lighter all the way', () => {
    const lightness = Array.from({length: 50}, (_, i) => colourOf(i / 49).reduce((sum, value, channel) => sum + value * [0.2, 0.7, 0.1][channel]!, 0));
    for (let i = 1; i < lightness.length; ++i) expect(lightness[i]).toBeGreaterThan(lightness[i - 1]!);
  });
});

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

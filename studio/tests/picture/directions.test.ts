import {describe, expect, it} from 'vitest';
import type {Triple} from '../../src/design/design';
import {colourOf} from '../../src/picture/scale';
import {fromDisc, near, nearest, onDisc} from '../../src/picture/sphere';
import {nearestSpots, painted} from '../../src/picture/spots';

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

  /** As the library spreads them, but for `left_out`, which do not fit. */
  const spread = (count: number, left_out: (i: number) => boolean) =>
    new Float32Array(
      Array.from({length: count}, (_, i) => i)
        .filter((i) => !left_out(i))
        .flatMap((i) => {
          const x = (i + 0.5) / count;
          const [r, around] = [Math.sqrt(1 - x * x), 2 * Math.PI * ((0.618034 * i) % 1)];
          return [x, r * Math.cos(around), r * Math.sin(around)];
        }),
    );

  it('gives each pixel its nearest direction, and none where none is near', () => {
    const size = 90;
    for (const directions of [spread(500, () => false), spread(500, (i) => i % 7 < 5 || i > 400), spread(3, () => false), new Float32Array()]) {
      const spots = nearestSpots(directions, size);
      spots.forEach((spot, at) => {
        const direction = fromDisc((2 * (at % size) + 1) / size - 1, 1 - (2 * Math.floor(at / size) + 1) / size);
        const wanted = direction && near(directions, direction);
        const along = (i: number) => Math.abs(direction!.reduce((sum, value, axis) => sum + value * directions[3 * i + axis]!, 0));
        if (wanted === null) expect(spot).toBe(-1);
        // Two may be as near but for rounding.
        else expect(along(spot)).toBeCloseTo(along(wanted), 6);
      });
    }
  });

  it('is painted in a small part of what asking each pixel takes, as often as it grows', () => {
    const directions = spread(500, () => false);
    const [size, part] = [360, 8];
    const seconds = (work: () => void) => {
      const began = performance.now();
      work();
      return performance.now() - began;
    };
    // In turns, so that both meet whatever else runs on this machine.
    const ratios = Array.from({length: 7}, () => {
      const painting = seconds(() => painted(nearestSpots(directions, size), new Float32Array(500)));
      const asking = seconds(() => {
        for (let row = 0; row < size; row += part)
          for (let column = 0; column < size; ++column) {
            const direction = fromDisc((2 * column + 1) / size - 1, 1 - (2 * row + 1) / size);
            if (direction) near(directions, direction);
          }
      });
      return painting / (part * asking);
    });
    expect(ratios.sort((a, b) => a - b)[3]).toBeLessThan(0.2);
  });

  it('gets lighter all the way', () => {
    const lightness = Array.from({length: 50}, (_, i) => colourOf(i / 49).reduce((sum, value, channel) => sum + value * [0.2, 0.7, 0.1][channel]!, 0));
    for (let i = 1; i < lightness.length; ++i) expect(lightness[i]).toBeGreaterThan(lightness[i - 1]!);
  });
});

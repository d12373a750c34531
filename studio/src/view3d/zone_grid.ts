import type {Triple} from '../design/design';
import type {Ball} from '../design/zones';

/** How deep places lie within balls: of the chosen zone and of the others, 128 on a ball's skin, x fastest. */
export interface ZoneGrid {
  size: Triple;
  /** Corner and extent, in the object's own mm. */
  low: Triple;
  extent: Triple;
  /** Two a cell: others, chosen. */
  depths: Uint8Array<ArrayBuffer>;
}

/** What a picture card takes in a moment, and every one of them. */
const MOST_CELLS = 1_500_000;
const MOST_ALONG = 250;
/** Of the smallest ball's radius, where there is room. */
const FINE = 3;
/** Cells from nothing to full. */
const BAND = 4;

/** `origin`: where the object's (0, 0, 0) lies in the balls' coordinates. None without balls. */
export function zoneGrid(zones: readonly (readonly Ball[])[], chosen: number | null, origin: Readonly<Triple>): ZoneGrid | null {
  const all = zones.flat();
  if (all.length === 0) return null;
  const ends = [0, 1, 2].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (const ball of all) {
      low = Math.min(low, ball[axis]! - ball[3] - origin[axis]!);
      high = Math.max(high, ball[axis]! + ball[3] - origin[axis]!);
    }
    return [low, high] as const;
  });
  const lengths = ends.map(([low, high]) => high - low);
  const smallest = all.reduce((least, ball) => Math.min(least, ball[3]), Infinity);
  const cell = Math.max(
    smallest / FINE,
    Math.max(...lengths) / (MOST_ALONG - 2 * BAND),
    Math.cbrt(lengths.reduce((product, length) => product * length, 1) / MOST_CELLS),
  );
  const size = lengths.map((length) => Math.ceil(length / cell) + BAND) as Triple;
  const low = ends.map(([end]) => end - (cell * BAND) / 2) as Triple;
  const depths = new Uint8Array(2 * size[0] * size[1] * size[2]);
  zones.forEach((balls, i) => {
    for (const [x, y, z, r] of balls) fill(depths, size, cell, [x - origin[0] - low[0], y - origin[1] - low[1], z - origin[2] - low[2]], r, i === chosen ? 1 : 0);
  });
  return {size, low, extent: size.map((count) => count * cell) as Triple, depths};
}

function fill(depths: Uint8Array, [nx, ny, nz]: Triple, cell: number, [x, y, z]: Triple, radius: number, which: 0 | 1) {
  const reach = radius + (BAND / 2) * cell;
  const from = (at: number) => Math.max(0, Math.floor((at - reach) / cell));
  const to = (at: number, n: number) => Math.min(n - 1, Math.ceil((at + reach) / cell));
  const slope = 255 / (BAND * cell);
  for (let k = from(z); k <= to(z, nz); k++)
    for (let j = from(y); j <= to(y, ny); j++) {
      const [dy, dz] = [(j + 0.5) * cell - y, (k + 0.5) * cell - z];
      const beside = dy * dy + dz * dz;
      if (beside > reach * reach) continue;
      const half = Math.sqrt(reach * reach - beside);
      const first = Math.max(0, Math.floor((x - half) / cell));
      const last = Math.min(nx - 1, Math.ceil((x + half) / cell));
      for (let i = first; i <= last; i++) {
        const at = 2 * (i + nx * (j + ny * k)) + which;
        if (depths[at] === 255) continue;
        const dx = (i + 0.5) * cell - x;
        const depth = 127.5 + (radius - Math.sqrt(beside + dx * dx)) * slope;
        if (depth > depths[at]!) depths[at] = Math.min(depth, 255);
      }
    }
}

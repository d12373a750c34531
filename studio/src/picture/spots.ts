import {colourOf} from './scale';
import {NEAR} from './sphere';

// Which direction each pixel of the map belongs to. A scan of all directions for each pixel would keep the page busy for
// half a second; each direction has only a small part of the disc, and looks at no other.

const WIDE = Math.acos(NEAR);

/** For each pixel, row by row, the number of the nearest direction; -1 beside the disc, and where none is near. */
export function nearestSpots(directions: Float32Array, size: number): Int32Array {
  const pixels = pixelDirections(size);
  const spots = new Int32Array(size * size).fill(-1);
  const along = new Float32Array(size * size).fill(NEAR);
  for (let i = 0; i < directions.length / 3; ++i) {
    const [x, y, z] = [directions[3 * i]!, directions[3 * i + 1]!, directions[3 * i + 2]!];
    // Near the rim its opposite lies on the disc, too.
    for (const way of [1, -1]) if (way * z > -WIDE) claim(i, way * x, way * y, way * z, pixels, spots, along, size);
  }
  return spots;
}

/** The pixels around a direction that lie nearer to it than to those before. */
function claim(
  spot: number,
  x: number,
  y: number,
  z: number,
  pixels: Float32Array,
  spots: Int32Array,
  along: Float32Array,
  size: number,
) {
  const scale = 1 / Math.sqrt(1 + z);
  // The projection stretches the more the farther from its middle.
  const reach = WIDE / Math.sqrt(1 + Math.cos(Math.acos(Math.min(z, 1)) + WIDE));
  const pixel = (place: number) => Math.min(Math.max(((place + 1) * size) / 2, 0), size);
  const [top, bottom] = [Math.floor(pixel(-y * scale - reach)), Math.ceil(pixel(-y * scale + reach))];
  for (let row = top; row < bottom; ++row) {
    const upward = 1 - (2 * row + 1) / size - y * scale;
    const half = Math.sqrt(Math.max(0, reach * reach - upward * upward)) + 2 / size;
    const last = row * size + Math.ceil(pixel(x * scale + half));
    for (let at = row * size + Math.floor(pixel(x * scale - half)); at < last; ++at) {
      const own = Math.abs(pixels[3 * at]! * x + pixels[3 * at + 1]! * y + pixels[3 * at + 2]! * z);
      if (own > along[at]! || (own === along[at] && spots[at] === -1)) {
        along[at] = own;
        spots[at] = spot;
      }
    }
  }
}

/** Red, green, blue, opacity of each pixel; clear where no direction is near. `shares`: of each direction, 0 to 1. */
export function painted(spots: Int32Array, shares: Float32Array): Uint8ClampedArray<ArrayBuffer> {
  const colours = new Uint8ClampedArray(4 * shares.length);
  shares.forEach((share, i) => colours.set([...colourOf(share), 255], 4 * i));
  const words = new Uint32Array(colours.buffer);
  const picture = new Uint32Array(spots.length);
  for (let at = 0; at < spots.length; ++at) if (spots[at]! >= 0) picture[at] = words[spots[at]!]!;
  return new Uint8ClampedArray(picture.buffer);
}

const known = new Map<number, Float32Array>();

/** The direction in the middle of each pixel, x, y, z after each other; 0, 0, 0 beside the disc. */
function pixelDirections(size: number): Float32Array {
  const before = known.get(size);
  if (before) return before;
  const all = new Float32Array(3 * size * size);
  for (let at = 0; at < size * size; ++at) {
    const right = (2 * (at % size) + 1) / size - 1;
    const up = 1 - (2 * Math.floor(at / size) + 1) / size;
    const square = right * right + up * up;
    if (square > 1) continue;
    const scale = Math.sqrt(2 - square);
    all[3 * at] = right * scale;
    all[3 * at + 1] = up * scale;
    all[3 * at + 2] = 1 - square;
  }
  known.set(size, all);
  return all;
}

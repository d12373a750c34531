import type {Triple} from '../design/design';

// Directions of insertion, as the object has them. Up and down cut the same blocks, so half a sphere says it
// all: it is drawn as a disc on which equal areas of the sphere have equal areas (Lambert's projection).

/** Where a direction (or its opposite) lies on a disc of radius 1 around (0, 0); x to the right, y upward. */
export function onDisc([x, y, z]: Triple): [number, number] {
  const up = z < 0 || (z === 0 && (y < 0 || (y === 0 && x < 0))) ? -1 : 1;
  const scale = up / Math.sqrt(1 + Math.abs(z));
  return [x * scale, y * scale];
}

/** The direction of a place on the disc; null beside it. */
export function fromDisc(right: number, up: number): Triple | null {
  const square = right * right + up * up;
  if (square > 1) return null;
  const scale = Math.sqrt(2 - square);
  return [right * scale, up * scale, 1 - square];
}

/** Which of the directions (unit vectors, x, y, z after each other) lies nearest to a direction or its opposite. */
export function nearest(directions: Float32Array, [x, y, z]: Triple): number {
  let best = -1;
  let found = 0;
  for (let i = 0; i < directions.length / 3; ++i) {
    const along = Math.abs(directions[3 * i]! * x + directions[3 * i + 1]! * y + directions[3 * i + 2]! * z);
    if (along > best) {
      best = along;
      found = i;
    }
  }
  return found;
}

/** Beyond this a direction says nothing of another one: twice as far as neighbours of a map lie apart. */
export const NEAR = Math.cos(0.22);

/** As nearest(); null where none is near. */
export function near(directions: Float32Array, direction: Triple): number | null {
  if (directions.length === 0) return null;
  const i = nearest(directions, direction);
  const along = direction.reduce((sum, value, axis) => sum + value * directions[3 * i + axis]!, 0);
  return Math.abs(along) >= NEAR ? i : null;
}

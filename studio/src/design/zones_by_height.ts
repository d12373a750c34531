import type {Triple} from './design';
import {Stroke, type Ball} from './zones';

/** Of a surface, as it is drawn: corners of triangles, in its own coordinates. */
export interface Surface {
  positions: ArrayLike<number>;
  indices: ArrayLike<number>;
}

/** Wide enough that what lies between its balls is covered. */
const SPACING = 0.6;
const MOST_PLACES = 400_000;

/** Balls over all of a surface between two heights along an axis, beside those that are there. They reach so far beyond as
 *  half their radius. `origin`: where the surface's (0, 0, 0) lies in the file's coordinates, which all else is in.
 *  `full`: there were too many. */
export function ballsByHeight(
  {positions, indices}: Surface,
  origin: Readonly<Triple>,
  axis: number,
  [from, to]: readonly [number, number],
  there: readonly Ball[],
  radius_mm: number,
): {balls: Ball[]; full: boolean} {
  const stroke = new Stroke(there, radius_mm, SPACING);
  const within = Math.min(radius_mm / 2, Math.abs(to - from) / 2);
  const [low, high] = [Math.min(from, to) + within - 1e-9, Math.max(from, to) - within + 1e-9];
  const step = radius_mm / 4;
  let places = 0;
  const corner = (i: number): Triple => {
    const at = indices[i]! * 3;
    return [positions[at]! + origin[0], positions[at + 1]! + origin[1], positions[at + 2]! + origin[2]];
  };
  for (let i = 0; i + 2 < indices.length && !stroke.full && places < MOST_PLACES; i += 3) {
    const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
    const heights = [a[axis]!, b[axis]!, c[axis]!];
    if (Math.max(...heights) < low || Math.min(...heights) > high) continue;
    const cut = between(between([a, b, c], axis, low, 1), axis, high, -1);
    for (let j = 2; j < cut.length; j++) places += spread([cut[0]!, cut[j - 1]!, cut[j]!], step, stroke);
  }
  return {balls: stroke.balls, full: stroke.full};
}

/** What of a polygon lies above (`side` 1) or below a height. */
function between(polygon: readonly Triple[], axis: number, height: number, side: 1 | -1): Triple[] {
  const kept: Triple[] = [];
  polygon.forEach((p, i) => {
    const q = polygon[(i + 1) % polygon.length]!;
    const [dp, dq] = [side * (p[axis]! - height), side * (q[axis]! - height)];
    if (dp >= 0) kept.push(p);
    if (dp * dq < 0) kept.push(mixed(p, q, dp / (dp - dq)));
  });
  return kept;
}

/** Places all over a triangle, no farther apart than a step. */
function spread([a, b, c]: [Triple, Triple, Triple], step: number, stroke: Stroke): number {
  const longest = Math.max(distance(a, b), distance(b, c), distance(c, a));
  const n = Math.max(1, Math.min(Math.ceil(longest / step), 500));
  for (let i = 0; i <= n; i++)
    for (let j = 0; j <= n - i; j++) {
      const p = a.map((mm, axis) => mm + ((b[axis]! - mm) * i + (c[axis]! - mm) * j) / n) as Triple;
      stroke.add(p);
    }
  return ((n + 1) * (n + 2)) / 2;
}

function mixed(p: Triple, q: Triple, share: number): Triple {
  return p.map((mm, axis) => mm + (q[axis]! - mm) * share) as Triple;
}

function distance(p: Triple, q: Triple): number {
  return Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

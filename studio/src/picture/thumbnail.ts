import {Matrix4, Vector3} from 'three';
import type {Triple} from '../design/design';
import {quaternion} from '../design/rotation';
import type {DisplayMesh} from '../engine/api';

// A small picture of the object as it would lie in its foam: +x of the space is up, seen from the front, a little
// from above and from the right. Drawn without WebGL, which has few contexts to give.

const TO_VIEWER = new Vector3(0.5, 0.72, 0.48).normalize(); // up, front (+y), right (+z)
const UP = new Vector3(1, 0, 0);
const RIGHT = new Vector3().crossVectors(UP, TO_VIEWER).normalize();
const SCREEN_UP = new Vector3().crossVectors(TO_VIEWER, RIGHT);
const LIGHT = TO_VIEWER.clone().addScaledVector(UP, 0.9).addScaledVector(RIGHT, -0.4).normalize();
const MARGIN = 0.06;

export interface Picture {
  size: number;
  /** Red, green, blue, opacity; clear where the object is not. */
  pixels: Uint8ClampedArray<ArrayBuffer>;
}

/** `color`: of the object in full light, 0 to 255. */
export function thumbnail(mesh: DisplayMesh, rotation_deg: Triple, size: number, color: readonly number[]): Picture {
  const {positions, indices} = mesh;
  const screen = onScreen(positions, rotation_deg, size);
  const pixels = new Uint8ClampedArray(size * size * 4);
  const depth = new Float32Array(size * size).fill(-Infinity);
  const at = [0, 0, 0];
  const own = new Vector3();
  const turn = quaternion(rotation_deg);
  const light = LIGHT.clone().applyQuaternion(turn.invert());
  const corner = (vertex: number) => new Vector3().fromArray(positions, 3 * vertex);
  for (let t = 0; t < indices.length; t += 3) {
    for (let i = 0; i < 3; ++i) at[i] = 3 * indices[t + i]!;
    const a = corner(indices[t]!);
    own.crossVectors(corner(indices[t + 1]!).sub(a), corner(indices[t + 2]!).sub(a)).normalize();
    // Badly wound scans are normal: a face is lit from whichever side is seen.
    const shade = 0.42 + 0.58 * Math.abs(own.dot(light));
    fill(screen, at as [number, number, number], size, depth, pixels, color.map((channel) => channel * shade));
  }
  return {size, pixels};
}

/** Pixels to the right, pixels downward and nearness of each vertex. */
function onScreen(positions: Float32Array, rotation_deg: Triple, size: number): Float32Array {
  const turn = quaternion(rotation_deg);
  const screen = new Float32Array(positions.length);
  const v = new Vector3();
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    v.fromArray(positions, i).applyQuaternion(turn);
    const seen = [v.dot(RIGHT), -v.dot(SCREEN_UP), v.dot(TO_VIEWER)];
    screen.set(seen, i);
    for (const axis of [0, 1] as const) {
      low[axis] = Math.min(low[axis]!, seen[axis]!);
      high[axis] = Math.max(high[axis]!, seen[axis]!);
    }
  }
  const extent = Math.max(high[0]! - low[0]!, high[1]! - low[1]!) || 1;
  const scale = (size * (1 - 2 * MARGIN)) / extent;
  for (let i = 0; i < positions.length; i += 3) {
    for (const axis of [0, 1] as const)
      screen[i + axis] = size / 2 + (screen[i + axis]! - (low[axis]! + high[axis]!) / 2) * scale;
  }
  return screen;
}

function fill(
  screen: Float32Array,
  [a, b, c]: [number, number, number],
  size: number,
  depth: Float32Array,
  pixels: Uint8ClampedArray,
  color: number[],
) {
  const [ax, ay, az, bx, by, bz, cx, cy, cz] = [a, b, c].flatMap((i) => [screen[i]!, screen[i + 1]!, screen[i + 2]!]) as [
    number, number, number, number, number, number, number, number, number,
  ];
  const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  if (area === 0) return;
  const first = (...values: number[]) => Math.max(Math.floor(Math.min(...values)), 0);
  const last = (...values: number[]) => Math.min(Math.ceil(Math.max(...values)), size - 1);
  for (let y = first(ay, by, cy); y <= last(ay, by, cy); ++y) {
    for (let x = first(ax, bx, cx); x <= last(ax, bx, cx); ++x) {
      const wa = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / area;
      const wb = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / area;
      const wc = 1 - wa - wb;
      if (wa < 0 || wb < 0 || wc < 0) continue;
      const nearness = wa * az + wb * bz + wc * cz;
      const pixel = y * size + x;
      if (nearness <= depth[pixel]!) continue;
      depth[pixel] = nearness;
      pixels.set([color[0]!, color[1]!, color[2]!, 255], 4 * pixel);
    }
  }
}

/** Meshes as they lie in the design space, as one. `placement`: column-major 4 x 4. */
export function together(placed: readonly {mesh: DisplayMesh; placement: readonly number[]}[]): DisplayMesh {
  const length = (of: (mesh: DisplayMesh) => ArrayLike<number>) => placed.reduce((sum, {mesh}) => sum + of(mesh).length, 0);
  const positions = new Float32Array(length(({positions: own}) => own));
  const indices = new Uint32Array(length(({indices: own}) => own));
  const v = new Vector3();
  let [vertex, corner] = [0, 0];
  for (const {mesh, placement} of placed) {
    const matrix = new Matrix4().fromArray(placement);
    for (let i = 0; i < mesh.positions.length; i += 3)
      v.fromArray(mesh.positions, i).applyMatrix4(matrix).toArray(positions, 3 * vertex + i);
    for (const index of mesh.indices) indices[corner++] = vertex + index;
    vertex += mesh.positions.length / 3;
  }
  return {positions, indices, deviation: 0};
}

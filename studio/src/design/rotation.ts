import {Euler, Matrix4, Quaternion, Vector3} from 'three';
import type {Triple} from './design';

// Rotations as the library has them: R = Rz(phi) Ry(theta) Rx(psi), about axes that stay where they are.

/** What a slider shows and a project stores: no digits that nobody set. */
const STEP_DEG = 0.001;
const DEG = Math.PI / 180;
const AXES = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)] as const;
const DOWN = new Vector3(-1, 0, 0);

export type Side = '+x' | '-x' | '+y' | '-y' | '+z' | '-z';
export const SIDES: readonly Side[] = ['+x', '-x', '+y', '-y', '+z', '-z'];

export function quaternion([psi, theta, phi]: Triple): Quaternion {
  return new Quaternion().setFromEuler(new Euler(psi * DEG, theta * DEG, phi * DEG, 'ZYX'));
}

export function angles(turn: Quaternion): Triple {
  const {x, y, z} = new Euler().setFromQuaternion(turn, 'ZYX');
  return [tidy(x / DEG), tidy(y / DEG), tidy(z / DEG)];
}

/** After another quarter turn about a fixed axis of the space. */
export function quarterTurned(rotation: Triple, axis: 0 | 1 | 2, direction: 1 | -1): Triple {
  const turn = new Quaternion().setFromAxisAngle(AXES[axis], direction * 90 * DEG);
  return angles(turn.multiply(quaternion(rotation)));
}

/** The object's own `side` faces down, turned as little as possible otherwise. Only quarter turns, so that flat
 *  sides lie flat. */
export function sideDown(rotation: Triple, side: Side): Triple {
  const own = sideVector(side);
  const now = quaternion(rotation);
  const best = QUARTER_TURNS.filter(({turn}) => own.clone().applyQuaternion(turn).dot(DOWN) > 0.99).reduce((a, b) =>
    a.turn.angleTo(now) <= b.turn.angleTo(now) + 1e-9 ? a : b,
  );
  return [...best.rotation];
}

/** The object's own side that faces down most. */
export function sideThatIsDown(rotation: Triple): Side {
  const turn = quaternion(rotation);
  const down = (side: Side) => sideVector(side).applyQuaternion(turn).dot(DOWN);
  return SIDES.reduce((a, b) => (down(a) >= down(b) - 1e-9 ? a : b));
}

/** What of the object, in its own coordinates, points up. */
export function ownDirectionUp(rotation: Triple): Triple {
  const {x, y, z} = AXES[0].clone().applyQuaternion(quaternion(rotation).invert());
  return [x, y, z];
}

export function matrixFrom(elements: readonly number[]): Matrix4 {
  return new Matrix4().fromArray(elements);
}

function sideVector(side: Side): Vector3 {
  const axis = AXES['xyz'.indexOf(side.charAt(1))] ?? AXES[0];
  return axis.clone().multiplyScalar(side.startsWith('-') ? -1 : 1);
}

const QUARTER_TURNS = [0, 90, 180, -90].flatMap((psi) =>
  [0, 90, 180, -90].flatMap((theta) =>
    [0, 90, 180, -90].map((phi) => {
      const rotation: Triple = [psi, theta, phi];
      return {rotation, turn: quaternion(rotation)};
    }),
  ),
);

function tidy(degrees: number): number {
  const rounded = Math.round(degrees / STEP_DEG) * STEP_DEG;
  return Number(rounded.toFixed(3)) + 0;
}

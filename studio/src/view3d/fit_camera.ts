import {MathUtils, Vector3} from 'three';

/** A way of looking: camera-controls' angles, from the front (+y of the design) and from above. */
export interface Direction {
  azimuth: number;
  polar: number;
}

/** From the middle of what is seen to its upper and its right edge, by how far it is away. */
export interface Reach {
  up: number;
  right: number;
}

/** What lies over the edges of the picture, px. */
export interface Covered {
  top: number;
  bottom: number;
}

/** Of the picture's free part, what is seen fills so much. */
const FILLED = 0.93;
/** A picture that is all covered is looked at all the same. */
const LEAST_FREE = 0.2;

/** Of a camera whose middle is that of the free part. `fov`: of the whole picture from below to above, degrees. */
export function freeReach(fov: number, {width, height}: {width: number; height: number}, {top, bottom}: Covered): Reach {
  const up = Math.tan(MathUtils.degToRad(fov) / 2) * FILLED;
  return {up: up * Math.max((height - top - bottom) / height, LEAST_FREE), right: (up * width) / height};
}

/** Where a camera is nearest to points of which it sees all, and what it looks at; null without points. World coordinates. */
export function fitCamera(points: readonly Vector3[], {azimuth, polar}: Direction, reach: Reach): {target: Vector3; distance: number} | null {
  if (points.length === 0) return null;
  const toEye = new Vector3().setFromSphericalCoords(1, Math.min(Math.max(polar, 1e-4), Math.PI - 1e-4), azimuth);
  const right = new Vector3(0, 1, 0).cross(toEye).normalize();
  const up = new Vector3().crossVectors(toEye, right);
  const nearness = points.map((point) => point.dot(toEye));
  // Per axis of the picture, the two points that need most room: each wants the camera beside itself by no more than it sees there.
  const along = (axis: Vector3, most: number) => {
    let [high, low] = [-Infinity, Infinity];
    points.forEach((point, i) => {
      const at = point.dot(axis);
      high = Math.max(high, at + most * nearness[i]!);
      low = Math.min(low, at - most * nearness[i]!);
    });
    return {middle: (high + low) / 2, eye: (high - low) / (2 * most)};
  };
  const [across, upward] = [along(right, reach.right), along(up, reach.up)];
  // Eye and target as heights along the way to the eye.
  const eye = Math.max(across.eye, upward.eye);
  const [far, near] = [Math.min(...nearness), Math.max(...nearness)];
  const middle = (far + near) / 2;
  const target = right.multiplyScalar(across.middle).addScaledVector(up, upward.middle).addScaledVector(toEye, middle);
  return {target, distance: Math.max(eye - middle, (near - far) * 0.51, 1e-3)};
}

import {PerspectiveCamera, Vector3} from 'three';
import {expect, test} from 'vitest';
import {fitCamera, freeReach} from '../../src/view3d/fit_camera';
import {turnedAs} from '../../src/view3d/camera';
import {numbers} from '../support/packing';

const FOV = 32;

/** A camera as the stage has it: the middle of what is free is that of the lens. */
function camera(size: {width: number; height: number}, {top, bottom}: {top: number; bottom: number}) {
  const made = new PerspectiveCamera(FOV, 1, 1, 1e5);
  made.setViewOffset(size.width, size.height, 0, (bottom - top) / 2, size.width, size.height);
  return made;
}

test('all of it is seen between the bars, as large as there is room, from wherever one looks', () => {
  const number = numbers(3);
  for (let i = 0; i < 200; i++) {
    const size = {width: 300 + number(900), height: 300 + number(600)};
    const covered = {top: number(90), bottom: number(120)};
    const points = Array.from({length: 8}, () => new Vector3(number(400) - 100, number(200), number(900) - 500));
    const direction = {azimuth: (number(628) - 314) / 100, polar: number(315) / 100};
    const fit = fitCamera(points, direction, freeReach(FOV, size, covered))!;
    const eye = camera(size, covered);
    eye.position.setFromSphericalCoords(fit.distance, Math.min(Math.max(direction.polar, 1e-4), Math.PI - 1e-4), direction.azimuth).add(fit.target);
    eye.lookAt(fit.target);
    eye.updateMatrixWorld();
    const seen = points.map((point) => point.clone().project(eye));
    const [left, right] = [Math.min(...seen.map(({x}) => x)), Math.max(...seen.map(({x}) => x))].map((x) => ((x + 1) / 2) * size.width) as [number, number];
    const [upper, lower] = [Math.max(...seen.map(({y}) => y)), Math.min(...seen.map(({y}) => y))].map((y) => ((1 - y) / 2) * size.height) as [number, number];
    expect(left).toBeGreaterThan(0);
    expect(right).toBeLessThan(size.width);
    expect(upper).toBeGreaterThan(covered.top);
    expect(lower).toBeLessThan(size.height - covered.bottom);
    const filled = Math.max((right - left) / size.width, (lower - upper) / (size.height - covered.top - covered.bottom));
    expect(filled).toBeCloseTo(0.93, 1);
  }
});

test('a cube on the page is turned as the work is', () => {
  const eye = new PerspectiveCamera();
  const seen = (x: number, y: number, z: number) => {
    eye.position.set(x, y, z);
    eye.lookAt(0, 0, 0);
    eye.updateMatrixWorld();
    return turnedAs(eye.matrixWorldInverse.elements);
  };
  expect(seen(0, 0, 5)).toBe('matrix3d(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1)');
  // From the right: what was to the right (x of the page) comes to the reader (z).
  expect(seen(5, 0, 0)).toBe('matrix3d(0,0,1,0,0,1,0,0,-1,0,0,0,0,0,0,1)');
});

import {Box3, Matrix4, Vector3} from 'three';
import type {Packing, Runs} from '../engine/api';
import {kindOf} from '../engine/pieces';
import type {Opened} from '../state/view.svelte';

/** How far the outermost pieces go apart, as a share of the space's height: those of a stack need less. */
const WIDE_OPEN = 1.8;
const STACK_WIDE_OPEN = 1.5;
/** Between two pieces that lie beside each other, as a share of the space's depth. */
const BESIDE = 0.08;
/** How high a piece is lifted on its way to its place beside others, as a share of the space's height. */
const LIFTED = 0.5;

/** Where things are drawn while the foams are opened; design coordinates. */
export interface Apart {
  /** From where a piece lies. `number`: from the lowest, which is 0. */
  piece(number: number): Matrix4;
  /** How far the items of a layer are from where they lie; the lowest is 1. */
  layer(number: number): Vector3;
  /** Of the boxes around all pieces and items as they are drawn. */
  corners: readonly Vector3[];
}

/** `opening`: 0 to 1. */
export function apart(packing: Packing, opened: Opened, opening: number): Apart {
  const {piece, layer} = opened === 'book' ? beside(packing, opening) : above(packing, opening);
  return {piece, layer, corners: corners(packing, piece, layer)};
}

type Ways = Omit<Apart, 'corners'>;

/** All pieces as far above each other, with the items of each layer halfway between those around it. */
function above(packing: Packing, opening: number): Ways {
  const {height, layers} = measures(packing);
  const step = (height * (layers > 1 ? STACK_WIDE_OPEN : WIDE_OPEN) * opening) / layers;
  const up = (number: number) => (number - layers / 2) * step;
  return {
    piece: (number) => new Matrix4().makeTranslation(up(number), 0, 0),
    layer: (number) => new Vector3(up(number - 0.5), 0, 0),
  };
}

/** Like an opened book, as the preview has it: the pieces on one ground, one behind the other, with the items in those
 *  below them, and the lid turned over its edge at the back. */
function beside(packing: Packing, opening: number): Ways {
  const {height, depth, layers} = measures(packing);
  const levels = levelsOf(packing);
  const level = (number: number, end: 0 | 1) => levels[number]?.[end] ?? 0;
  const back = (number: number) => -number * depth * (1 + BESIDE);
  const lift = (number: number) => (layers > 1 ? number * LIFTED * height * Math.sin(Math.PI * opening) : 0);
  const stands = (number: number) =>
    new Vector3((-height / 2 - level(number, 0)) * opening + lift(number), back(number) * opening, 0);
  const turned = (number: number) => {
    const hinge = new Vector3(level(number, 0), -depth / 2, 0);
    const end = new Vector3(level(number, 1) - height / 2, back(number), 0);
    const way = end.addScaledVector(hinge, -2).multiplyScalar(opening);
    way.x += lift(number);
    return new Matrix4()
      .makeTranslation(way.add(hinge))
      .multiply(new Matrix4().makeRotationZ(-Math.PI * opening))
      .multiply(new Matrix4().makeTranslation(hinge.negate()));
  };
  return {
    piece: (number) =>
      kindOf(packing, number) === 'upper' ? turned(number) : new Matrix4().makeTranslation(stands(number)),
    layer: (number) => stands(number - 1),
  };
}

function measures({blocks, block_mm, partingLevels, items}: Packing) {
  const layers = Math.max(partingLevels.length, ...items.map(({layer}) => layer));
  return {height: blocks[0] * block_mm[0], depth: blocks[1] * block_mm[1], layers};
}

function corners(packing: Packing, piece: Ways['piece'], layer: Ways['layer']): Vector3[] {
  const {blocks, block_mm, items} = packing;
  const [x, y, z] = blocks.map((count, axis) => (count * block_mm[axis]!) / 2) as [number, number, number];
  const box = (low: number, high: number) => new Box3(new Vector3(low, -y, -z), new Vector3(high, y, z));
  const pieces = levelsOf(packing).map(([low, high], number) => cornersOf(box(low, high), piece(number)));
  const lying = items.map(({bounds: {min, max}, layer: number}) =>
    cornersOf(new Box3(new Vector3(...min), new Vector3(...max)), new Matrix4().makeTranslation(layer(number))),
  );
  // Where there is no foam, there is its space.
  return [...(pieces.length > 0 ? pieces : [cornersOf(box(-x, x), new Matrix4())]), ...lying].flat();
}

export function cornersOf({min, max}: Box3, moved: Matrix4): Vector3[] {
  const all: Vector3[] = [];
  for (const x of [min.x, max.x])
    for (const y of [min.y, max.y]) for (const z of [min.z, max.z]) all.push(new Vector3(x, y, z).applyMatrix4(moved));
  return all;
}

const known = new WeakMap<Packing, readonly [low: number, high: number][]>();

/** Between which heights the pieces lie, mm along x. */
export function levelsOf(packing: Packing): readonly [low: number, high: number][] {
  const there = known.get(packing);
  if (there) return there;
  const {pieces, blocks, block_mm} = packing;
  const mm = (level: number) => (level - blocks[0] / 2) * block_mm[0];
  const made = pieces.map((kept): [number, number] => {
    const [low, high] = ends(kept, blocks[0]);
    return [mm(low), mm(high)];
  });
  known.set(packing, made);
  return made;
}

function ends({first, end}: Runs, most: number): [low: number, high: number] {
  let [low, high] = [most, 0];
  for (let column = 0; column < end.length; column++) {
    const [bottom, top] = [first[column]!, end[column]!];
    if (top <= bottom) continue;
    if (bottom < low) low = bottom;
    if (top > high) high = top;
  }
  return low < high ? [low, high] : [0, 0];
}

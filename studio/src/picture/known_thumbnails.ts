import type {Triple} from '../design/design';
import type {DisplayMesh} from '../engine/api';
import {thumbnail, type Picture} from './thumbnail';

// Pictures that were drawn are kept with their object, and new ones are drawn one after the other, when the page has
// nothing else to do: an object may have a hundred thousand triangles.

const OBJECT = [238, 230, 214];
const known = new WeakMap<DisplayMesh, Map<string, Picture>>();
const waiting: {mesh: DisplayMesh; lying: string; size: number; put: (picture: Picture) => void}[] = [];
let running = false;

/** Hands over the picture of an object that lies so, the three angles as text: at once, where it is known. The answer
 *  takes the wish back. */
export function knownThumbnail(mesh: DisplayMesh, lying: string, size: number, put: (picture: Picture) => void): () => void {
  const there = known.get(mesh)?.get(keyOf(lying, size));
  if (there) {
    put(there);
    return () => {};
  }
  const wish = {mesh, lying, size, put};
  waiting.push(wish);
  if (!running) next();
  return () => {
    const at = waiting.indexOf(wish);
    if (at >= 0) waiting.splice(at, 1);
  };
}

const keyOf = (lying: string, size: number) => `${lying} ${size}`;

function next() {
  running = waiting.length > 0;
  if (!running) return;
  const idle = globalThis.requestIdleCallback ?? ((then: () => void) => setTimeout(then, 30));
  idle(() => {
    const wish = waiting.shift();
    if (wish) wish.put(drawn(wish.mesh, wish.lying, wish.size));
    next();
  });
}

function drawn(mesh: DisplayMesh, lying: string, size: number): Picture {
  const own = known.get(mesh) ?? new Map<string, Picture>();
  known.set(mesh, own);
  const picture = own.get(keyOf(lying, size)) ?? thumbnail(mesh, lying.split(',').map(Number) as Triple, size, OBJECT);
  own.set(keyOf(lying, size), picture);
  return picture;
}

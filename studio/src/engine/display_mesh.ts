import {MeshoptSimplifier} from 'meshoptimizer/simplifier';
import type {DisplayMesh} from './api';

// Some way beyond the limit is fine for drawing; far beyond it is not.
const TOLERATED = 1.1;
// Relative to the object's size: the number of triangles decides, not the error.
const ANY_ERROR = 1;

/** A copy with about `mostTriangles` triangles: edge collapses where the surface allows it, and clustered
 *  vertices where it is too broken for that. */
export async function simplified(
  mesh: Omit<DisplayMesh, 'deviation'>,
  mostTriangles: number,
): Promise<DisplayMesh> {
  const {positions, indices, parts = null} = mesh;
  if (indices.length <= mostTriangles * 3) return {positions, indices, parts, deviation: 0};
  await MeshoptSimplifier.ready;
  const target = Math.max(1, Math.floor(mostTriangles)) * 3;
  let [fewer, error] = MeshoptSimplifier.simplify(indices, positions, 3, target, ANY_ERROR, ['Permissive', 'Prune']);
  if (fewer.length === 0 || fewer.length > target * TOLERATED)
    [fewer, error] = MeshoptSimplifier.simplifySloppy(indices, positions, 3, null, target, ANY_ERROR);
  return {...compacted(positions, fewer, parts), deviation: error * MeshoptSimplifier.getScale(positions, 3)};
}

/** Without the vertices that no triangle uses any more. */
function compacted(positions: Float32Array, indices: Uint32Array, parts: Uint32Array | null): Omit<DisplayMesh, 'deviation'> {
  const renumbered = new Uint32Array(indices);
  const [places, count] = MeshoptSimplifier.compactMesh(renumbered);
  const kept = new Float32Array(count * 3);
  const keptParts = parts && new Uint32Array(count);
  places.forEach((place, vertex) => {
    if (place >= count) return;
    kept.set(positions.subarray(vertex * 3, vertex * 3 + 3), place * 3);
    if (keptParts) keptParts[place] = parts![vertex]!;
  });
  return {positions: kept, indices: renumbered, parts: keptParts};
}

import {BufferAttribute, BufferGeometry} from 'three';
import type {DisplayMesh} from '../engine/api';

/** Sharper edges than this stay sharp. */
const CREASE_COSINE = Math.cos((40 * Math.PI) / 180);

/** A mesh for drawing: smooth where the surface is, sharp at creases. Three corners a triangle. */
export function objectGeometry({positions, indices, parts}: DisplayMesh): BufferGeometry {
  const faces = faceNormals(positions, indices);
  const smooth = vertexNormals(positions.length, indices, faces);
  makeUnit(faces);
  makeUnit(smooth);
  const corners = new Float32Array(indices.length * 3);
  const normals = new Int8Array(indices.length * 3);
  for (let corner = 0; corner < indices.length; corner++) {
    const to = corner * 3;
    const vertex = (indices[corner] ?? 0) * 3;
    const face = corner - (corner % 3);
    let cosine = 0;
    for (let axis = 0; axis < 3; axis++) cosine += (faces[face + axis] ?? 0) * (smooth[vertex + axis] ?? 0);
    const [source, at] = cosine > CREASE_COSINE ? [smooth, vertex] : [faces, face];
    for (let axis = 0; axis < 3; axis++) {
      corners[to + axis] = positions[vertex + axis] ?? 0;
      normals[to + axis] = (source[at + axis] ?? 0) * 127;
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setAttribute('normal', new BufferAttribute(normals, 3, true));
  if (parts) geometry.setAttribute('part', new BufferAttribute(Float32Array.from(indices, (vertex) => parts[vertex] ?? 0), 1));
  return geometry;
}

/** As long as twice the triangle's area, so that large triangles count for more at their vertices. */
function faceNormals(p: Float32Array, indices: Uint32Array): Float32Array {
  const normals = new Float32Array(indices.length);
  const at = (i: number) => p[i] ?? 0;
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [(indices[i] ?? 0) * 3, (indices[i + 1] ?? 0) * 3, (indices[i + 2] ?? 0) * 3];
    const [ux, uy, uz] = [at(b) - at(a), at(b + 1) - at(a + 1), at(b + 2) - at(a + 2)];
    const [vx, vy, vz] = [at(c) - at(a), at(c + 1) - at(a + 1), at(c + 2) - at(a + 2)];
    normals[i] = uy * vz - uz * vy;
    normals[i + 1] = uz * vx - ux * vz;
    normals[i + 2] = ux * vy - uy * vx;
  }
  return normals;
}

function vertexNormals(size: number, indices: Uint32Array, faces: Float32Array): Float32Array {
  const normals = new Float32Array(size);
  for (let corner = 0; corner < indices.length; corner++) {
    const vertex = (indices[corner] ?? 0) * 3;
    const face = Math.floor(corner / 3) * 3;
    for (let axis = 0; axis < 3; axis++)
      normals[vertex + axis] = (normals[vertex + axis] ?? 0) + (faces[face + axis] ?? 0);
  }
  return normals;
}

function makeUnit(vectors: Float32Array) {
  for (let i = 0; i < vectors.length; i += 3) {
    const [x, y, z] = [vectors[i] ?? 0, vectors[i + 1] ?? 0, vectors[i + 2] ?? 0];
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    vectors[i] = x / length;
    vectors[i + 1] = y / length;
    vectors[i + 2] = z / length;
  }
}

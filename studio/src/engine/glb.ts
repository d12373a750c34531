import type {Failure} from './api';
import {failure, isFailure} from './failure';

// The parts of glTF 2.0 that concern a file's packaging (sections 3.6 and 4.4 of its specification).

const MAGIC = 0x46546c67; // "glTF"
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;

interface BufferReference {
  buffer: number;
  byteOffset?: number;
}

interface Gltf {
  asset?: {version?: string};
  buffers?: {uri?: string; byteLength: number}[];
  bufferViews?: (BufferReference & {extensions?: {EXT_meshopt_compression?: BufferReference}})[];
  meshes?: {primitives?: {material?: number}[]}[];
  extensionsUsed?: string[];
  [name: string]: unknown;
}

/** A .glb or .gltf as a .glb without materials, pictures and movements, which foam does not need and which might
 *  want something from elsewhere. Fails where the geometry itself lies elsewhere or is packed with Draco. */
export function glbWithoutLooks(bytes: ArrayBuffer): ArrayBuffer | Failure {
  const parts = unpack(bytes);
  if (isFailure(parts)) return parts;
  const {gltf, binary} = parts;
  if (!gltf.asset?.version?.startsWith('2'))
    return failure('input', 'this is not glTF 2; save it as .glb with a newer program');
  if (gltf.extensionsUsed?.includes('KHR_draco_mesh_compression'))
    return failure('input', 'its geometry is compressed with Draco, which is not read here: save it without compression');
  for (const name of ['materials', 'textures', 'images', 'samplers', 'animations', 'cameras']) delete gltf[name];
  for (const mesh of gltf.meshes ?? []) for (const primitive of mesh.primitives ?? []) delete primitive.material;
  const merged = mergeBuffers(gltf, binary);
  return isFailure(merged) ? merged : pack(gltf, merged);
}

function unpack(bytes: ArrayBuffer): {gltf: Gltf; binary: Uint8Array | null} | Failure {
  const view = new DataView(bytes);
  if (bytes.byteLength < 20 || view.getUint32(0, true) !== MAGIC) return {gltf: parse(bytes), binary: null};
  let gltf: Gltf | null = null;
  let binary: Uint8Array | null = null;
  for (let at = 12; at + 8 <= bytes.byteLength; ) {
    const length = view.getUint32(at, true);
    const type = view.getUint32(at + 4, true);
    if (at + 8 + length > bytes.byteLength) return failure('input', 'the file ends too early');
    const chunk = new Uint8Array(bytes, at + 8, length);
    if (type === JSON_CHUNK) gltf ??= parse(chunk);
    if (type === BIN_CHUNK) binary ??= chunk;
    at += 8 + length;
  }
  return gltf ? {gltf, binary} : failure('input', 'there is no scene in it');
}

function parse(text: ArrayBuffer | Uint8Array): Gltf {
  const value: unknown = JSON.parse(new TextDecoder().decode(text));
  return typeof value === 'object' && value !== null ? (value as Gltf) : {};
}

/** All buffers one after another, the views changed accordingly. */
function mergeBuffers(gltf: Gltf, binary: Uint8Array | null): Uint8Array | Failure {
  const contents: Uint8Array[] = [];
  for (const {uri, byteLength} of gltf.buffers ?? []) {
    if (uri === undefined) {
      // The chunk of a .glb, or a place that only a decoder fills.
      contents.push(contents.length === 0 && binary ? binary : new Uint8Array());
      continue;
    }
    const data = /^data:[^,]*;base64,(.*)$/s.exec(uri);
    if (!data)
      return failure('input', `its geometry lies in another file (${uri.slice(0, 60)}): save it as .glb, which holds all`);
    const text = atob(data[1]!);
    const content = Uint8Array.from(text, (character) => character.charCodeAt(0));
    if (content.length < byteLength) return failure('input', 'its data are shorter than they should be');
    contents.push(content);
  }
  const starts: number[] = [];
  let total = 0;
  for (const content of contents) {
    starts.push(total);
    total += padded(content.length);
  }
  const merged = new Uint8Array(total);
  contents.forEach((content, i) => merged.set(content, starts[i]));
  for (const view of gltf.bufferViews ?? []) {
    for (const reference of [view, view.extensions?.EXT_meshopt_compression]) {
      if (!reference) continue;
      reference.byteOffset = (reference.byteOffset ?? 0) + (starts[reference.buffer] ?? 0);
      reference.buffer = 0;
    }
  }
  gltf.buffers = total > 0 ? [{byteLength: total}] : [];
  return merged;
}

function pack(gltf: Gltf, binary: Uint8Array): ArrayBuffer {
  const text = new TextEncoder().encode(JSON.stringify(gltf));
  const json = new Uint8Array(padded(text.length)).fill(0x20);
  json.set(text);
  const bytes = new ArrayBuffer(12 + 8 + json.length + 8 + binary.length);
  const view = new DataView(bytes);
  [MAGIC, 2, bytes.byteLength, json.length, JSON_CHUNK].forEach((word, i) => view.setUint32(i * 4, word, true));
  new Uint8Array(bytes, 20).set(json);
  view.setUint32(20 + json.length, binary.length, true);
  view.setUint32(24 + json.length, BIN_CHUNK, true);
  new Uint8Array(bytes, 28 + json.length).set(binary);
  return bytes;
}

function padded(length: number): number {
  return Math.ceil(length / 4) * 4;
}

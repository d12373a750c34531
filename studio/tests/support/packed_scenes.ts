import createEncoder from 'draco3d/draco_encoder_nodejs.js';
import {MeshoptEncoder} from 'meshoptimizer/encoder';
import {glb, scene, tetrahedron} from './scenes';

// The tetrahedron of scenes.ts as the encoders of the formats' makers pack it.

const {points, corners} = tetrahedron(0.1);
const draco = await createEncoder({});
await MeshoptEncoder.ready;

/** `damaged`: in the middle of what is packed. */
export function dracoScene(damaged = false) {
  const encoder = new draco.Encoder();
  const builder = new draco.MeshBuilder();
  const mesh = new draco.Mesh();
  builder.AddFacesToMesh(mesh, 4, Uint32Array.from(corners));
  const id = builder.AddFloatAttributeToMesh(mesh, draco.POSITION, 4, 3, points);
  encoder.SetAttributeQuantization(draco.POSITION, 16);
  const array = new draco.DracoInt8Array();
  const length = encoder.EncodeMeshToDracoBuffer(mesh, array);
  const packed = Uint8Array.from({length}, (_, i) => array.GetValue(i));
  const name = 'KHR_draco_mesh_compression';
  const primitive = {
    attributes: {POSITION: 0},
    indices: 1,
    extensions: {[name]: {bufferView: 0, attributes: {POSITION: id}}},
  };
  if (damaged) packed.fill(255, 12);
  return glb(
    scene([{mesh: 0}], {}, {
      extensionsUsed: [name],
      extensionsRequired: [name],
      meshes: [{primitives: [primitive]}],
      accessors: [
        {componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [0.1, 0.1, 0.1]},
        {componentType: 5123, count: 12, type: 'SCALAR'},
      ],
      bufferViews: [{buffer: 0, byteLength: packed.length}],
      buffers: [{byteLength: packed.length}],
    }),
    packed,
  );
}

export function meshoptScene(name: string, damaged = false) {
  const encode = (bytes: Uint8Array, count: number, size: number, mode: string) =>
    MeshoptEncoder.encodeGltfBuffer(bytes, count, size, mode, 0);
  const views = [
    {bytes: encode(new Uint8Array(points.buffer), 4, 12, 'ATTRIBUTES'), count: 4, byteStride: 12, mode: 'ATTRIBUTES'},
    {bytes: encode(new Uint8Array(corners.buffer), 12, 2, 'TRIANGLES'), count: 12, byteStride: 2, mode: 'TRIANGLES'},
  ];
  const packed = Buffer.concat(views.map(({bytes}) => bytes));
  const starts = [0, views[0]!.bytes.length];
  const bufferViews = views.map(({bytes, count, byteStride, mode}, i) => ({
    buffer: 1,
    byteLength: count * byteStride,
    extensions: {[name]: {buffer: 0, byteOffset: starts[i], byteLength: bytes.length, count, byteStride, mode}},
  }));
  if (damaged) packed.fill(255, 1, 20);
  return glb(
    scene([{mesh: 0}], {}, {
      extensionsUsed: [name],
      extensionsRequired: [name],
      bufferViews,
      buffers: [{byteLength: packed.length}, {byteLength: 72, extensions: {[name]: {fallback: true}}}],
    }),
    packed,
  );
}

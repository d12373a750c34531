import {zipSync} from 'fflate';

// Scenes as other programs write them.

/** A tetrahedron with edges of `edge` along the axes, outward. */
export function tetrahedron(edge: number) {
  return {
    points: Float32Array.from([0, 0, 0, edge, 0, 0, 0, edge, 0, 0, 0, edge]),
    corners: Uint16Array.from([0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]),
  };
}

const TETRAHEDRON = tetrahedron(0.1);
export const GEOMETRY = Buffer.concat([Buffer.from(TETRAHEDRON.points.buffer), Buffer.from(TETRAHEDRON.corners.buffer)]);

export interface SceneNode {
  mesh?: number;
  children?: number[];
  [property: string]: unknown;
}

/** glTF of nodes that show the tetrahedron (mesh 0), 100 mm long. All nodes are roots, but for those that are
 *  children. */
export function scene(nodes: SceneNode[], buffer: object, more: object = {}) {
  const children = new Set(nodes.flatMap((node) => node.children ?? []));
  return {
    asset: {version: '2.0'},
    scene: 0,
    scenes: [{nodes: nodes.map((_, i) => i).filter((i) => !children.has(i))}],
    nodes,
    meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1, material: 0}]}],
    accessors: [
      {bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [0.1, 0.1, 0.1]},
      {bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR'},
    ],
    bufferViews: [
      {buffer: 0, byteLength: 48},
      {buffer: 0, byteOffset: 48, byteLength: 24},
    ],
    buffers: [{byteLength: GEOMETRY.length, ...buffer}],
    materials: [{pbrMetallicRoughness: {}}],
    ...more,
  };
}

export const text = (value: string | object): Uint8Array<ArrayBuffer> =>
  new TextEncoder().encode(typeof value === 'string' ? value : JSON.stringify(value));

export function glb(value: object, binary: Uint8Array = GEOMETRY): Uint8Array<ArrayBuffer> {
  const padded = (bytes: Uint8Array, filler: number) =>
    Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, filler)]);
  const [json, rest] = [padded(text(value), 32), padded(binary, 0)];
  const words = (...values: number[]) => Buffer.from(new Uint32Array(values).buffer);
  const parts = [
    words(0x46546c67, 2, 28 + json.length + rest.length, json.length, 0x4e4f534a),
    json,
    words(rest.length, 0x004e4942),
    rest,
  ];
  return new Uint8Array(Buffer.concat(parts));
}

/** A 3MF of one tetrahedron whose edges along the axes are `edge` of `unit` long. */
export function threemf(edge: number, unit: string): Uint8Array<ArrayBuffer> {
  const {points, corners} = tetrahedron(edge);
  const vertices = [0, 1, 2, 3].map((v) => `<vertex x="${points[3 * v]}" y="${points[3 * v + 1]}" z="${points[3 * v + 2]}"/>`);
  const triangles = [0, 1, 2, 3].map((t) => `<triangle v1="${corners[3 * t]}" v2="${corners[3 * t + 1]}" v3="${corners[3 * t + 2]}"/>`);
  const model = `<?xml version="1.0"?><!-- <model unit="inch"> --><model unit="${unit}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>${vertices.join('')}</vertices><triangles>${triangles.join('')}</triangles></mesh></object></resources><build><item objectid="1"/></build></model>`;
  const relations =
    '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>';
  return zipSync({
    '_rels/.rels': text(relations),
    '3D/3dmodel.model': text(model),
    'Metadata/thumbnail.png': new Uint8Array(1000).fill(137),
  });
}

import {expect, test} from 'vitest';
import {convert, needsConversion} from '../src/engine/convert';
import {good, refused, startCore} from './support/snug';

// A tetrahedron with edges of 0.1 along the axes, outward.
const POINTS = [0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1];
const FACES = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];

const geometry = new Uint8Array(POINTS.length * 4 + FACES.length * 2);
new Float32Array(geometry.buffer, 0, POINTS.length).set(POINTS);
new Uint16Array(geometry.buffer, POINTS.length * 4).set(FACES);

function scene(nodes: object[], buffer: object, more: object = {}) {
  return {
    asset: {version: '2.0'},
    scene: 0,
    scenes: [{nodes: nodes.map((_, i) => i)}],
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
    buffers: [{byteLength: geometry.length, ...buffer}],
    materials: [{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}],
    textures: [{source: 0}],
    images: [{uri: 'https://example.com/a.png'}],
    ...more,
  };
}

const text = (value: object) => new TextEncoder().encode(JSON.stringify(value)).buffer as ArrayBuffer;
const inText = {uri: `data:application/octet-stream;base64,${Buffer.from(geometry).toString('base64')}`};

function glb(value: object): ArrayBuffer {
  const json = Buffer.from(JSON.stringify(value).padEnd(Math.ceil(JSON.stringify(value).length / 4) * 4));
  const words = (...values: number[]) => Buffer.from(new Uint32Array(values).buffer);
  const length = 28 + json.length + geometry.length;
  const parts = [
    words(0x46546c67, 2, length, json.length, 0x4e4f534a), json,
    words(geometry.length, 0x004e4942), Buffer.from(geometry),
  ];
  return new Uint8Array(Buffer.concat(parts)).buffer;
}

async function loaded(name: string, bytes: ArrayBuffer) {
  const file = good(await convert(name, bytes));
  const core = await startCore();
  const {object} = await core.defaultDesign();
  return good(await core.load(file.name, new Blob([file.bytes]), object));
}

test('knows which files it is for', () => {
  expect(['a.GLB', 'b.gltf', 'c.3mf', 'd.stl', 'e.ply', 'glb'].map(needsConversion)).toEqual(
    [true, true, true, false, false, false],
  );
});

test.each([
  ['chair.glb', glb(scene([{mesh: 0}], {}))],
  ['chair.gltf', text(scene([{mesh: 0}], inText))],
])('%s becomes a PLY in mm', async (name, bytes) => {
  const info = await loaded(name, bytes);
  expect(info.file.name).toBe('chair.ply');
  expect(info).toMatchObject({triangles: 4, watertight: true});
  info.size_mm!.forEach((length) => expect(length).toBeCloseTo(100, 3));
  expect(info.volume_mm3).toBeCloseTo(1e6 / 6, 0);
});

test('nodes place, scale, mirror and repeat what they show', async () => {
  const nodes = [
    {mesh: 0},
    {mesh: 0, translation: [1, 0, 0], scale: [2, 2, 2]},
    {mesh: 0, translation: [0, 0.5, 0], scale: [1, 1, -1]},
  ];
  const info = await loaded('three.glb', glb(scene(nodes, {})));
  expect(info.partCount).toBe(3);
  expect(info.watertight).toBe(true);
  expect(info.size_mm!.map(Math.round)).toEqual([1200, 600, 300]);
  // The mirrored one would count negatively if it were inside out.
  expect(info.volume_mm3! / (1e6 / 6)).toBeCloseTo(1 + 8 + 1, 3);
});

test('what cannot be read gets a sentence with the name', async () => {
  const cases: [string, ArrayBuffer, RegExp][] = [
    ['far.gltf', text(scene([{mesh: 0}], {uri: 'far.bin'})), /another file \(far\.bin\)/],
    ['draco.glb', glb(scene([{mesh: 0}], {}, {extensionsUsed: ['KHR_draco_mesh_compression']})), /Draco/],
    ['old.gltf', text({asset: {version: '1.0'}}), /glTF 2/],
    ['empty.gltf', text({asset: {version: '2.0'}, scene: 0, scenes: [{nodes: []}]}), /no triangles/],
    ['noise.glb', new Uint8Array([1, 2, 3, 4]).buffer, /cannot be read/],
    ['cut.glb', glb(scene([{mesh: 0}], {})).slice(0, 400), /ends too early/],
    ['noise.3mf', new Uint8Array([1, 2, 3, 4]).buffer, /cannot be read/],
  ];
  for (const [name, bytes, sentence] of cases) {
    const {kind, error} = refused(await convert(name, bytes));
    expect(kind).toBe('input');
    expect(error).toContain(name);
    expect(error).toMatch(sentence);
  }
});

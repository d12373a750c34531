import {readFileSync} from 'node:fs';
import {strFromU8, unzipSync, zipSync} from 'fflate';
import {dracoScene, meshoptScene} from '../tests/support/packed_scenes';
import {GEOMETRY, scene, text} from '../tests/support/scenes';
import {kept} from './support/kept';
import {expect, foamsShown, open, test} from './support/studio';

const CORNERS = [[0, 0, 0], [120, 0, 0], [0, 90, 0], [0, 0, 60]];
const FACES = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

test('3MF opens with its unit', async ({studio: page}) => {
  const vertices = CORNERS.map(([x, y, z]) => `<vertex x="${(x ?? 0) / 10}" y="${(y ?? 0) / 10}" z="${(z ?? 0) / 10}"/>`);
  const triangles = FACES.map(([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`);
  const model = `<?xml version="1.0"?><model unit="centimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices>${vertices.join('')}</vertices><triangles>${triangles.join('')}</triangles></mesh></object></resources><build><item objectid="1"/></build></model>`;
  const relations =
    '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="r" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>';
  const text = (value: string) => new TextEncoder().encode(value);
  const zip = zipSync({'_rels/.rels': text(relations), '3D/3dmodel.model': text(model)});
  await page.getByLabel('Open object', {exact: true}).setInputFiles({name: 'wedge.3mf', mimeType: '', buffer: Buffer.from(zip)});
  await expect(page.getByTitle('wedge.3mf')).toBeVisible();
  await expect(page.getByText('120 × 90 × 60 mm')).toBeVisible();
  await foamsShown(page);
  await expect(page.getByText('stated by the file')).toBeVisible();
  await expect(page.getByRole('combobox', {name: 'Unit of the file'})).toHaveCount(0);
});

test('glTF opens in metres', async ({studio: page}) => {
  const positions = Buffer.from(Float32Array.from(CORNERS.flat().map((mm) => mm / 1000)).buffer);
  const indices = Buffer.from(Uint16Array.from(FACES.flat()).buffer);
  const gltf = {
    asset: {version: '2.0'},
    scenes: [{nodes: [0]}],
    scene: 0,
    nodes: [{mesh: 0}],
    meshes: [{primitives: [{attributes: {POSITION: 0}, indices: 1}]}],
    accessors: [
      {bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [0.12, 0.09, 0.06]},
      {bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR'},
    ],
    bufferViews: [
      {buffer: 0, byteOffset: 0, byteLength: positions.length},
      {buffer: 0, byteOffset: positions.length, byteLength: indices.length},
    ],
    buffers: [
      {
        byteLength: positions.length + indices.length,
        uri: `data:application/octet-stream;base64,${Buffer.concat([positions, indices]).toString('base64')}`,
      },
    ],
  };
  await page.getByLabel('Open object', {exact: true}).setInputFiles({name: 'wedge.gltf', mimeType: '', buffer: Buffer.from(JSON.stringify(gltf))});
  await expect(page.getByTitle('wedge.gltf')).toBeVisible();
  await expect(page.getByText('120 × 90 × 60 mm')).toBeVisible();
  await foamsShown(page);
});

test('OBJ and OFF open as they are', async ({studio: page}) => {
  const obj = [...CORNERS.map((corner) => `v ${corner.join(' ')}`), ...FACES.map((face) => `f ${face.map((i) => i + 1).join(' ')}`), ''].join('\n');
  await open(page, {name: 'wedge.obj', buffer: Buffer.from(obj)});
  const off = ['OFF', '4 4 0', ...CORNERS.map((corner) => corner.join(' ')), ...FACES.map((face) => `3 ${face.join(' ')}`), ''].join('\n');
  await open(page, {name: 'wedge.off', buffer: Buffer.from(off)});
});

test('decoders load in the page, where nothing may be made of texts', async ({studio: page}) => {
  await open(page, {name: 'draco.glb', buffer: Buffer.from(dracoScene())});
  await expect(page.getByText('100 × 100 × 100 mm')).toBeVisible();
  await open(page, {name: 'meshopt.glb', buffer: Buffer.from(meshoptScene('EXT_meshopt_compression'))});
  await expect(page.getByText('100 × 100 × 100 mm')).toBeVisible();
  await open(page, {name: 'draco.zip', buffer: Buffer.from(zipSync({'chair.glb': dracoScene()}))});
  await expect(page.getByText('100 × 100 × 100 mm')).toBeVisible();
});

test('a .gltf takes its .bin from the files beside it, is exported and kept with it', async ({studio: page}) => {
  const gltf = Buffer.from(text(scene([{mesh: 0}], {uri: 'chair.bin'})));
  const input = page.getByLabel('Open object', {exact: true});
  await input.setInputFiles({name: 'chair.gltf', mimeType: '', buffer: gltf});
  await expect(page.getByText(/chair\.gltf: .*chair\.bin.*open both files at once/)).toBeVisible();
  await input.setInputFiles([
    {name: 'wood.png', mimeType: '', buffer: Buffer.from([1])},
    {name: 'chair.bin', mimeType: '', buffer: GEOMETRY},
    {name: 'chair.gltf', mimeType: '', buffer: gltf},
  ]);
  await expect(page.getByTitle('chair.gltf')).toBeVisible();
  await expect(page.getByText('100 × 100 × 100 mm')).toBeVisible();
  await foamsShown(page);
  await kept(page, 'chair.gltf');

  const exported = async () => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', {name: 'Export', exact: true}).click(),
    ]);
    return unzipSync(new Uint8Array(readFileSync(await download.path())));
  };
  await page.reload();
  await expect(page.getByTitle('chair.gltf')).toBeVisible();
  await foamsShown(page);
  const files = await exported();
  expect(Buffer.from(files['chair.gltf'] ?? []).equals(gltf)).toBe(true);
  expect(Buffer.from(files['chair.bin'] ?? []).equals(GEOMETRY)).toBe(true);
  expect(Object.keys(files)).not.toContain('wood.png');
  const {objects} = JSON.parse(strFromU8(files['project.snug.json']!)) as {objects: {name: string; bytes: number}[]};
  expect(objects[0]).toMatchObject({name: 'chair.gltf', bytes: gltf.length});
});

import {createHash} from 'node:crypto';
import {zipSync} from 'fflate';
import {beforeAll, describe, expect, it} from 'vitest';
import type {EngineCore} from '../../src/engine/core';
import {dracoScene, meshoptScene} from '../support/packed_scenes';
import {GEOMETRY, glb, scene, text, threemf} from '../support/scenes';
import {good, refused, startCore} from '../support/snug';

let core: EngineCore;
beforeAll(async () => void (core = await startCore()));

async function load(name: string, bytes: Uint8Array<ArrayBuffer>, beside: Record<string, Uint8Array> = {}) {
  const {object} = await core.defaultDesign();
  const files = Object.entries(beside).map(([of, content]) => ({name: of, content: new Blob([new Uint8Array(content)])}));
  return core.load(name, new Blob([bytes]), object, files);
}

const inText = {uri: `data:application/octet-stream;base64,${GEOMETRY.toString('base64')}`};
const one = [{mesh: 0}];

describe('a scene', () => {
  it.each([
    ['chair.glb', glb(scene(one, {})), {}],
    ['chair.gltf', text(scene(one, inText)), {}],
    ['chair.gltf', text(scene(one, {uri: 'chair%20b.bin'})), {'wood.jpg': GEOMETRY, 'chair b.bin': GEOMETRY}],
    ['chair.gltf', text(scene(one, {uri: 'parts/sitz\u00e4.bin'})), {'sitza\u0308.bin': GEOMETRY}],
    ['chair.3mf', threemf(10, 'centimeter'), {}],
    ['chair.zip', zipSync({'a/chair.gltf': text(scene(one, {uri: 'b.bin'})), 'a/b.bin': new Uint8Array(GEOMETRY)}), {}],
    ['draco.glb', dracoScene(), {}],
    ['meshopt.glb', meshoptScene('EXT_meshopt_compression'), {}],
    ['draco.zip', zipSync({'chair.glb': dracoScene()}), {}],
  ])('in %s is the object itself, in mm', async (name, bytes, beside: Record<string, Uint8Array>) => {
    const info = good(await load(name, bytes, beside));
    expect(info.file).toEqual({name, bytes: bytes.length, sha256: createHash('sha256').update(bytes).digest('hex')});
    expect(info).toMatchObject({triangles: 4, watertight: true, statesUnit: true, sizeProblem: null});
    info.size_mm!.forEach((length) => expect(length).toBeCloseTo(100, 2));
    expect(info.volume_mm3! / (1e6 / 6)).toBeCloseTo(1, 3);
    expect(info.beside).toEqual(Object.keys(beside).filter((of) => of.endsWith('.bin')));
    expect(good(await core.pack(await core.defaultDesign())).fit).not.toBeNull();
  });

  it('places, scales, mirrors and repeats what its nodes say', async () => {
    const nodes = [
      {mesh: 0},
      {mesh: 0, translation: [1, 0, 0], scale: [2, 2, 2]},
      {mesh: 0, translation: [0, 0.5, 0], scale: [1, 1, -1]},
    ];
    const info = good(await load('three.glb', glb(scene(nodes, {}))));
    expect(info).toMatchObject({partCount: 3, watertight: true});
    expect(info.size_mm!.map(Math.round)).toEqual([1200, 600, 300]);
    // The mirrored one would count negatively if it were inside out.
    expect(info.volume_mm3! / (1e6 / 6)).toBeCloseTo(1 + 8 + 1, 3);
  });

  it('takes no unit from the design, be it as small as it likes', async () => {
    const design = await core.defaultDesign();
    design.object.units = 'in';
    const tiny = glb(scene([{mesh: 0, scale: [0.01, 0.01, 0.01]}], {}));
    const info = good(await core.load('tiny.glb', new Blob([tiny]), design.object));
    expect(info.size_mm![0]).toBeCloseTo(1, 5);
    expect(good(await core.reprepare(design)).size_mm![0]).toBeCloseTo(1, 5);
  });

  it.each([
    ['far.gltf', text(scene(one, {uri: 'far.bin'})), {'near.bin': GEOMETRY}, /far\.bin/],
    ['short.gltf', text(scene(one, {uri: 'far.bin'})), {'far.bin': GEOMETRY.subarray(0, 50)}, /72/],
    ['khr.glb', meshoptScene('KHR_meshopt_compression'), {}, /KHR_meshopt_compression/],
    ['draco.glb', dracoScene(true), {}, /Draco/],
    ['meshopt.glb', meshoptScene('EXT_meshopt_compression', true), {}, /meshopt/],
    ['new.glb', glb(scene(one, {}, {extensionsRequired: ['ACME_foldable']})), {}, /ACME_foldable/],
    ['old.gltf', text({asset: {version: '1.0'}}), {}, /glTF/],
    ['empty.gltf', text({asset: {version: '2.0'}, scene: 0, scenes: [{nodes: []}]}), {}, /\w/],
    ['noise.glb', new Uint8Array([1, 2, 3, 4]), {}, /\w/],
    ['cut.glb', glb(scene(one, {})).slice(0, 400), {}, /\w/],
    ['noise.3mf', new Uint8Array([1, 2, 3, 4]), {}, /\w/],
    ['cut.3mf', threemf(10, 'inch').slice(0, 500), {}, /\w/],
    ['damaged.3mf', broken(threemf(10, 'inch')), {}, /damaged/],
  ])('in %s that cannot be read gets a sentence for people', async (name, bytes, beside: Record<string, Uint8Array>, sentence) => {
    const {kind, error} = refused(await load(name, bytes as Uint8Array<ArrayBuffer>, beside));
    expect(kind).toBe('input');
    expect(error).toMatch(sentence);
    expect(error).not.toMatch(/undefined|wasm|\$\$\$/);
  });
});

/** Bytes within the packed model are others. */
function broken(zip: Uint8Array<ArrayBuffer>): Uint8Array<ArrayBuffer> {
  const name = '3D/3dmodel.model';
  const start = Buffer.from(zip).indexOf(name) + name.length;
  return zip.slice().fill(255, start + 10, start + 60);
}

import {Box3, BufferGeometry, Matrix4, Quaternion, Vector3, type Mesh} from 'three';
import {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
import {OBJLoader} from 'three/addons/loaders/OBJLoader.js';
import {PLYLoader} from 'three/addons/loaders/PLYLoader.js';
import {STLLoader} from 'three/addons/loaders/STLLoader.js';
import {beforeAll, describe, expect, it} from 'vitest';
import type {EngineCore} from '../../src/engine/core';
import {glb, scene} from '../support/scenes';
import {good, startCore} from '../support/snug';

// What the library reads beside what three.js reads: readers that have nothing in common.

const SEED = Number(process.env.SEED ?? 1);
let core: EngineCore;
beforeAll(async () => void (core = await startCore()));

/** 0 to 1, the same ones for the same seed (mulberry32). */
function random(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

async function size(name: string, bytes: BlobPart) {
  const {object} = await core.defaultDesign();
  object.units = 'mm';
  const {triangles, fileSize} = good(await core.load(name, new Blob([bytes]), object));
  return {triangles, fileSize};
}

function compare(ours: {triangles: number; fileSize: number[]}, theirs: {triangles: number; box: Box3}, scale: number, why: string) {
  expect(ours.triangles, why).toBe(theirs.triangles);
  const wanted = theirs.box.getSize(new Vector3()).multiplyScalar(scale).toArray();
  ours.fileSize.forEach((length, axis) =>
    expect(Math.abs(length - wanted[axis]!), `${why}, axis ${axis}`).toBeLessThan(1e-5 * Math.max(...wanted)),
  );
}

const trianglesOf = (geometry: BufferGeometry) => (geometry.index?.count ?? geometry.getAttribute('position').count) / 3;

/** Nodes in nodes, turned, moved, scaled and mirrored, half of them by matrices. */
function randomNodes(next: () => number) {
  const between = (low: number, high: number) => low + (high - low) * next();
  const count = 2 + Math.floor(5 * next());
  const nodes = Array.from({length: count}, (_, i) => {
    const move = [0, 1, 2].map(() => between(-2, 2));
    const turn = new Quaternion(between(-1, 1), between(-1, 1), between(-1, 1), between(-1, 1)).normalize();
    const scale = [0, 1, 2].map(() => between(0.2, 2) * (next() < 0.3 ? -1 : 1));
    const matrix = new Matrix4().compose(new Vector3(...move), turn, new Vector3(...scale));
    const placed = next() < 0.5 ? {matrix: matrix.toArray()} : {translation: move, rotation: turn.toArray(), scale};
    return {...(i === 0 || next() < 0.8 ? {mesh: 0} : {}), ...placed, children: [] as number[]};
  });
  for (let i = 1; i < count; i++) if (next() < 0.5) nodes[Math.floor(next() * i)]!.children.push(i);
  return nodes.map(({children, ...node}) => (children.length > 0 ? {...node, children} : node));
}

describe('another reader sees the same', () => {
  it('in scenes', async () => {
    for (let seed = SEED; seed < SEED + 40; seed++) {
      const bytes = glb(scene(randomNodes(random(seed)), {}));
      const {scene: root} = await new GLTFLoader().parseAsync(bytes.buffer, '');
      root.updateMatrixWorld(true);
      let triangles = 0;
      root.traverse((node) => {
        if ((node as Mesh).isMesh) triangles += trianglesOf((node as Mesh).geometry);
      });
      const box = new Box3().setFromObject(root, true);
      compare(await size('random.glb', bytes), {triangles, box}, 1000, `seed ${seed}`);
    }
  });

  it('in meshes', async () => {
    for (let seed = SEED; seed < SEED + 10; seed++) {
      const next = random(seed);
      const points = Array.from({length: 30}, () => [0, 1, 2].map(() => Math.round(next() * 2000) / 10 - 100));
      const faces = Array.from({length: 20}, (_, i) => [i, i + 3, i + 7 + Math.floor(next() * 3)]);
      const lines = (rows: number[][], before = '') => rows.map((row) => before + row.join(' ')).join('\n');
      const facets = faces.map(
        (face) => `facet normal 0 0 0\nouter loop\n${lines(face.map((v) => points[v]!), 'vertex ')}\nendloop\nendfacet`,
      );
      const files = {
        'random.obj': `${lines(points, 'v ')}\n${lines(faces.map((face) => face.map((v) => v + 1)), 'f ')}\n`,
        'random.ply': `ply\nformat ascii 1.0\nelement vertex 30\nproperty float x\nproperty float y\nproperty float z\nelement face 20\nproperty list uchar int vertex_indices\nend_header\n${lines(points)}\n${lines(faces, '3 ')}\n`,
        'random.stl': `solid random\n${facets.join('\n')}\nendsolid random\n`,
      };
      const meshes: [keyof typeof files, (text: string) => BufferGeometry][] = [
        ['random.obj', (text) => (new OBJLoader().parse(text).children[0] as Mesh).geometry],
        ['random.ply', (text) => new PLYLoader().parse(text)],
        ['random.stl', (text) => new STLLoader().parse(text)],
      ];
      for (const [name, parse] of meshes) {
        const geometry = parse(files[name]);
        // Points that no face has count neither here nor there.
        const flat = geometry.index ? geometry.toNonIndexed() : geometry;
        const box = new Box3().setFromBufferAttribute(flat.getAttribute('position') as never);
        compare(await size(name, files[name]), {triangles: trianglesOf(geometry), box}, 1, `${name}, seed ${seed}`);
      }
    }
  });
});

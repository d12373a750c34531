import type {BufferGeometry, InstancedMesh, Matrix4, Mesh, Object3D} from 'three';
import type {Failure} from './api';
import {failure, isFailure} from './failure';
import {glbWithoutLooks} from './glb';
import {writePly} from './write_ply';

// glTF and 3MF are read by three.js on the page, since they need its XML parser and the library has no reader
// for them. What comes out is a PLY in mm, and that PLY is the object's file from then on: load() gets it, the
// project names it (chair.glb becomes chair.ply) with its size and checksum, and the export contains it, so that
// the command line finds what the project speaks of.

export interface ConvertedFile {
  name: string;
  bytes: ArrayBuffer;
}

const MM_PER_METRE = 1000; // the unit of glTF
const MM_PER_3MF_UNIT: Record<string, number> = {
  micron: 0.001,
  millimeter: 1,
  centimeter: 10,
  inch: 25.4,
  foot: 304.8,
  meter: 1000,
};

export function needsConversion(name: string): boolean {
  return /\.(glb|gltf|3mf)$/i.test(name);
}

/** The file as a PLY in mm, or the sentence that says why it cannot be read. */
export async function convert(name: string, bytes: ArrayBuffer): Promise<ConvertedFile | Failure> {
  const refuse = (why: string) => failure('input', `${name}: ${why}`);
  try {
    const scene = /\.3mf$/i.test(name) ? await read3mf(bytes) : await readGltf(bytes);
    if (isFailure(scene)) return refuse(scene.error);
    const mesh = await triangles(scene.root, scene.mmPerUnit);
    if (mesh.indices.length === 0) return refuse('there are no triangles in it');
    return {name: name.replace(/\.[^.]+$/, '.ply'), bytes: writePly(mesh)};
  } catch (reason) {
    return refuse(`cannot be read (${reason instanceof Error ? reason.message : String(reason)})`);
  }
}

interface Scene {
  root: Object3D;
  mmPerUnit: number;
}

async function readGltf(bytes: ArrayBuffer): Promise<Scene | Failure> {
  const glb = glbWithoutLooks(bytes);
  if (isFailure(glb)) return glb;
  const [{GLTFLoader}, {MeshoptDecoder}] = await Promise.all([
    import('three/addons/loaders/GLTFLoader.js'),
    import('meshoptimizer/decoder'),
  ]);
  const loader = new GLTFLoader();
  loader.setMeshoptDecoder(MeshoptDecoder);
  const {scene} = await loader.parseAsync(glb, '');
  return {root: scene, mmPerUnit: MM_PER_METRE};
}

async function read3mf(bytes: ArrayBuffer): Promise<Scene | Failure> {
  const [{ThreeMFLoader}, {unzipSync, strFromU8}] = await Promise.all([
    import('three/addons/loaders/3MFLoader.js'),
    import('fflate'),
  ]);
  // The loader reads lengths as they are and forgets the unit.
  const models = unzipSync(new Uint8Array(bytes), {filter: ({name}) => /3dmodel\.model$/i.test(name)});
  const [model] = Object.values(models);
  if (!model) return failure('input', 'this is no 3MF file: there is no 3D/3dmodel.model in it');
  const unit = /<(?:\w+:)?model\b[^>]*\sunit\s*=\s*["'](\w+)["']/.exec(strFromU8(model))?.[1] ?? 'millimeter';
  const mmPerUnit = MM_PER_3MF_UNIT[unit];
  if (mmPerUnit === undefined) return failure('input', `its unit "${unit}" is none that 3MF knows`);
  return {root: new ThreeMFLoader().parse(bytes), mmPerUnit};
}

interface Triangles {
  positions: Float32Array;
  indices: Uint32Array;
}

/** Everything that a scene shows, where it shows it: turned, scaled, bent and repeated as its nodes say. */
async function triangles(root: Object3D, mmPerUnit: number): Promise<Triangles> {
  const {Matrix4, Vector3} = await import('three');
  root.updateMatrixWorld(true);
  const toMm = new Matrix4().makeScale(mmPerUnit, mmPerUnit, mmPerUnit);
  const placed: {mesh: Mesh; matrix: Matrix4}[] = [];
  root.traverse((node) => {
    if (!(node as Mesh).isMesh) return;
    const mesh = node as Mesh;
    const world = toMm.clone().multiply(mesh.matrixWorld);
    for (const instance of instances(mesh, Matrix4)) placed.push({mesh, matrix: world.clone().multiply(instance)});
  });

  const vertexCount = placed.reduce((sum, {mesh}) => sum + count(mesh.geometry), 0);
  const indexCount = placed.reduce((sum, {mesh}) => sum + indexCountOf(mesh.geometry), 0);
  const positions = new Float32Array(vertexCount * 3);
  const indices = new Uint32Array(indexCount);
  let vertex = 0;
  let corner = 0;
  const point = new Vector3();
  for (const {mesh, matrix} of placed) {
    const {geometry} = mesh;
    const first = vertex;
    for (let v = 0; v < count(geometry); v++)
      mesh.getVertexPosition(v, point).applyMatrix4(matrix).toArray(positions, 3 * vertex++);
    // A mirroring node turns every triangle inside out; the other way round they face outward again.
    const order = matrix.determinant() < 0 ? [0, 2, 1] : [0, 1, 2];
    for (let i = 0; i + 2 < indexCountOf(geometry); i += 3)
      for (const step of order) indices[corner++] = first + (geometry.index?.getX(i + step) ?? i + step);
  }
  return {positions, indices};
}

function instances(mesh: Mesh, Matrix: typeof Matrix4): Matrix4[] {
  if (!(mesh as InstancedMesh).isInstancedMesh) return [new Matrix()];
  const repeated = mesh as InstancedMesh;
  return Array.from({length: repeated.count}, (_, i) => {
    const matrix = new Matrix();
    repeated.getMatrixAt(i, matrix);
    return matrix;
  });
}

function count(geometry: BufferGeometry): number {
  return geometry.getAttribute('position')?.count ?? 0;
}

/** Whole triangles only. */
function indexCountOf(geometry: BufferGeometry): number {
  const corners = geometry.index?.count ?? count(geometry);
  return corners - (corners % 3);
}

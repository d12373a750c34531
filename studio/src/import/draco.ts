import createDecoder, {type DecoderModule} from 'draco3d/draco_decoder_nodejs.js';
import wasmUrl from 'draco3d/draco_decoder.wasm?url';
import {bytesIn} from '../engine/bytes_in';
import type {SceneTools} from '../engine/module';

let module: Promise<DecoderModule> | null = null;

/** SceneTools.draco by Google's decoder. */
export async function dracoDecoder(): Promise<Required<SceneTools>['draco']> {
  const decoder = await (module ??= load());
  return (packed, asked) => {
    try {
      return unpack(decoder, packed.slice(), asked) ;
    } catch {
      module = null; // where it stopped it may not be used again
      return null;
    }
  };
}

async function load(): Promise<DecoderModule> {
  try {
    // In tests, which have no server, it finds its file by itself.
    return await createDecoder(import.meta.env.MODE === 'test' ? {} : {locateFile: () => wasmUrl, ...bytesIn(wasmUrl)});
  } catch (reason) {
    module = null;
    throw reason;
  }
}

type Asked = {id: number; components: number}[];

function unpack(draco: DecoderModule, packed: Uint8Array, asked: Asked) {
  const decoder = new draco.Decoder();
  const buffer = new draco.DecoderBuffer();
  const mesh = new draco.Mesh();
  try {
    buffer.Init(packed as unknown as Int8Array, packed.length);
    if (!decoder.DecodeBufferToMesh(buffer, mesh).ok()) return null;
    const attributes = asked.map((one) => values(draco, decoder, mesh, one));
    if (attributes.some((one) => one === null)) return null;
    return {attributes: attributes as Float32Array[], corners: corners(draco, decoder, mesh)};
  } finally {
    draco.destroy(mesh);
    draco.destroy(buffer);
    draco.destroy(decoder);
  }
}

type Decoder = InstanceType<DecoderModule['Decoder']>;
type DracoMesh = InstanceType<DecoderModule['Mesh']>;

/** Floats as they are, whole numbers without the scale that they may stand for. */
function values(draco: DecoderModule, decoder: Decoder, mesh: DracoMesh, asked: Asked[number]): Float32Array | null {
  const attribute = decoder.GetAttributeByUniqueId(mesh, asked.id);
  if (!attribute?.ptr || attribute.num_components() !== asked.components) return null;
  const real = [draco.DT_FLOAT32, draco.DT_FLOAT64].includes(attribute.data_type());
  const count = mesh.num_points() * asked.components;
  const bytes = count * 4;
  const place = draco._malloc(bytes);
  try {
    const type = real ? draco.DT_FLOAT32 : draco.DT_INT32;
    if (!decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type, bytes, place)) return null;
    return real
      ? new Float32Array(draco.HEAPF32.buffer, place, count).slice()
      : Float32Array.from(new Int32Array(draco.HEAPF32.buffer, place, count));
  } finally {
    draco._free(place);
  }
}

function corners(draco: DecoderModule, decoder: Decoder, mesh: DracoMesh): Uint32Array {
  const count = mesh.num_faces() * 3;
  const place = draco._malloc(count * 4);
  try {
    decoder.GetTrianglesUInt32Array(mesh, count * 4, place);
    return new Uint32Array(draco.HEAPF32.buffer, place, count).slice();
  } finally {
    draco._free(place);
  }
}

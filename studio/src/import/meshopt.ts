import {MeshoptDecoder} from 'meshoptimizer/decoder';
import type {SceneTools} from '../engine/module';

/** SceneTools.meshopt. */
export async function meshoptDecoder(): Promise<Required<SceneTools>['meshopt']> {
  await MeshoptDecoder.ready;
  return (packed, count, stride, mode) => {
    try {
      const bytes = new Uint8Array(count * stride);
      MeshoptDecoder.decodeGltfBuffer(bytes, count, stride, packed.slice(), mode);
      return bytes;
    } catch {
      return null;
    }
  };
}

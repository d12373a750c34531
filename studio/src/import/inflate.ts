import {Inflate} from 'fflate';
import type {SceneTools} from '../engine/module';

/** What comes out of a piece is held before it is counted: at most about a thousand times as much. */
const PIECE = 1 << 14;

/** SceneTools.inflate: raw DEFLATE, never much more than `most` bytes in memory. */
export const inflate: Required<SceneTools>['inflate'] = (packed, most) => {
  if (packed.length === 0) return null;
  const parts: Uint8Array[] = [];
  let size = 0;
  const stream = new Inflate((part) => {
    size += part.length;
    parts.push(part);
  });
  try {
    for (let at = 0; at < packed.length; at += PIECE) {
      stream.push(packed.slice(at, at + PIECE), at + PIECE >= packed.length);
      if (size > most) return null;
    }
  } catch {
    return null;
  }
  return joined(parts, size);
};

function joined(parts: Uint8Array[], size: number): Uint8Array {
  const bytes = new Uint8Array(size);
  let at = 0;
  for (const part of parts) {
    bytes.set(part, at);
    at += part.length;
  }
  return bytes;
}

import {Zip, ZipDeflate, zipSync, type Zippable} from 'fflate';
import type {OutputFile} from '../engine/api';

/** The same in every zip, so that the same design gives the same bytes. */
const TIME = new Date(1980, 0, 1);
/** Takes some hundredths of a second. */
const PIECE = 1 << 19;

/** In the order that they have; for a worker, which nobody waits for. */
export function zipped(members: readonly OutputFile[]): Uint8Array<ArrayBuffer> {
  const contents: Zippable = {};
  for (const {name, bytes} of members) contents[name] = [bytes, {mtime: TIME, level: 9}];
  return zipSync(contents) as Uint8Array<ArrayBuffer>;
}

/** Piece by piece, so that the page stays alive: its policy forbids the workers that fflate would start by itself. */
export async function zippedInPieces(members: readonly OutputFile[]): Promise<Uint8Array<ArrayBuffer>[]> {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const archive = new Zip((error, part) => {
    if (error) throw error;
    parts.push(part as Uint8Array<ArrayBuffer>);
  });
  for (const {name, bytes} of members) {
    const member = new ZipDeflate(name, {level: 6});
    member.mtime = TIME;
    archive.add(member);
    for (let at = 0; at === 0 || at < bytes.length; at += PIECE) {
      member.push(bytes.subarray(at, at + PIECE), at + PIECE >= bytes.length);
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  archive.end();
  return parts;
}

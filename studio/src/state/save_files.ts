import {zip, type Zippable} from 'fflate';
import type {OutputFile} from '../engine/api';
import {isFailure} from '../engine/failure';
import type {Studio} from './studio.svelte';

export type Kind = 'zip' | 'stl' | 'ply';

/** Hands the person what `snug make` writes, byte for byte: all of it in one zip, or the two foams alone. */
export async function exportFiles(studio: Studio, kind: Kind): Promise<void> {
  const {design} = studio;
  // The foams alone need no pack.
  const alone = {...design, workshop: {...design.workshop, for: null}};
  const wanted = kind === 'zip' ? design : {...alone, output: {formats: [kind]}};
  const files = await studio.long('make', (onProgress) => studio.engine.outputFiles(wanted, onProgress));
  if (isFailure(files)) {
    if (files.kind !== 'cancelled') studio.refuse('make', files.error);
    return;
  }
  if (kind === 'zip') return download(`${stem(studio)}-foam.zip`, await zipped(await withObject(studio, files)));
  for (const file of files) if (file.name.endsWith(`.${kind}`)) download(file.name, file.bytes);
}

export async function saveProject(studio: Studio): Promise<void> {
  const text = await studio.engine.projectText(studio.design);
  download(`${stem(studio)}.snug.json`, new TextEncoder().encode(text));
}

/** A project whose object lies in no file of the person's gets it as company. */
async function withObject(studio: Studio, files: OutputFile[]): Promise<OutputFile[]> {
  const {file} = studio;
  if (!file?.converted) return files;
  return [...files, {name: file.name, bytes: new Uint8Array(await file.content.arrayBuffer())}];
}

function zipped(files: OutputFile[]): Promise<Uint8Array<ArrayBuffer>> {
  const members: Zippable = {};
  // The same time in every zip, so that the same design gives the same bytes.
  for (const {name, bytes} of files) members[name] = [bytes, {mtime: new Date(1980, 0, 1)}];
  return new Promise((resolve, reject) =>
    zip(members, {level: 6}, (error, data) => (error ? reject(error) : resolve(data as Uint8Array<ArrayBuffer>))),
  );
}

function stem(studio: Studio): string {
  return (studio.object?.file.name ?? 'snug').replace(/\.[^.]+$/, '');
}

function download(name: string, bytes: Uint8Array<ArrayBuffer>) {
  const address = URL.createObjectURL(new Blob([bytes], {type: 'application/octet-stream'}));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  // The browser still reads from it when click() returns.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

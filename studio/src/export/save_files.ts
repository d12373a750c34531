import type {OutputFile} from '../engine/api';
import {isFailure} from '../engine/failure';
import {isScene} from '../import/bundle';
import {savedFiles} from '../state/saved_files.svelte';
import type {Studio} from '../state/studio.svelte';
import {language} from '../words/language.svelte';
import {zippedInPieces} from './zip';

export type Kind = 'zip' | 'stl' | 'ply';

/** Hands the person what `snug make` writes, byte for byte: all of it in one zip, or the two foams alone. */
export async function exportFiles(studio: Studio, kind: Kind): Promise<void> {
  const {design, objects} = studio.moment;
  // The same name again shall be heard, too.
  savedFiles.clear();
  // The foams alone need no pack.
  const alone = {...design, workshop: {...design.workshop, for: null}};
  const wanted = kind === 'zip' ? design : {...alone, output: {formats: [kind]}};
  const files = await studio.long('make', (onProgress) => studio.engine.outputFiles(wanted, language.code, onProgress, objects));
  if (isFailure(files)) {
    if (files.kind !== 'cancelled') studio.refuse('make', files.error);
    return;
  }
  if (kind === 'zip') return download(`${stem(studio)}-foam.zip`, await zippedInPieces(await withObjects(studio, files)));
  const foams = files.filter(({name}) => name.endsWith(`.${kind}`));
  for (const {name, bytes} of foams) download(name, [bytes]);
  savedFiles.names = foams.map(({name}) => name);
}

export async function saveProject(studio: Studio): Promise<void> {
  const {design, objects} = studio.moment;
  const text = await studio.engine.projectText(design, objects);
  download(`${stem(studio)}.snug.json`, [new TextEncoder().encode(text)]);
}

/** A person's own foams, as the command line reads them. */
export function saveFoams(text: string): void {
  download('foams.json', [new TextEncoder().encode(text)]);
}

/** Objects that Snug made, and scenes or archives with the files they were read with, come with their project. */
async function withObjects(studio: Studio, files: OutputFile[]): Promise<OutputFile[]> {
  const all = [...files];
  for (const file of studio.files) {
    if (!file.converted && !isScene(file.name)) continue;
    for (const {name, content} of [file, ...(file.beside ?? [])])
      if (all.every((other) => other.name !== name)) all.push({name, bytes: new Uint8Array(await content.arrayBuffer())});
  }
  return all;
}

/** What files are called after: the first object. */
export function stem(studio: Studio): string {
  return (studio.objects[0]?.file.name ?? 'snug').replace(/\.[^.]+$/, '');
}

export function download(name: string, parts: Uint8Array<ArrayBuffer>[]) {
  const address = URL.createObjectURL(new Blob(parts, {type: 'application/octet-stream'}));
  const link = document.createElement('a');
  link.href = address;
  link.download = name;
  link.click();
  savedFiles.names = [name];
  // The browser still reads from it when click() returns.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

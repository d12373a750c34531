import {isFailure} from '../engine/failure';
import type {OpenTexts} from './open_files';
import {openFiles} from './open_files';
import type {Studio} from './studio.svelte';

/** What `snug studio OBJECT` says of the object that it serves. */
export interface ServedObject {
  name: string;
  /** The file that the server was given. */
  original: string;
  bytes: number;
  sha256: string;
  project: boolean;
  /** Only a copy for looking, whose surface is nowhere farther than `deviation` from the original's (in the unit
   *  of the file). */
  thinned: boolean;
  triangles?: number;
  shown_triangles?: number;
  deviation?: number;
}

/** Opens the object of the local server that served the page, if it was asked to. False where there is none. */
export async function openServed(studio: Studio, texts: OpenTexts): Promise<boolean> {
  if (!new URLSearchParams(location.search).has('object')) return false;
  const answer = await fetch('object/info').catch(() => null);
  if (!answer?.ok) return false;
  const info = (await answer.json()) as ServedObject;
  const files = await studio.reading(info, async () => {
    const served = [new File([await (await fetch('object/file')).blob()], info.name)];
    if (info.project) served.push(new File([await (await fetch('object/project')).blob()], `${info.name}.snug.json`));
    return served;
  });
  if (isFailure(files)) return true;
  await openFiles(studio, files, texts);
  if (info.thinned) {
    studio.thinned = {name: info.original, deviation: info.deviation ?? 0};
    studio.notice = null;
  }
  return true;
}

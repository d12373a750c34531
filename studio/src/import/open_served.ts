import {isFailure} from '../engine/failure';
import type {Studio} from '../state/studio.svelte';
import {openFiles} from './open_files';

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
  /** Names of the files beside it that it needs; the server has them by their numbers. */
  beside?: string[];
}

/** Opens the object of the local server that served the page, if it was asked to. False where there is none. */
export async function openServed(studio: Studio): Promise<boolean> {
  if (!new URLSearchParams(location.search).has('object')) return false;
  const answer = await fetch('object/info').catch(() => null);
  if (!answer?.ok) return false;
  const info = (await answer.json()) as ServedObject;
  const file = async (part: string, name: string) => new File([await (await fetch(`object/${part}`)).blob()], name);
  const files = await studio.reading(info, async () => {
    const beside = info.thinned ? [] : (info.beside ?? []);
    const served = await Promise.all([
      file('file', info.name),
      ...beside.map((name, i) => file(`beside/${i}`, name.replace(/^.*[/\\]/, ''))),
    ]);
    if (info.project) served.push(await file('project', `${info.name}.snug.json`));
    return served;
  });
  if (isFailure(files)) return true;
  await openFiles(studio, files);
  if (info.thinned) {
    studio.thinned = {name: info.original, deviation: info.deviation ?? 0};
    studio.notice = null;
  }
  return true;
}

import type {Design, ObjectFile} from '../engine/api';
import {isFailure} from '../engine/failure';
import {firstMakeLine} from '../engine/make_line';
import type {BesideFile} from '../engine/scene_tools';
import {bundled} from './bundle';
import type {Studio} from './studio.svelte';

/** More than a page can hold as a file, as a mesh and as foams at once: WebAssembly ends at 4 GB. */
const MOST_BYTES = 1_000_000_000;

export interface OpenTexts {
  tooBig: (name: string, line: string) => string;
  openObjectOf: (name: string) => string;
  otherContent: (name: string) => string;
  leftOut: (names: string[]) => string;
}

/** Projects that wait for their object. */
let waiting: {object: ObjectFile; design: Design} | null = null;

/** Whatever a person drops or chooses: an object, a project, or both. A sentence says what went wrong; then everything
 *  stays as it was. */
export async function openFiles(studio: Studio, files: readonly File[], texts: OpenTexts): Promise<void> {
  const project = files.find(({name}) => /\.json$/i.test(name));
  const {object, beside, leftOut} = bundled(files.filter((file) => file !== project));
  if (project && !(await readProject(studio, project, texts, object !== undefined))) return;
  const before = studio.object;
  if (object)
    await openObject(studio, object, beside.map((file) => ({name: file.name, content: file})), texts);
  if (leftOut.length > 0 && studio.object !== before)
    studio.notice = [studio.notice, texts.leftOut(leftOut.map(({name}) => name))].filter(Boolean).join(' ');
}

async function readProject(studio: Studio, file: File, texts: OpenTexts, objectComes: boolean): Promise<boolean> {
  const read = await studio.engine.parseProject(await file.text());
  if (isFailure(read)) {
    studio.refuse('object', `${file.name}: ${read.error}`);
    return false;
  }
  const here = studio.object?.file;
  if (!objectComes && here && here.sha256 !== '' && here.sha256 === read.object.sha256) {
    studio.change(() => read.design, 'project');
    return true;
  }
  waiting = read;
  if (!objectComes) studio.notice = texts.openObjectOf(read.object.name);
  return true;
}

async function openObject(
  studio: Studio,
  file: File,
  beside: readonly BesideFile[],
  texts: OpenTexts,
): Promise<void> {
  if (file.size > MOST_BYTES)
    return studio.refuse('object', texts.tooBig(file.name, firstMakeLine(file.name, studio.defaults)));
  const project = waiting;
  waiting = null;
  const failed = await studio.openObject(file.name, file, {beside, design: project?.design});
  if (failed) {
    waiting = project;
    return;
  }
  studio.notice =
    project && project.object.sha256 !== '' && studio.object?.file.sha256 !== project.object.sha256
      ? texts.otherContent(project.object.name)
      : null;
}

export async function openSample(studio: Studio, name: string): Promise<void> {
  const failed = await studio.openObject(name, async () => {
    const file = await studio.engine.sampleFile(name);
    return isFailure(file) ? file : {name: file.name, content: new Blob([file.bytes]), converted: true};
  });
  if (!failed) studio.notice = null;
}

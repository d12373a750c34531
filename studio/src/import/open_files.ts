import {firstDesign} from '../design/edit';
import type {BesideFile, ObjectFile, Project} from '../engine/api';
import {isFailure} from '../engine/failure';
import {sha256} from '../engine/sha256';
import type {Studio} from '../state/studio.svelte';
import {files as words} from '../words/files';
import {about, joined, type Pair} from '../words/words';
import {bundled} from './bundle';

const texts = words.files;

/** More than a page can hold as a file, as a mesh and as foams at once: WebAssembly ends at 4 GB. */
const MOST_BYTES = 1_000_000_000;

/** A project that waits for its object. */
let waiting: Project | null = null;

/** Whatever a person drops or chooses: an object, a project, or both. A sentence says what went wrong; then everything
 *  stays as it was. */
export async function openFiles(studio: Studio, files: readonly File[]): Promise<void> {
  const notes = files.filter(({name}) => /\.json$/i.test(name));
  const {object, beside, leftOut} = bundled(files.filter((file) => !notes.includes(file)));
  const {project, unread, refused} = await readProject(studio, notes);
  // What is no project at all may lie beside an object; a project that cannot be read is asked for.
  if (refused && (!object || refused.meant)) return studio.refuse('object', refused.sentence);
  if (!object) return project ? useProject(studio, project) : undefined;
  const before = studio.object;
  await openObject(studio, object, beside.map((file) => ({name: file.name, content: file})), project);
  if (studio.object === before) return;
  if (leftOut.length > 0) alsoSay(studio, texts.leftOut(leftOut.map(({name}) => name)));
  if (unread.length > 0) alsoSay(studio, texts.noProject(unread.map(({name}) => name)));
}

/** The first of the files that is a project; else why one is not, first of all one that means to be. */
async function readProject(studio: Studio, files: readonly File[]) {
  let refused: {sentence: Pair; meant: boolean} | null = null;
  for (const file of files) {
    const text = await file.text();
    const read = await studio.engine.parseProject(text);
    if (!isFailure(read)) return {project: read, unread: files.filter((other) => other !== file), refused: null};
    const meant = /"(snug|design)"/.test(text);
    if (!refused || (meant && !refused.meant)) refused = {sentence: about(file.name, read.error), meant};
  }
  return {project: null, unread: files, refused};
}

/** A project without its object is for the one that is open, or waits. */
function useProject(studio: Studio, project: Project): void {
  const here = studio.object?.file;
  if (here && here.sha256 !== '' && here.sha256 === project.object.sha256) return studio.change(() => project.design, 'project');
  waiting = project;
  studio.notice = texts.openObjectOf(project.object.name);
}

async function openObject(
  studio: Studio,
  file: File,
  beside: readonly BesideFile[],
  with_it: Project | null,
): Promise<void> {
  if (file.size > MOST_BYTES) {
    const line = await studio.engine.commandLine(file.name, firstDesign(studio.defaults));
    return studio.refuse('object', texts.tooBig(file.name, isFailure(line) ? 'snug make' : line));
  }
  const waited = with_it ?? waiting;
  const project = with_it ?? (waited && (await isOf(file, waited.object)) ? waited : null);
  waiting = null;
  const failed = await studio.openObject(file.name, file, {beside, design: project?.design});
  if (failed) {
    waiting = waited;
    return;
  }
  const other = project && project.object.sha256 !== '' && studio.object?.file.sha256 !== project.object.sha256;
  studio.notice = other ? texts.otherContent(project.object.name) : null;
  if (waited && !project) alsoSay(studio, texts.waitsNoMore(waited.object.name));
}

/** A project's object by its name, which may have other content by now, or by its content, whatever its name is now. */
async function isOf(file: File, object: ObjectFile): Promise<boolean> {
  if (file.name === object.name || object.name === '') return true;
  if (file.size !== object.bytes || object.sha256 === '') return false;
  return (await sha256(new Uint8Array(await file.arrayBuffer()))) === object.sha256;
}

function alsoSay(studio: Studio, sentence: Pair): void {
  studio.notice = studio.notice ? joined([studio.notice, sentence], ' ') : sentence;
}

export async function openSample(studio: Studio, name: string): Promise<void> {
  const failed = await studio.openObject(name, async () => {
    const file = await studio.engine.sampleFile(name);
    return isFailure(file) ? file : {name: file.name, content: new Blob([file.bytes]), converted: true};
  });
  if (failed) return;
  studio.notice = waiting && texts.waitsNoMore(waiting.object.name);
  waiting = null;
}

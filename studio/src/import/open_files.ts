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

/** A project that waits for its objects, and the files of those that came so far. */
let waiting: {project: Project; files: (File | null)[]} | null = null;

/** Whatever a person drops or chooses: objects, a project, or both. Objects without a project take the place of what is
 *  open, or join it. A sentence says what went wrong; then everything stays as it was. Whether objects are open now for which
 *  nobody has chosen anything. */
export async function openFiles(studio: Studio, files: readonly File[], {joins = false} = {}): Promise<boolean> {
  const fresh = waiting === null && !(joins && studio.object);
  const {whole, projects} = await fromPacks(studio, files);
  const notes = [...whole.filter(({name}) => /\.json$/i.test(name)), ...projects];
  const {objects: given, beside, leftOut} = bundled(whole.filter((file) => !notes.includes(file)));
  const {project, unread, refused} = await readProject(studio, notes);
  const objects = [...given, ...measuredIn(project)];
  // What is no project at all may lie beside an object; a project that cannot be read is asked for.
  if (refused && (objects.length === 0 || refused.meant)) {
    studio.refuse('object', refused.sentence);
    return false;
  }
  if (objects.length === 0) {
    if (project) useProject(studio, project);
    return false;
  }
  const company = beside.map((file) => ({name: file.name, content: file}));
  if (!(await openObjects(studio, objects, company, project, joins))) return false;
  const unused = [...leftOut, ...beside.filter((file) => isForeign(studio, file))];
  if (unused.length > 0) alsoSay(studio, texts.leftOut(unused.map(({name}) => name)));
  if (unread.length > 0) alsoSay(studio, texts.noProject(unread.map(({name}) => name)));
  return fresh && !project;
}

/** What objects come with for the eye alone, and which nobody misses. */
const LOOKS = /\.(mtl|png|jpe?g|webp|ktx2?|tga|bmp|tiff?)$/i;

/** No object that is open was read with it. */
function isForeign({objects}: Studio, {name}: File): boolean {
  return !LOOKS.test(name) && !name.startsWith('.') && !objects.some(({beside}) => beside.includes(name));
}

/** The projects of packs that come back as they were handed over, and the files without those packs that have no object. */
async function fromPacks(studio: Studio, files: readonly File[]) {
  const projects: File[] = [];
  const whole: File[] = [];
  for (const file of files) {
    const packed = /\.zip$/i.test(file.name) && file.size <= MOST_BYTES ? await studio.engine.packedProject(file) : null;
    const text = packed && !isFailure(packed) ? packed.text : null;
    if (text !== null) projects.push(new File([text], `${file.name}.json`));
    if (text === null || (packed && !isFailure(packed) && packed.whole)) whole.push(file);
  }
  return {whole, projects};
}

/** What a project itself has of its objects: those that are made of measurements. */
function measuredIn(project: Project | null): File[] {
  return (project?.objects ?? []).flatMap(({name, shape}) => (shape ? [new File([shape], name)] : []));
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

/** A project without its objects is for those that are open, or waits. */
function useProject(studio: Studio, project: Project): void {
  const here = project.objects.map(({sha256: wanted}) => studio.objects.find(({file}) => wanted !== '' && file.sha256 === wanted));
  const ids = here.flatMap((info) => info?.id ?? []);
  if (new Set(ids).size === project.objects.length) {
    const objects = project.objects.map(({own}, i) => ({id: ids[i]!, own}));
    return studio.becomes({design: project.design, objects}, 'project');
  }
  waiting = {project, files: project.objects.map(() => null)};
  askForMissing(studio);
}

function askForMissing(studio: Studio) {
  const missing = waiting?.project.objects.filter((_, i) => !waiting?.files[i]).map(({name}) => name) ?? [];
  studio.notice = texts.openObjectOf(missing.join(', '));
}

const namesOf = ({project}: NonNullable<typeof waiting>) => project.objects.map(({name}) => name).join(', ');

/** Whether they are open now. */
async function openObjects(
  studio: Studio,
  files: readonly File[],
  beside: readonly BesideFile[],
  with_it: Project | null,
  joins: boolean,
): Promise<boolean> {
  const big = files.find(({size}) => size > MOST_BYTES);
  if (big) {
    const line = await studio.engine.commandLine(big.name, firstDesign(studio.defaults));
    studio.refuse('object', texts.tooBig(big.name, isFailure(line) ? 'snug make' : line));
    return false;
  }
  const waited = with_it ? {project: with_it, files: with_it.objects.map(() => null)} : waiting;
  if (waited) return openAwaited(studio, files, beside, waited, {meant: with_it !== null, joins});
  return openAnew(studio, files, beside, joins);
}

async function openAnew(studio: Studio, files: readonly File[], beside: readonly BesideFile[], joins: boolean): Promise<boolean> {
  const [only] = files;
  const failed =
    files.length === 1 && !joins
      ? await studio.openObject(only!.name, only!, {beside})
      : await studio.openItems(files.map((file) => ({name: file.name, content: file, beside})), joins);
  if (!failed) studio.notice = null;
  return failed === null;
}

/** Files where a project waits for its objects. `meant`: they came with it; others are opened as openFiles() says. */
async function openAwaited(
  studio: Studio,
  files: readonly File[],
  beside: readonly BesideFile[],
  waited: NonNullable<typeof waiting>,
  {meant, joins}: {meant: boolean; joins: boolean},
): Promise<boolean> {
  const {project} = waited;
  const found: (File | null)[] = [...waited.files];
  const left = [...files];
  for (const [i, object] of project.objects.entries()) {
    if (found[i]) continue;
    const file = await firstOf(left, object);
    if (!file) continue;
    found[i] = file;
    // One file may be several objects, each with choices of its own.
    if (!project.objects.some((other, k) => k > i && other.sha256 === object.sha256)) left.splice(left.indexOf(file), 1);
  }
  // One object by itself is meant whatever it is called.
  if (meant && project.objects.length === 1 && !found[0]) found[0] = left.shift() ?? null;
  if (!meant && left.length === files.length) {
    waiting = null;
    const opened = await openAnew(studio, files, beside, joins);
    if (opened) studio.notice = texts.waitsNoMore(namesOf(waited));
    else waiting = waited;
    return opened;
  }
  if (found.includes(null)) {
    waiting = {project, files: found};
    askForMissing(studio);
    return false;
  }
  waiting = null;
  const whole = found.filter((file) => file !== null);
  const given = whole.map((file) => ({name: file.name, content: file, beside}));
  const failed =
    whole.length === 1
      ? await studio.openObject(whole[0]!.name, whole[0]!, {beside, design: project.design})
      : await studio.openProject(project, given);
  if (failed) {
    waiting = meant ? null : waited;
    return false;
  }
  const other = project.objects.filter(({sha256: wanted}, i) => wanted !== '' && wanted !== studio.objects[i]?.file.sha256);
  studio.notice = other.length > 0 ? texts.otherContent(other.map(({name}) => name).join(', ')) : null;
  return true;
}

/** A project's object by its content, whatever its name is now, or else by its name, which may have other content by
 *  now. */
async function firstOf(files: readonly File[], object: ObjectFile): Promise<File | null> {
  for (const file of files) if (await hasContentOf(file, object)) return file;
  return files.find(({name}) => name === object.name || object.name === '') ?? null;
}

async function hasContentOf(file: File, object: ObjectFile): Promise<boolean> {
  if (file.size !== object.bytes || object.sha256 === '') return false;
  return (await sha256(new Uint8Array(await file.arrayBuffer()))) === object.sha256;
}

function alsoSay(studio: Studio, sentence: Pair): void {
  studio.notice = studio.notice ? joined([studio.notice, sentence], ' ') : sentence;
}

/** `joins`: beside what is open. Whether it is open now. */
export async function openSample(studio: Studio, name: string, joins = false): Promise<boolean> {
  const make = async () => {
    const file = await studio.engine.sampleFile(name);
    return isFailure(file) ? file : {name: file.name, content: new Blob([file.bytes]), converted: true};
  };
  const failed = await studio.openObject(name, make, {joins});
  if (failed) return false;
  studio.notice = waiting && texts.waitsNoMore(namesOf(waiting));
  waiting = null;
  return true;
}

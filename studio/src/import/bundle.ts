/** Which of several files are objects, told by their names as the library does in a zip (snug/formats/bundle.h). */

/** What a bundle may hold as its object; an archive only where there is nothing else. */
const OBJECT = /\.(stl|obj|ply|off|glb|gltf|3mf|xyz|pts|shape)$/i;
const ARCHIVE = /\.zip$/i;

export interface Bundle<T> {
  objects: T[];
  /** What is no object: the objects may need it. */
  beside: T[];
  /** Archives beside objects, which may hold the same. */
  leftOut: T[];
}

/** The files whose names are objects'; where no name is, the first of all, so that its refusal says what is read. */
export function bundled<T extends {name: string}>(files: readonly T[]): Bundle<T> {
  const seen = files.filter(({name}) => !name.startsWith('.'));
  const of = (kind: RegExp) => seen.filter(({name}) => kind.test(name));
  const archives = of(ARCHIVE);
  const found = [of(OBJECT), archives, files.slice(0, 1)].find((some) => some.length > 0);
  const objects = found ?? [];
  const leftOut = archives.filter((file) => !objects.includes(file));
  return {objects, beside: files.filter((file) => !objects.includes(file) && !leftOut.includes(file)), leftOut};
}

/** Files that hold several parts, or other files. */
export function isScene(name: string): boolean {
  return /\.(glb|gltf|3mf|zip)$/i.test(name);
}

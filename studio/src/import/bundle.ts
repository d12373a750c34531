/** Which of several files is the object, as the library chooses in a zip (snug/formats/bundle.h). */

/** What a bundle may hold as its object; an archive only where there is nothing else. */
const OBJECT = /\.(stl|obj|ply|off|glb|gltf|3mf|xyz|pts)$/i;
const ARCHIVE = /\.zip$/i;

export interface Bundle<T> {
  object: T | undefined;
  /** What is no object: the object may need it. */
  beside: T[];
  /** Other objects: there is one at a time. */
  leftOut: T[];
}

/** The first file whose name is an object's; where no name is, the first of all, so that its refusal says what is
 *  read. */
export function bundled<T extends {name: string}>(files: readonly T[]): Bundle<T> {
  const seen = files.filter(({name}) => !name.startsWith('.'));
  const objects = [OBJECT, ARCHIVE].flatMap((kind) => seen.filter(({name}) => kind.test(name)));
  const object = objects[0] ?? files[0];
  const beside = files.filter((file) => file !== object && !objects.includes(file));
  return {object, beside, leftOut: objects.slice(1)};
}

/** Files that hold several parts, or other files. */
export function isScene(name: string): boolean {
  return /\.(glb|gltf|3mf|zip)$/i.test(name);
}

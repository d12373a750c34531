/** Which of several files is the object, as the library chooses in a zip (snug/formats/bundle.h). */

/** What a bundle may hold as its object. */
const OBJECT = /\.(stl|obj|ply|off|glb|gltf|3mf|xyz|pts)$/i;

export interface Bundle<T> {
  object: T | undefined;
  /** Other objects: there is one at a time. */
  leftOut: T[];
}

/** The first file whose name is an object's; where no name is, the first of all, so that its refusal says what is
 *  read. */
export function bundled<T extends {name: string}>(files: readonly T[]): Bundle<T> {
  const objects = files.filter(({name}) => OBJECT.test(name) && !name.startsWith('.'));
  return {object: objects[0] ?? files[0], leftOut: objects.slice(1)};
}

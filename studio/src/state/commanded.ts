import type {Design} from '../design/design';
import type {Moment, ObjectUse} from '../design/moment';
import type {ObjectInfo} from '../engine/api';

/** What a command line is to make, and of which files, one for each object. */
export interface Commanded {
  files: string[];
  design: Design;
  objects: readonly ObjectUse[];
}

/** Of a file that states its unit in no other. `infos`: of the objects, as the moment numbers them. */
export function commanded({design, objects}: Moment, infos: readonly ObjectInfo[]): Commanded {
  const stated = (at: number) => infos[at]?.statesUnit === true;
  const uses = objects.map((use, i) => (use.own && stated(i) ? {...use, own: {...use.own, units: null}} : use));
  const object = objects.length === 1 && stated(0) ? {...design.object, units: null} : design.object;
  return {files: infos.map(({file}) => file.name), design: {...design, object}, objects: uses};
}

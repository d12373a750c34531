import type {Pair} from '../words/words';
import type {Design, OptionPath} from './table';

// The table of options as the library hands it over (snug/design/options_schema.h): what a field may be, beside its type.

export type {OptionPath};

/** A place on an item that foam keeps away from (snug/design/zone.h): balls in its file's coordinates, mm, or a part. */
export type Zone = Design['protection']['zones'][number];

export interface OptionRow {
  kind:
    | 'switch'
    | 'integer'
    | 'number'
    | 'text'
    | 'word'
    | 'numbers'
    | 'integers'
    | 'levels'
    | 'words'
    | 'pieces'
    | 'curve'
    | 'zones'
    | 'edits'
    | 'weights'
    | 'group'
    | 'list';
  label: Pair;
  help?: Pair;
  unit?: string;
  least?: number;
  most?: number;
  /** The least itself is not allowed. */
  above?: boolean;
  or_zero?: boolean;
  step?: number;
  /** Of a wall that is not chosen, where the space is fitted to the object. */
  fitted?: number;
  /** The same of a tray. */
  tray?: number;
  /** What few go above. */
  often?: number;
  /** Of its numbers, for which one number may stand where `or_one` says so. */
  count?: number;
  or_one?: boolean;
  words?: string[];
  optional?: boolean;
  /** What a project says for no value, where that is not null. */
  none?: string;
  default?: unknown;
  /** What the command line calls it. */
  flag?: string;
}

export type Schema = Readonly<Record<OptionPath, OptionRow>>;

/** What follows from a design's other choices. `usual`: what an option comes to that is left open. */
export type Dependent = Readonly<Partial<Record<OptionPath, {usual?: unknown; least?: number; most?: number}>>>;

/** What a field is called: "the least rib" in a sentence is its "Least rib". */
export function fieldName({label: [en, ja]}: OptionRow): Pair {
  const name = en.replace(/^(the|an?) /, '');
  return [name.charAt(0).toUpperCase() + name.slice(1), ja];
}

type Tree = {readonly [name: string]: unknown};

export function valueAt(design: Design, path: OptionPath): unknown {
  return path.split('.').reduce<unknown>((part, name) => (part as Tree | null)?.[name], design);
}

export function withValue(design: Design, path: OptionPath, value: unknown): Design {
  const set = (part: Tree, [name, ...rest]: readonly string[]): Tree => {
    const inner = rest.length > 0 ? set(part[name!] as Tree, rest) : value;
    // Of a list, such as the items, a copy with another at its number.
    if (Array.isArray(part)) return part.map((one: unknown, at) => (at === Number(name) ? inner : one)) as unknown as Tree;
    return {...part, [name!]: inner};
  };
  return set(design as unknown as Tree, path.split('.')) as unknown as Design;
}

/** What an option comes to: as it was chosen, else as the other choices make it; null where it is simply not there. */
export function comesTo(design: Design, path: OptionPath, dependent: Dependent): unknown {
  return valueAt(design, path) ?? dependent[path]?.usual ?? null;
}

/** A number's bounds in a design. What may be missing, or 0 besides, goes down to 0. */
export function bounds(row: OptionRow, dependent?: Dependent[OptionPath]): {min?: number; max?: number} {
  const {least, most} = {...row, ...dependent};
  if (least === undefined || most === undefined) return {};
  return {min: (row.optional || row.or_zero) && least > 0 ? 0 : least, max: most};
}

/** The options of a group in the table's order; none where there is no such group. */
export function pathsBelow(schema: Schema, group: string): OptionPath[] {
  return (Object.keys(schema) as OptionPath[]).filter((path) => path.startsWith(`${group}.`));
}

/** All that a group has where nothing is said. */
export function usualGroup(schema: Schema, group: OptionPath): Tree {
  return Object.fromEntries(pathsBelow(schema, group).map((path) => [path.slice(group.length + 1), schema[path].default]));
}

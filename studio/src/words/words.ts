/** What a person reads, in English and in Japanese. */
export type Pair = readonly [en: string, ja: string];
type Tree = Pair | readonly Pair[] | ((...values: never[]) => Pair) | {readonly [name: string]: Tree};

/** The same in one language. */
export type Spoken<T> =
  T extends Pair ? string
  : T extends readonly Pair[] ? readonly string[]
  : T extends (...values: infer V) => Pair ? (...values: V) => string
  : {readonly [Name in keyof T]: Spoken<T[Name]>};

/** Names that are fixed: asking for another one is an error of types. */
export function words<const T extends Tree>(all: T): T {
  return all;
}

/** Words for names that come from the library, which may know more of them. */
export function byName(all: Record<string, Pair>): Record<string, Pair> {
  return all;
}

/** Japanese for labels of the library, which are English already. */
export function byLabel(all: Record<string, string>): Record<string, Pair> {
  return Object.fromEntries(Object.entries(all).map(([label, ja]) => [label, [label, ja]]));
}

/** `language`: its place in a pair. */
export function spoken<T extends Tree>(all: T, language: 0 | 1): Spoken<T> {
  return pick(all, language) as Spoken<T>;
}

function pick(all: Tree, language: 0 | 1): unknown {
  if (typeof all === 'function') return (...values: never[]) => all(...values)[language];
  if (isPair(all)) return all[language];
  if (Array.isArray(all)) return all.map((each: Pair) => each[language]);
  return Object.fromEntries(Object.entries(all).map(([name, each]) => [name, pick(each as Tree, language)]));
}

function isPair(all: Tree): all is Pair {
  return Array.isArray(all) && typeof all[0] === 'string';
}

/** What a person reads, in English and in Japanese. */
export type Pair = readonly [en: string, ja: string];
type Tree = Pair | readonly Pair[] | ((...values: never[]) => Pair) | {readonly [name: string]: Tree | undefined};

/** The same in one language. */
export type Spoken<T> =
  T extends undefined ? undefined
  : T extends Pair ? string
  : T extends readonly Pair[] ? readonly string[]
  : T extends (...values: infer V) => Pair ? (...values: V) => string
  : {readonly [Name in keyof T]: Spoken<T[Name]>};

/** Several sentences behind each other. */
export function joined(pairs: readonly Pair[], between: string): Pair {
  return [pairs.map(([en]) => en).join(between), pairs.map(([, ja]) => ja).join(between)];
}

/** With the name of what it is about, where it does not say it. */
export function about(name: string, [en, ja]: Pair): Pair {
  return [en.includes(name) ? en : `${name}: ${en}`, ja.includes(name) ? ja : `${name}：${ja}`];
}

/** Names that are fixed: asking for another one is an error of types. */
export function words<const T extends Tree>(all: T): T {
  return all;
}

/** Words for names that come from the library, which may know more of them. */
export function byName(all: Record<string, Pair>): Record<string, Pair> {
  return all;
}

/** What a field is called and what it means. */
type FieldWords = {
  readonly name: Pair;
  readonly tip: Pair;
  readonly parts?: readonly Pair[];
  readonly words?: {readonly [word: string]: Pair};
};

/** Words for fields, which have paths of the library. */
export function byPath(all: {readonly [path: string]: FieldWords}): {readonly [path: string]: FieldWords} {
  return all;
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

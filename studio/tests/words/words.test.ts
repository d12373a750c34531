import {describe, expect, it} from 'vitest';
import {ALL, en, ja} from '../../src/words/texts';
import {spoken, words} from '../../src/words/words';

type Sentence = (...values: unknown[]) => string;

/** Every text of a tree by its path, a list's by its numbers. */
function leaves(tree: object, path = ''): [string, string | Sentence][] {
  return Object.entries(tree).flatMap(([name, each]: [string, unknown]) =>
    typeof each === 'string' || typeof each === 'function'
      ? [[path + name, each as string | Sentence] as [string, string | Sentence]]
      : leaves(each as object, `${path}${name}.`),
  );
}

/** Stands for a value of any type, and is found in the sentence again. */
const mark = (i: number) => ({toString: () => `⟦${i}⟧`, join: () => `⟦${i}⟧`, [Symbol.iterator]: () => [`⟦${i}⟧`, `⟦${i}⟧`].values()});

const english = leaves(en);
const japanese = new Map(leaves(ja));

describe('the words of the studio', () => {
  it('are there in both languages, and none is empty', () => {
    expect(english.length).toBeGreaterThan(500);
    expect([...japanese.keys()]).toEqual(english.map(([path]) => path));
    for (const [path, text] of [...english, ...japanese]) if (typeof text === 'string') expect(text.trim(), path).not.toBe('');
  });

  it('say the same values in both', () => {
    const sentences = english.filter((entry): entry is [string, Sentence] => typeof entry[1] === 'function');
    expect(sentences.length).toBeGreaterThan(30);
    for (const [path, say] of sentences) {
      const sayInJapanese = japanese.get(path) as Sentence;
      // As many as any sentence takes.
      const values = [0, 1, 2, 3].map(mark);
      const said = (sentence: string) => [...new Set(sentence.match(/⟦\d⟧/g))].sort();
      const values_said = said(say(...values));
      expect(values_said.length, path).toBeGreaterThan(0);
      expect(said(sayInJapanese(...values)), path).toEqual(values_said);
    }
  });

  it('are Japanese in Japanese, but for names that are the same everywhere', () => {
    const written = (text: string | Sentence) => (typeof text === 'string' ? text : text(...[0, 1, 2, 3].map(mark)));
    const same = english.filter(([path, text]) => written(text) === written(japanese.get(path)!)).map(([path]) => path);
    expect(same).toEqual(['fields.workshop.paper.words.a4', 'fields.workshop.paper.words.a3']);
  });
});

it('a tree is spoken in either language, lists and sentences too', () => {
  const tree = words({name: ['cat', '猫'], list: [['one', '一'], ['two', '二']], of: {n: (n: number) => [`${n} cats`, `猫${n}匹`]}});
  expect(spoken(tree, 0).list).toEqual(['one', 'two']);
  expect(spoken(tree, 1).of.n(3)).toBe('猫3匹');
  expect(Object.keys(ALL).sort()).toEqual(Object.keys(en).sort());
});

import {readFileSync} from 'node:fs';
import {expect, test} from 'vitest';
import {ALL} from '../../src/words/texts';

// The manual speaks in the words of the page.

// Labels that come from the library, and what a person reads inside a text that is made of several.
const OTHERS = ['Layer', '段', 'fit test', '1557', 'liner'];

/** Every text in both languages; of those that take values how they are written. */
function textsOf(tree: unknown): string[] {
  if (typeof tree === 'string' || typeof tree === 'function') return [String(tree)];
  return Object.values(tree as object).flatMap(textsOf);
}

const known = textsOf(ALL).join('\n');
const read = (name: string) => readFileSync(new URL(`../../../docs/${name}`, import.meta.url), 'utf8').replace(/^#.*|^\d+\. \[.*|!\[.*/gm, '');

const QUOTED = {
  'guide.md': /(?<!\*)\*([^*\n]+(?:\n[^*\n]+)?)\*(?!\*)/g,
  'guide.ja.md': /「([^」]+)」/g,
};

test.each(Object.entries(QUOTED))('%s says what the page says', (name, said) => {
  // A field that is named by its first words only, a button with its sign, the step that comes next.
  const parts = (quoted: string) => quoted.replace(/\s+/g, ' ').replace(/^\+ /, '').split(/(?<=^(?:Next|次へ))[:：] ?/);
  const quoted = [...read(name).matchAll(said)].map(([, what]) => what!);
  expect(quoted.length).toBeGreaterThan(60);
  expect(quoted.filter((what) => !OTHERS.includes(what) && !parts(what).every((part) => known.includes(part)))).toEqual([]);
});

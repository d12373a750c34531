import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {expect, test} from 'vitest';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));

/** The texts of a folder; in C++ a sentence goes on in the next string. */
function texts(folder: string, ending: RegExp): [string, string][] {
  const files = readdirSync(join(ROOT, folder)).filter((name) => ending.test(name));
  return files.map((name) => [`${folder}/${name}`, readFileSync(join(ROOT, folder, name), 'utf8').replace(/"\s*\n\s*"/g, '')]);
}
const all = [...texts('studio/src/words', /\.ts$/), ...texts('snug/words', /\.cpp$/), ...texts('snug/design', /\.(h|cpp)$/)];

/** Words that mean something else to a reader, or for which there is another one on the page. */
const NEVER: Record<string, RegExp> = {
  'フォーム reads as a form to fill in; 緩衝材, but in names of chemistry': /(?<!ポリエチレン)フォーム/g,
  '部分; 部品': /部分/g,
  '壁厚, which is that of a wall; リブの厚さ': /壁厚/g,
  '写し; コピー': /(?<!を|に)写し/g,
  '既知の or 知られているケース; 登録済みのケース': /(既知の|知られている)ケース/g,
};

test('one thing has one word', () => {
  expect(all.length).toBeGreaterThan(60);
  const found = Object.entries(NEVER).flatMap(([why, word]) => all.flatMap(([name, text]) => [...text.matchAll(word)].map(() => `${name}: ${why}`)));
  expect(found).toEqual([]);
});

test('すきま is a gap, never a clearance', () => {
  const pair = /(['"])((?:(?!\1)[^\\\n]|\\.)*)\1,\s*(['"])((?:(?!\3)[^\\\n]|\\.)*)\3/g;
  const clearances = all.flatMap(([name, text]) => [...text.matchAll(pair)].filter(([, , en]) => /clearance/i.test(en!)).map(([, , , , ja]) => `${name}: ${ja}`));
  expect(clearances.length).toBeGreaterThan(10);
  expect(clearances.filter((text) => /すきま/.test(text))).toEqual([]);
});

import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {beforeAll, expect, test, vi} from 'vitest';
import type {Schema} from '../../src/design/options';
import {setBy} from '../../src/design/panel_fields';
import {fieldWords} from '../../src/panels/field_words';
import {places} from '../../src/panels/find_fields';
import {flagNames} from '../../src/panels/flag_names';
import {withFieldNames} from '../../src/words/flags';
import {en, ja, type Texts} from '../../src/words/texts';
import {startCore} from '../support/snug';

const CATALOGUE = fileURLToPath(new URL('../../../snug/words', import.meta.url));
let rows: Schema;
beforeAll(async () => {
  vi.stubGlobal('navigator', {language: 'en'});
  rows = await (await startCore()).options();
});

const said = (sentence: string, text: Texts) => withFieldNames(sentence, flagNames(rows, text), text.fieldsOf.quoted);

test('the flag of every option that has a field is called as the field, in both languages', () => {
  const own = places(rows).flatMap(({field}) => setBy(field).map((path) => ({field, flag: rows[path].flag})));
  const flags = own.map(({flag}) => flag).filter((flag, i, all) => flag && all.indexOf(flag) === i);
  expect(flags.length).toBeGreaterThan(40);
  for (const text of [en, ja])
    for (const flag of flags) {
      const names = own.filter((one) => one.flag === flag).map(({field}) => fieldWords(field, text, rows).name);
      const groups = [text.fit.pads, text.fit.relief, text.fit.notches, text.fit.lift];
      expect([...names, ...groups].map(text.fieldsOf.quoted), flag).toContain(said(flag!, text));
    }
});

test('advice on walls reads as of the page, with its numbers', () => {
  expect(said('only 18 mm of foam at the left (-z); 25 mm is the least that cushions, 50 mm is usual: --wall 25 would do', en)).toBe(
    'only 18 mm of foam at the left (-z); 25 mm is the least that cushions, 50 mm is usual: “Wall” 25 would do',
  );
  expect(said('左（-z）の緩衝材は 18 mm しかありません。--wall 25 とすれば足ります。', ja)).toBe('左（-z）の緩衝材は 18 mm しかありません。「壁の厚さ」25 とすれば足ります。');
  expect(said('--move 0,-10,2.5 would do', en)).toBe('“Shift” 0, -10, 2.5 would do');
  expect(said('--blocks 32x18x20 would do', en)).toBe('“Blocks” 32 × 18 × 20 would do');
  expect(said('fill it with --settle, --pads 2', en)).toBe('fill it with “Lower it until it lies on foam”, “Pads in what block steps leave” 2');
});

test('a choice is called by its name on the page', () => {
  expect(said('--blocks auto adds walls', en)).toBe('“Fit the space to the object” adds walls');
  expect(said('take plates (--brick-unit plate) or more walls', en)).toBe('take plates (“Layers of: plates”) or more walls');
  expect(said('--for sheets/mill を選んでください', ja)).toBe('「作り方：シートを切って貼る」/「作り方：CNC切削」を選んでください');
});

test('a list that the page has itself is not told of, a command to be typed stays', () => {
  expect(said('name it by --foam (`snug foams` lists those with data)', en)).toBe('name it by “Foam material”');
  expect(said('--foam で指定してください（`snug foams` で一覧を示します）', ja)).toBe('「緩衝材の材料」で指定してください');
  expect(said('8 mm inside; `snug cases --for` lists those that fit, in every way', en)).toBe('8 mm inside');
  expect(said('the command line has no such limit: snug make vase.stl --wall=40', en)).toContain(': snug make vase.stl --wall=40');
  expect(said('`snug make --for bricks` on a computer has one', en)).toBe('`snug make --for bricks` on a computer has one');
});

/** What only commands say: usage, help, files, reading in pieces. */
const OF_COMMANDS = /^(usage|help|files|lists|options|ply|folder)\.cpp$/;
const FLAGS_OF_COMMANDS = /--(no-stream|known-case|object|csv)\b/;

test('no sentence that the page may show has a flag left', () => {
  const files = readdirSync(CATALOGUE).filter((name) => name.endsWith('.cpp') && !OF_COMMANDS.test(name));
  // In C++ a sentence goes on in the next string.
  const sentences = files.flatMap((name) => [...readFileSync(join(CATALOGUE, name), 'utf8').replace(/"\s*\n\s*"/g, '').matchAll(/"((?:[^"\\]|\\.)*--[a-z](?:[^"\\]|\\.)*)"/g)].map(([, sentence]) => sentence!));
  expect(sentences.length).toBeGreaterThan(60);
  const left = sentences.map((sentence) => said(sentence, /[ぁ-ん]/.test(sentence) ? ja : en)).filter((sentence) => /--[a-z]/.test(sentence.replace(/`[^`]*`/g, '')) && !FLAGS_OF_COMMANDS.test(sentence));
  expect(left).toEqual([]);
});

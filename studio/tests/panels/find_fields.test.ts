import {beforeAll, expect, test, vi} from 'vitest';
import type {Schema} from '../../src/design/options';
import {en, ja} from '../../src/words/texts';
import {fieldWords} from '../../src/panels/field_words';
import {fieldIndex, findFields} from '../../src/panels/find_fields';
import {startCore} from '../support/snug';

let rows: Schema;
let index: ReturnType<typeof fieldIndex>;
beforeAll(async () => {
  vi.stubGlobal('navigator', {language: 'en'});
  rows = await (await startCore()).options();
  index = fieldIndex(rows, [en, ja]);
});

const first = (typed: string) => findFields(index, typed)[0]?.field;
const all = (typed: string) => findFields(index, typed, 99).map(({field}) => field);

test('a field is found by a word of its name, of what is said of it, or by its flag, in either language', () => {
  expect(first('rib')).toBe('fit.least_rib_mm');
  expect(first('liner')).toBe('cut.liner_mm');
  expect(first('KERF')).toBe('workshop.sheets.kerf_mm');
  expect(first('リブ')).toBe('fit.least_rib_mm');
  expect(first('内張り')).toBe('cut.liner_mm');
  expect(first('切り幅')).toBe('workshop.sheets.kerf_mm');
  expect(first('wall')).toBe('space.wall_mm');
  expect(all('--least-rib')).toContain('fit.least_rib_mm');
  expect(all('cloth')).toContain('cut.liner_mm');
  expect(all('quarter turn')).toContain('quarters');
  expect(all('no such word')).toEqual([]);
  expect(all('  ')).toEqual([]);
});

test('a field of a way of working, or inside another one, says so', () => {
  expect(findFields(index, 'kerf')[0]).toMatchObject({step: 'make', panel: 'workshop', ways: ['sheets']});
  expect(findFields(index, 'bed')[0]).toMatchObject({field: 'workshop.print.bed_mm', ways: ['print', 'mould']});
  expect(findFields(index, 'corner radius')[0]).toMatchObject({within: 'case.inside_mm', step: 'foam', ways: null});
});

test('every field has a name in both languages, and is found by it', () => {
  for (const {place} of index)
    for (const text of [en, ja]) {
      const {name} = fieldWords(place.field, text, rows);
      expect(name, place.field).not.toBe(place.field);
      expect(all(name), name).toContain(place.field);
    }
});

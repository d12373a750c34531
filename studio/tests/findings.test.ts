import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {expect, test} from 'vitest';
import type {Finding} from '../src/engine/api';
import {en} from '../src/i18n/en';
import {ja} from '../src/i18n/ja';
import {counted, findingTitle, titles, worst} from '../src/steps/findings';

const LIBRARY = fileURLToPath(new URL('../../snug/check/', import.meta.url));
const finding = (severity: Finding['severity'], code: string): Finding => ({severity, code, message: '', where: null});

test('people are never shown a code', () => {
  for (const {check} of [en, ja]) {
    expect(findingTitle(finding('danger', 'no_lower'), check)).toBe(`${check.severities.danger}: ${check.codes.no_lower}`);
    expect(findingTitle(finding('warning', 'of_a_later_version'), check)).toBe(check.severities.warning);
  }
});

test('what may be wrong with the foams has a name in each language', () => {
  const texts = readdirSync(LIBRARY)
    .filter((name) => /problems\.cpp$/.test(name))
    .map((name) => readFileSync(join(LIBRARY, name), 'utf8'));
  const codes = new Set(texts.flatMap((text) => [...text.matchAll(/"([a-z]+_[a-z_]+)"/g)].map(([, code]) => code!)));
  expect(codes.size).toBeGreaterThan(8);
  for (const code of codes) for (const {check} of [en, ja]) expect(check.codes[code], code).toBeTruthy();
  expect(Object.keys(ja.check.codes).sort()).toEqual(Object.keys(en.check.codes).sort());
});

test('dangers and warnings are counted, the gravest is named, notes are neither', () => {
  const some = [finding('danger', 'a'), finding('warning', 'b'), finding('warning', 'c'), finding('note', 'd')];
  expect(counted(some, en.check)).toBe('1 danger, 2 warnings');
  expect(worst(some)).toBe('danger');
  expect(worst(some.slice(1))).toBe('warning');
  expect(worst(some.slice(3))).toBeNull();
  expect(counted(some.slice(3), en.check)).toBe('');
});

test('what is found on several sides is named once', () => {
  const some = [finding('danger', 'touches_case'), finding('warning', 'parts'), finding('danger', 'touches_case')];
  expect(titles(some, en.check)).toEqual(['Danger: Touches the case (2)', 'Warning: Several parts']);
});

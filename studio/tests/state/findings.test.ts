import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {expect, test} from 'vitest';
import type {Finding} from '../../src/engine/api';
import {counted, findingTitle, gravestFirst, titles, worst} from '../../src/state/findings';
import {en, ja} from '../../src/words/texts';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));
const finding = (severity: Finding['severity'], code: string): Finding => ({severity, code, message: '', where: null});

test('people are never shown a code', () => {
  for (const {check} of [en, ja]) {
    expect(findingTitle(finding('danger', 'no_lower'), check)).toBe(`${check.severities.danger}: ${check.codes.no_lower}`);
    expect(findingTitle(finding('warning', 'of_a_later_version'), check)).toBe(check.severities.warning);
  }
});

/** Every code in the library's sources: what follows a severity, and in files about nothing else any such word. */
function codesOf(path: string, text: string): string[] {
  const after = [...text.matchAll(/(?:Severity::\w+|[sS]everity\([^;{}]*?\)),\s*"([a-z]+(?:[_-][a-z]+)*)"/g)];
  const warned = [...text.matchAll(/\bwarn\("([a-z_-]+)"/g)];
  const about = /(problems|findings)\.cpp$/.test(path) ? [...text.matchAll(/"([a-z]+(?:[_-][a-z]+)+)"/g)] : [];
  return [...after, ...warned, ...about].map(([, code]) => code!);
}

test('what the library may find has a name in each language, wherever in it that is', () => {
  const codes = new Set(
    ['snug', 'cli'].flatMap((folder) =>
      readdirSync(join(ROOT, folder), {recursive: true, encoding: 'utf8'})
        .filter((name) => name.endsWith('.cpp'))
        .flatMap((name) => codesOf(name, readFileSync(join(ROOT, folder, name), 'utf8'))),
    ),
  );
  expect(codes.size).toBeGreaterThan(50);
  for (const known of ['no_lower', 'creep', 'left_out', 'no_end', 'sheets-lost', 'trim', 'rigid']) expect(codes).toContain(known);
  for (const {check} of [en, ja]) expect([...codes].filter((code) => !check.codes[code])).toEqual([]);
  expect(Object.keys(ja.check.codes).sort()).toEqual(Object.keys(en.check.codes).sort());
  // And no name is of something that is no longer found.
  expect(Object.keys(en.check.codes).filter((code) => !codes.has(code))).toEqual([]);
});

test('dangers and warnings are counted, the gravest is named, notes are neither', () => {
  const some = [finding('danger', 'a'), finding('warning', 'b'), finding('warning', 'c'), finding('note', 'd')];
  expect(counted(some, en.check)).toBe('1 danger, 2 warnings');
  expect(worst(some)).toBe('danger');
  expect(worst(some.slice(1))).toBe('warning');
  expect(worst(some.slice(3))).toBeNull();
  expect(counted(some.slice(3), en.check)).toBe('');
});

test('what comes from several places has the gravest first, and is in its order otherwise', () => {
  const some = [finding('warning', 'a'), finding('note', 'b'), finding('danger', 'c'), finding('warning', 'd')];
  expect(gravestFirst(some).map(({code}) => code)).toEqual(['c', 'a', 'd', 'b']);
});

test('what is found on several sides is named once', () => {
  const some = [finding('danger', 'touches_case'), finding('warning', 'parts'), finding('danger', 'touches_case')];
  expect(titles(some, en.check)).toEqual(['Danger: Touches the case (2)', 'Warning: Several parts']);
});

import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {expect, test} from 'vitest';
import type {Finding} from '../../src/engine/api';
import {counted, findingTitle, gravestFirst, titles, worst} from '../../src/state/findings';
import {en, ja} from '../../src/words/texts';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));
const finding = (severity: Finding['severity'], code: string): Finding => ({severity, code, message: ['', ''], where: null});

test('people are never shown a code', () => {
  for (const {check} of [en, ja]) {
    expect(findingTitle(finding('danger', 'no_lower'), check)).toMatch(new RegExp(`^${check.severities.danger}[:：] ?${check.codes.no_lower}$`));
    expect(findingTitle(finding('warning', 'of_a_later_version'), check)).toBe(check.severities.warning);
  }
});

/** What stands without a dot in the catalogue and is no finding: pieces of other sentences. */
const PIECES = ['and_more', 'at_line', 'at_part', 'at_place', 'cancelled', 'foam', 'foreign', 'in_both', 'in_file', 'names_and_more', 'of_earlier', 'preset', 'takes', 'with_clearance'];

/** The codes of the catalogue's rows that are findings; what follows a slash tells wordings of one code apart. */
function codesOf(text: string): string[] {
  return [...text.matchAll(/^ {4}\{"([a-z_-]+)(?:\/[a-z_/-]+)?"/gm)].map(([, code]) => code!).filter((code) => !PIECES.includes(code));
}

test('what the library may find has a name in each language, wherever in it that is', () => {
  const catalogue = join(ROOT, 'snug/words');
  const codes = new Set(
    readdirSync(catalogue)
      .filter((name) => name.endsWith('.cpp'))
      .flatMap((name) => codesOf(readFileSync(join(catalogue, name), 'utf8'))),
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

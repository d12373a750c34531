import {readdirSync, readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {expect, test} from 'vitest';
import * as figures from '../../src/words/figures';

const SRC = fileURLToPath(new URL('../../src/', import.meta.url));
const sources = readdirSync(SRC, {recursive: true, encoding: 'utf8'})
  .filter((name) => /\.(ts|svelte)$/.test(name) && name !== 'words/figures.ts')
  .map((name) => [name, readFileSync(SRC + name, 'utf8').replace(/\/\*[\s\S]*?\*\/|\/\/ .*/g, '')] as const);

test('figures have one style', () => {
  expect(figures.mm(18.441)).toBe('18.4 mm');
  expect(figures.mm(1234.5)).toBe('1235 mm');
  expect(figures.size([1200, 87.12, 7.5])).toBe('1200 × 87.1 × 7.5 mm');
  expect(figures.litres(20_731_000)).toBe('20.7 L');
  expect(figures.litres(1_234_567_890)).toBe('1,234.6 L');
  expect(figures.count(9954)).toBe('9,954');
  expect(figures.cm3(12_345_678)).toBe('12,346 cm³');
  expect(figures.kg(0.4)).toBe('0.4 kg');
  expect(figures.force(1240)).toBe('1.24 kN');
  expect(figures.percent(0.00001)).toBe('< 0.01 %');
});

test('sentences of the library follow it, and what is typed stays as it is', () => {
  expect(figures.ofLibrary('4 of 6 x 30 mm, 12.5 x 3 x 2 mm, 3 cm3 on 2 cm2')).toBe('4 of 6 × 30 mm, 12.5 × 3 × 2 mm, 3 cm³ on 2 cm²');
  expect(figures.ofLibrary('--bed 250x210x210 max 3')).toBe('--bed 250x210x210 max 3');
});

/** What is written for programs: a shader, SVG and CSS, a number that is reckoned on with, and dates. */
const FOR_PROGRAMS = ['design/rotation.ts', 'design/shape.ts', 'panels/FoamStep.svelte', 'panels/WaitingWorks.svelte', 'panels/drops/ForceCurve.svelte', 'panels/drops/SideDrops.svelte', 'view3d/ramp.ts'];

test('nothing else on the page writes figures', () => {
  const writing = sources.filter(([, text]) => /\.toFixed\(|\.toPrecision\(|\.toLocaleString\(|Intl\.NumberFormat/.test(text)).map(([name]) => name);
  expect(writing.sort()).toEqual(FOR_PROGRAMS);
});

test('a figure brings its unit: no sentence or panel writes one behind a value, or x for ×', () => {
  const UNIT = /\} (mm|cm|m|l|L|lit(re|er)s|リットル|kg|g|G|N|kN|kPa|ms|cm[23²³]|%)(?![\p{L}\p{N}])/gu;
  // The name of a field may have the unit that stands in the field.
  const unnamed = (text: string) => text.replace(/numberLabel="[^"]*"/g, '');
  const found = sources.flatMap(([name, text]) => [...unnamed(text).matchAll(UNIT), ...text.matchAll(/['`>][^'`\n]*\d x \d/g)].map(([what]) => `${name}: ${what}`));
  expect(found).toEqual([]);
});

import {beforeAll, expect, test} from 'vitest';
import type {Design} from '../../src/design/design';
import {fieldsIn, heldBy, isOption, PANELS, setBy, waysOf, type FieldName, type PanelName} from '../../src/design/panel_fields';
import type {OptionPath, Schema} from '../../src/design/options';
import {startCore} from '../support/snug';

let rows: Schema;
beforeAll(async () => {
  rows = await (await startCore()).options();
});

const panels = Object.keys(PANELS) as PanelName[];
const allOf = (panel: PanelName): readonly FieldName[] => {
  const {usual, more} = fieldsIn(panel, rows);
  return [...usual, ...more];
};

test('a field stands in one panel, once, and what it sets is in the table of options', () => {
  const all = panels.flatMap((panel) => allOf(panel).flatMap((name) => [name, ...heldBy(name)]));
  expect(all.filter((name, i) => all.indexOf(name) !== i)).toEqual([]);
  for (const path of [...all.filter(isOption), ...all.flatMap((name) => setBy(name))]) expect(rows[path], path).toBeDefined();
});

test('a panel has few usual fields, whatever way of working is chosen', () => {
  const ways = rows['workshop.for'].words ?? [];
  for (const panel of panels)
    for (const way of [null, ...ways]) {
      const shown = PANELS[panel].usual.filter((name) => {
        const of = waysOf(name, ways);
        return of === null || of.includes(way ?? '');
      });
      expect(shown.length, `${panel} ${way}`).toBeLessThanOrEqual(4);
    }
});

test('a way of working that nobody sorted has all its options behind More', () => {
  expect(allOf('workshop')).toEqual(expect.arrayContaining(['workshop.mould.wall_mm', 'workshop.mould.rim_mm', 'workshop.mould.draft_deg']));
});

test('what is not in a panel is known: the command line alone has it, or another part of the page', () => {
  const there = new Set(panels.flatMap((panel) => allOf(panel).flatMap((name) => [name, ...setBy(name), ...heldBy(name)])));
  const left = (Object.keys(rows) as OptionPath[]).filter((path) => !there.has(path) && !/^(items|edits|protection\.foam\..*|items\.0\.(object|rotation_deg|offset_mm|centre_mm|zones))$/.test(path));
  const known: (keyof Design)[] = ['object', 'space', 'fit', 'output', 'case', 'protection', 'search', 'workshop'];
  expect([...new Set(left.map((path) => path.split('.')[0]))].sort()).toEqual([...known].sort());
  // Those that people set every day are not among them.
  for (const path of ['space.wall_mm', 'cut.liner_mm', 'fit.least_rib_mm', 'workshop.sheets.kerf_mm', 'search.weights'] as const) expect(left).not.toContain(path);
});

import {beforeEach, expect, test, vi} from 'vitest';
import {withOffset, withUnits} from '../../src/design/edit';
import {duplicated, withoutItem} from '../../src/design/moment';
import type {Studio} from '../../src/state/studio.svelte';
import {ALL} from '../../src/words/texts';
import {box} from '../support/shapes';
import {startStudio} from '../support/studio';

let studio: Studio;
let openFiles: (studio: Studio, files: readonly File[], how?: {joins?: boolean}) => Promise<boolean>;
const body = () => new File([box([120, 80, 60])], 'body.stl');
const lens = () => new File([box([50, 40, 60])], 'lens.stl');
const cap = () => new File([box([40, 40, 10])], 'cap.stl');

beforeEach(async () => {
  studio = await startStudio();
  ({openFiles} = await import('../../src/import/open_files'));
});

const names = () => studio.packing?.items.map(({name}) => name);
const packed = async () => {
  const before = studio.packing;
  await vi.waitFor(() => expect(studio.packing).not.toBe(before));
};
const projectText = () => studio.engine.projectText(studio.moment.design, studio.moment.objects);

test('several files that are opened at once lie beside each other', async () => {
  await openFiles(studio, [body(), lens()]);
  expect(names()).toEqual(['body.stl', 'lens.stl']);
  expect(studio.placed.length).toBe(2);
  expect(studio.findings.filter(({severity}) => severity === 'danger')).toEqual([]);
  const line = await studio.engine.commandLine(studio.commanded!.files, studio.commanded!.design, 'en', studio.commanded!.objects);
  expect(line).toBe('snug make body.stl lens.stl --blocks=auto --no-arrange -o body-foam');
});

test('a file that joins is selected, and one that is opened takes the place of all', async () => {
  await openFiles(studio, [body()], {joins: true});
  await openFiles(studio, [lens(), cap()], {joins: true});
  expect(names()).toEqual(['body.stl', 'lens.stl', 'cap.stl']);
  expect([studio.selected, studio.object?.file.name]).toEqual([1, 'lens.stl']);
  await openFiles(studio, [cap()]);
  expect(names()).toEqual(['cap.stl']);
  await studio.undo();
  expect(names()).toEqual(['body.stl', 'lens.stl', 'cap.stl']);
  await studio.undo();
  expect(names()).toEqual(['body.stl']);
  expect(studio.object?.size_mm).toEqual([120, 80, 60]);
  await studio.redo();
  expect(names()).toEqual(['body.stl', 'lens.stl', 'cap.stl']);
});

test('moving the selected item moves no other', async () => {
  await openFiles(studio, [body(), lens()]);
  studio.select(1);
  const apart = () => studio.packing!.items[1]!.bounds.min[2] - studio.packing!.items[0]!.bounds.max[2];
  const before = apart();
  const [x, y, z] = studio.design.placement.offset_mm;
  studio.change((design) => withOffset(design, [x, y + 5, z + 40]), 'handles');
  await packed();
  expect(apart()).toBeCloseTo(before + 40, 9);
  expect(studio.packing!.items[1]!.offset_mm[1] - studio.packing!.items[0]!.offset_mm[1]).toBeCloseTo(5, 9);
  expect(studio.canUndo).toBe(true);
  await studio.undo();
  expect(apart()).toBeCloseTo(before, 9);
});

test('one more of the same is an item, not a file; and the last two leave one', async () => {
  await openFiles(studio, [body(), lens()]);
  studio.becomes(duplicated(studio.moment, 1, studio.defaults, studio.lying), '');
  await packed();
  expect(names()).toEqual(['body.stl', 'lens.stl (2)', 'lens.stl (3)']);
  expect(studio.objects.length).toBe(2);
  studio.becomes(withoutItem(studio.moment, 0), '');
  await packed();
  expect(names()).toEqual(['lens.stl (1)', 'lens.stl (2)']);
  expect(studio.placed.map(({meshes}) => meshes)).toEqual([studio.meshes, studio.meshes]);
  studio.becomes(withoutItem(studio.moment, 0), '');
  await packed();
  expect(names()).toEqual(['lens.stl']);
  await studio.undo();
  await studio.undo();
  expect(names()).toEqual(['body.stl', 'lens.stl (2)', 'lens.stl (3)']);
});

test('a project of several opens with its files in any order, and gives the same text', async () => {
  await openFiles(studio, [body(), lens()]);
  studio.select(1);
  studio.change((design) => withUnits(design, 'cm'), 'units');
  await packed();
  studio.change((design) => withOffset(design, [0, 10, 400]), 'handles');
  await packed();
  const text = await projectText();
  const {pieces} = studio.packing!;
  const project = () => new File([text], 'kit.snug.json');
  for (const files of [[project(), lens(), body()], [project()], [lens(), body(), project()]]) {
    const other = await startStudio();
    await openFiles(other, files);
    if (files.length === 1) {
      expect(other.notice).toEqual(ALL.files.openObjectOf('body.stl, lens.stl'));
      await openFiles(other, [lens()]);
      expect(other.notice).toEqual(ALL.files.openObjectOf('body.stl'));
      await openFiles(other, [body()]);
    }
    expect(other.notice).toBeNull();
    expect(other.problem).toBeNull();
    expect(await other.engine.projectText(other.moment.design, other.moment.objects)).toBe(text);
    expect(other.packing?.pieces).toEqual(pieces);
  }
  // Where they lie there already it needs no files.
  studio.change((design) => withOffset(design, [0, 0, 500]), 'handles');
  await packed();
  await openFiles(studio, [project()]);
  await vi.waitFor(async () => expect(await projectText()).toBe(text));
});

test('two files of one name are told apart by their content', async () => {
  const [large, small] = [new File([box([120, 80, 60])], 'part.stl'), new File([box([50, 40, 60])], 'part.stl')];
  await openFiles(studio, [large]);
  await openFiles(studio, [small], {joins: true});
  const project = new File([await projectText()], 'kit.snug.json');
  const other = await startStudio();
  await openFiles(other, [small, project, large]);
  expect(other.notice).toBeNull();
  expect(other.objects.map(({size_mm}) => size_mm?.[0])).toEqual([120, 50]);
});

test('a file among several that cannot be read leaves everything as it was, and is named', async () => {
  await openFiles(studio, [body()]);
  const before = studio.packing;
  await openFiles(studio, [lens(), new File(['no mesh'], 'notes.stl')], {joins: true});
  expect(studio.problem?.text[0]).toContain('notes.stl');
  expect(names()).toEqual(['body.stl']);
  expect(studio.packing?.pieces).toEqual(before?.pieces);
  studio.change((design) => withOffset(design, [0, 0, 0]), '');
  await openFiles(studio, [lens()], {joins: true});
  expect(names()).toEqual(['body.stl', 'lens.stl']);
});

test('one whose unit is not known asks for it, and the foams wait', async () => {
  await openFiles(studio, [body()]);
  await openFiles(studio, [lens(), new File([box([0.4, 0.3, 0.2])], 'tiny.stl')], {joins: true});
  expect(studio.problem).toBeNull();
  expect([studio.asksForUnit, studio.object?.file.name, studio.packing]).toEqual([true, 'tiny.stl', null]);
  studio.change((design) => withUnits(design, 'm'), 'units');
  await vi.waitFor(() => expect(names()).toEqual(['body.stl', 'lens.stl', 'tiny.stl']));
  expect(studio.moment.objects.map(({own}) => own?.units ?? null)).toEqual([null, null, 'm']);
});

import {expect, test} from 'vitest';
import type {Finding, Packing} from '../../src/engine/api';
import {thinnestWall, verdictOf} from '../../src/state/verdict';
import {en, ja} from '../../src/words/texts';

const finding = (severity: Finding['severity'], code: string): Finding => ({severity, code, message: ['', ''], where: null});
const packing = (wall_mm: number[], open = false) => ({fit: {wall_mm}, open}) as unknown as Packing;
const WALLS = packing([50, 42.5, 10, 50, 50, 50]);

test('foam that holds says so, with where it is thinnest', () => {
  expect(verdictOf(WALLS, [finding('note', 'rigid')], false, en)).toEqual({look: 'good', text: 'Fits: thinnest foam 10 mm at the back'});
});

test('what fits is not said to be safe where nothing is known of drops', () => {
  expect(verdictOf(WALLS, [], true, en).text).toBe('Fits: thinnest foam 10 mm at the back; drops not estimated');
  expect(verdictOf(WALLS, [], true, ja).text).toContain('計算なし');
  expect(verdictOf(WALLS, [finding('danger', 'items_near')], true, en).text).toBe(en.check.codes.items_near);
});

test('thin foam is named with its place, as grave as the gravest finding', () => {
  const some = [finding('warning', 'thin_wall'), finding('warning', 'parts')];
  expect(verdictOf(WALLS, some, false, en)).toEqual({look: 'warning', text: 'Thinnest foam 10 mm at the back: too thin'});
  expect(verdictOf(packing([0, 50, 50, 50, 50, 50]), [finding('danger', 'no_floor'), ...some], false, en)).toEqual({
    look: 'danger',
    text: 'Thinnest foam 0 mm below: too thin',
  });
  expect(verdictOf(WALLS, some, false, ja).text).toBe('緩衝材が薄すぎます：奥で 10 mm');
});

test('what else is grave is named, the gravest first', () => {
  const some = [finding('warning', 'thin_wall'), finding('danger', 'items_near')];
  expect(verdictOf(WALLS, some, false, en)).toEqual({look: 'danger', text: en.check.codes.items_near});
  expect(verdictOf(WALLS, [finding('warning', 'mixed_up')], false, en)).toEqual({look: 'warning', text: 'Fits, but read: Items easily mixed up'});
  // A newer library may know more: never its code.
  expect(verdictOf(WALLS, [finding('danger', 'of_a_later_version')], false, en).text).toBe('Danger');
});

test('without foams it does not fit, and a tray has no wall above', () => {
  expect(verdictOf({...WALLS, fit: null}, [], false, en)).toEqual({look: 'danger', text: en.status.noFoam});
  expect(thinnestWall(packing([50, 1, 40, 50, 50, 50], true))).toEqual({wall_mm: 40, side: 2});
});

import {expect, test} from 'vitest';
import {placeTip, type Box} from '../../src/ui/place_tip';

const PAGE = {width: 1280, height: 800};
const TIP = {width: 250, height: 60};
const control: Box = {left: 14, top: 600, right: 330, bottom: 630};
const at = ({left, top}: {left: number; top: number}, tip = TIP): Box => ({left, top, right: left + tip.width, bottom: top + tip.height});
const meet = (a: Box, b: Box) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

test('a tip stands beside its column, where no field is', () => {
  const left = {left: 0, top: 48, right: 344, bottom: 760};
  expect(meet(at(placeTip(control, left, TIP, PAGE)), left)).toBe(false);
  const right = {left: 912, top: 48, right: 1280, bottom: 760};
  const slice = {left: 925, top: 720, right: 1266, bottom: 750};
  const tip = at(placeTip(slice, right, TIP, PAGE));
  expect(meet(tip, right)).toBe(false);
  expect(tip.bottom).toBeLessThanOrEqual(PAGE.height);
});

test('where a column is as wide as the page it stands above its control, below only at the top', () => {
  const page = {width: 390, height: 844};
  const column = {left: 0, top: 0, right: 390, bottom: 844};
  expect(at(placeTip(control, column, TIP, page)).bottom).toBeLessThan(control.top);
  const first = {...control, top: 20, bottom: 50};
  expect(placeTip(first, column, TIP, page).top).toBeGreaterThan(first.bottom);
});

test('it never leaves the page, nor covers its control', () => {
  for (const left of [0, 200, 380])
    for (const top of [0, 30, 400, 820]) {
      const box = {left, top, right: left + 10, bottom: top + 20};
      const tip = at(placeTip(box, null, TIP, {width: 390, height: 844}));
      expect(tip.left).toBeGreaterThanOrEqual(0);
      expect(tip.right).toBeLessThanOrEqual(390);
      expect(meet(tip, box)).toBe(false);
    }
});

import {beforeAll, expect, test} from 'vitest';
import type {Design, Triple} from '../../src/design/design';
import {withOffset, withRotation, withUnits, withWalls} from '../../src/design/edit';
import {
  beforeCentring,
  centring,
  duplicated,
  focused,
  momentOf,
  unfocused,
  withJoined,
  withLock,
  withoutItem,
  type Moment,
} from '../../src/design/moment';
import type {Lying} from '../../src/design/layers';
import {startCore} from '../support/snug';

let defaults: Design;
beforeAll(async () => void (defaults = await (await startCore()).defaultDesign()));

const SIZE: Triple = [40, 40, 40];
/** Boxes with these middles. */
const at = (...middles: Triple[]): Lying[] =>
  middles.map((offset_mm) => ({
    offset_mm,
    bounds: {min: offset_mm.map((mm) => mm - 20) as Triple, max: offset_mm.map((mm) => mm + 20) as Triple},
  }));

const one = (design: Design = defaults) => momentOf(design, 'a');
const join = (moment: Moment, ids: string[], lying: readonly Lying[] = []) =>
  withJoined(moment, ids.map((id) => ({id, size_mm: SIZE})), defaults, lying);
const row = () => join(one(), ['b', 'c']);
const ROW = () => at([0, 0, -70], [0, 0, 0], [0, 0, 70]);

test('of one item everything stands in the design', () => {
  const moment = one();
  expect(focused(moment, 0, [])).toBe(moment.design);
  const next = withRotation(moment.design, [0, 90, 0]);
  expect(unfocused(moment, 0, next, [])).toEqual({...moment, design: next});
});

test('what was chosen for one alone stays its own when another joins, which begins afresh', () => {
  const chosen = withUnits(withRotation({...defaults, workshop: {...defaults.workshop, mass_kg: 2}}, [0, 90, 0]), 'in');
  const {design, objects} = join(one(chosen), ['b']);
  expect(objects).toEqual([{id: 'a', own: chosen.object}, {id: 'b', own: null}]);
  expect(design.items).toMatchObject([
    {object: 0, rotation_deg: [0, 90, 0], offset_mm: null, mass_kg: 2},
    {object: 1, rotation_deg: null, offset_mm: null, mass_kg: null},
  ]);
  expect([design.object, design.placement, design.workshop.mass_kg]).toEqual([defaults.object, defaults.placement, null]);
});

test('and becomes the design’s again when it is left alone', () => {
  const chosen = withUnits(withRotation({...defaults, workshop: {...defaults.workshop, mass_kg: 2}}, [0, 90, 0]), 'in');
  expect(withoutItem(join(one(chosen), ['b']), 1)).toEqual(one(chosen));
});

test('a centre of mass belongs to its item alone', () => {
  const chosen = {...defaults, protection: {...defaults.protection, centre_mm: [1, 2, 3] as Triple}};
  const {design} = join(one(chosen), ['b']);
  expect(design.items.map(({centre_mm}) => centre_mm)).toEqual([[1, 2, 3], null]);
  expect(design.protection.centre_mm).toBeNull();
  expect(withoutItem(join(one(chosen), ['b']), 1)).toEqual(one(chosen));
});

test('a layer whose last item is taken out closes up, and levels that were chosen for it are chosen anew', () => {
  const {design, ...rest} = row();
  const items = design.items.map((item, i) => ({...item, layer: i + 1}));
  const three: Moment = {...rest, design: {...design, items, parting: {level: [3, 6, 9]}}};
  const two = withoutItem(three, 1).design;
  expect([two.items.map(({layer}) => layer), two.parting.level]).toEqual([[1, 2], 'auto']);
  const {design: same} = withoutItem({...three, design: {...three.design, items: items.map((item, i) => ({...item, layer: [1, 2, 2][i]!})), parting: {level: [3, 6]}}}, 1);
  expect([same.items.map(({layer}) => layer), same.parting.level]).toEqual([[1, 2], [3, 6]]);
});

test('a change of the selected item leaves the others where they lie', () => {
  const moment = row();
  expect(focused(moment, 2, ROW()).placement.offset_mm).toEqual([0, 0, 70]);
  const moved = unfocused(moment, 2, withOffset(focused(moment, 2, ROW()), [0, 10, 80]), ROW());
  expect(moved.design.items.map(({offset_mm}) => offset_mm)).toEqual([[0, 0, -70], [0, 0, 0], [0, 10, 80]]);
  const turned = unfocused(moment, 1, withRotation(focused(moment, 1, ROW()), [90, 0, 0]), ROW());
  expect(turned.design.items.map(({rotation_deg, offset_mm}) => [rotation_deg, offset_mm])).toEqual([[null, null], [[90, 0, 0], null], [null, null]]);
  expect(turned.design.placement).toEqual(defaults.placement);
});

test('in a space that follows its items offsets stay as they were chosen, however all are shifted', () => {
  const moved = unfocused(row(), 2, withOffset(focused(row(), 2, ROW()), [0, 0, 100]), ROW());
  // The library centred all of it: everything lies 15 mm further left.
  const came = at([0, 0, -85], [0, 0, -15], [0, 0, 85]);
  expect(centring(moved, came)).toEqual([0, 0, -15]);
  const centred = beforeCentring(came, centring(moved, came));
  expect(focused(moved, 2, centred).placement.offset_mm).toEqual([0, 0, 100]);
  const again = unfocused(moved, 2, withOffset(focused(moved, 2, centred), [0, 0, 101]), centred);
  expect(again.design.items.map(({offset_mm}) => offset_mm?.[2])).toEqual([-70, 0, 101]);
});

test('a unit is the object’s own, and what holds for all is everybody’s', () => {
  const moment = row();
  const inches = unfocused(moment, 1, withUnits(focused(moment, 1, ROW()), 'in'), ROW());
  expect(inches.objects.map(({own}) => own?.units ?? null)).toEqual([null, 'in', null]);
  expect(inches.design.object).toEqual(defaults.object);
  expect(focused(inches, 1, ROW()).object.units).toBe('in');
  expect(focused(inches, 0, ROW()).object.units).toBeNull();
  const walls = unfocused(moment, 1, withWalls(focused(moment, 1, ROW()), 12), ROW());
  expect(walls).toEqual({...moment, design: withWalls(moment.design, 12)});
});

test('one more stands in the row, or beside all that have a place', () => {
  expect(duplicated(row(), 1, defaults, ROW()).design.items.map(({object, offset_mm}) => [object, offset_mm])).toEqual([[0, null], [1, null], [2, null], [1, null]]);
  const placed = unfocused(row(), 2, withOffset(focused(row(), 2, ROW()), [0, 10, 80]), ROW());
  const lying = at([0, 0, -70], [0, 0, 0], [0, 10, 80]);
  for (const more of [duplicated(placed, 0, defaults, lying), join(placed, ['d'], lying)]) {
    const [x, y, z] = more.design.items[3]!.offset_mm!;
    expect([x, y]).toEqual([0, 0]);
    // There is more room on the left of -90: a block, what is wanted between, and half of its own size.
    expect(z).toBe(-90 - 2 * 22 - 20);
  }
  const both = join(placed, ['d', 'e'], lying).design.items.slice(3).map(({offset_mm}) => offset_mm);
  expect(both).toEqual([[0, 0, -154], [0, 0, 164]]);
});

const locks = (moment: Moment) => moment.design.items.flatMap(({lock}, i) => (lock ? [i] : []));

test('an item that is taken out takes its object along where it was the last of it', () => {
  const twice = withLock(withLock(duplicated(row(), 1, defaults, ROW()), 3, true), 0, true);
  const without = withoutItem(twice, 1);
  expect(without.objects.map(({id}) => id)).toEqual(['a', 'b', 'c']);
  expect(without.design.items.map(({object}) => object)).toEqual([0, 2, 1]);
  expect(locks(without)).toEqual([0, 2]);
  const gone = withoutItem(without, 0);
  expect(gone.objects.map(({id}) => id)).toEqual(['b', 'c']);
  expect(gone.design.items.map(({object}) => object)).toEqual([1, 0]);
  expect(locks(gone)).toEqual([1]);
  expect(withoutItem(one(), 0)).toEqual(one());
});

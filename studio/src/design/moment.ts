import type {Design, Triple} from './design';
import {between, closedUp, layersOf, withFittingParting, type ItemOptions, type Lying} from './layers';

// What lies in the case, as a value, and every change of it. Of one item alone everything stands in the design; several
// have what is their own beside it, and panels show the design as it is for the one that is selected.

/** An object that lies in the case: what it was loaded as, and what was chosen for it alone. */
export interface ObjectUse {
  readonly id: string;
  readonly own: Design['object'] | null;
}

/** What is on the screen: a design, and the objects that its items are of, by their numbers; none while nothing is open. */
export interface Moment {
  readonly design: Design;
  readonly objects: readonly ObjectUse[];
}

const AXES = [0, 1, 2] as const;
const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);
const sum = (a: Triple, b: Triple, times = 1) => AXES.map((axis) => a[axis] + times * b[axis]) as Triple;

export function momentOf(design: Design, id: string | null): Moment {
  return {design, objects: id === null ? [] : [{id, own: null}]};
}

/** Which objects are there, as one text. */
export function idsOf({objects}: Moment): string {
  return objects.map(({id}) => id).join(' ');
}

/** The options of an object, its own or those of all. */
export function optionsOf({design, objects}: Moment, id: string): Design['object'] {
  return objects.find((use) => use.id === id)?.own ?? design.object;
}

/** How far all items came to lie from where a moment has them: a space that follows its items is centred. */
export function centring({design: {items}}: Moment, came: readonly Lying[]): Triple {
  const at = items.findIndex((item, i) => item.offset_mm !== null && came[i]);
  return at < 0 || items.length === 1 ? [0, 0, 0] : sum(came[at]!.offset_mm, items[at]!.offset_mm!, -1);
}

/** As they lie before that. */
export function beforeCentring<T extends Lying>(came: readonly T[], by: Triple): T[] {
  return came.map((one) => ({
    ...one,
    offset_mm: sum(one.offset_mm, by, -1),
    bounds: {min: sum(one.bounds.min, by, -1), max: sum(one.bounds.max, by, -1)},
  }));
}

/** Where an item lies, chosen or not. */
function offsetOf({design: {items, placement}}: Moment, item: number, lying: readonly Lying[]): Triple {
  return items[item]?.offset_mm ?? lying[item]?.offset_mm ?? placement.offset_mm;
}

/** The design as it is for one item: its object's options and its placement in place of those of all. */
export function focused(moment: Moment, item: number, lying: readonly Lying[]): Design {
  const {design, objects} = moment;
  const one = design.items[item];
  if (!one || design.items.length === 1) return design;
  return {
    ...design,
    object: objects[one.object]?.own ?? design.object,
    placement: {rotation_deg: one.rotation_deg ?? design.placement.rotation_deg, offset_mm: offsetOf(moment, item, lying)},
  };
}

/** After a change of the design as it is for one item. Where it moves, the others stay where they lie. */
export function unfocused(moment: Moment, item: number, next: Design, lying: readonly Lying[]): Moment {
  const before = focused(moment, item, lying);
  const {design, objects} = moment;
  const one = design.items[item];
  if (!one || design.items.length === 1) return {...moment, design: next};
  const own = same(next.object, before.object) ? {} : {own: same(next.object, design.object) ? null : next.object};
  const changed: Moment = {
    ...moment,
    objects: objects.map((use, i) => (i === one.object ? {...use, ...own} : use)),
    design: {...next, object: design.object, placement: design.placement},
  };
  const {rotation_deg, offset_mm} = next.placement;
  const turned = same(rotation_deg, before.placement.rotation_deg) ? {} : {rotation_deg};
  const shifted = !same(offset_mm, before.placement.offset_mm);
  const settled = shifted ? withItems(changed, settledItems(changed, lying)) : changed;
  return withItemOptions(settled, item, {...turned, ...(shifted ? {offset_mm} : {})});
}

export function withItems(moment: Moment, items: readonly ItemOptions[]): Moment {
  return {...moment, design: {...moment.design, items: [...items]}};
}

export function withItemOptions(moment: Moment, item: number, to: Partial<ItemOptions>): Moment {
  const {items} = moment.design;
  return withItems(moment, items.map((one, i) => (i === item ? {...one, ...to} : one)));
}

/** Those that lie beside the others stay where that is. */
function settledItems(moment: Moment, lying: readonly Lying[]): ItemOptions[] {
  return moment.design.items.map((item, i) => (lying[i] ? {...item, offset_mm: offsetOf(moment, i, lying)} : item));
}

/** One item more of each object, which may lie there already. `size_mm`: of the object as it stands in its file, where
 *  that is known. They lie beside the others, all of which stay where they lie. */
export function withJoined(
  moment: Moment,
  more: readonly {id: string; size_mm: Triple | null}[],
  defaults: Design,
  lying: readonly Lying[],
): Moment {
  let joined = moment;
  const there = [...lying];
  for (const {id, size_mm} of more) {
    joined = withItem(joined, id, defaults, size_mm, there);
    const place = joined.design.items.at(-1)?.offset_mm;
    if (place && size_mm) there.push(boxAt(place, size_mm));
  }
  return joined;
}

function boxAt(offset_mm: Triple, size_mm: Triple): Lying {
  return {offset_mm, bounds: {min: sum(offset_mm, size_mm, -0.5), max: sum(offset_mm, size_mm, 0.5)}};
}

function withItem(moment: Moment, id: string, defaults: Design, size_mm: Triple | null, lying: readonly Lying[]): Moment {
  const wide = spread(moment, defaults);
  const known = wide.objects.findIndex((use) => use.id === id);
  const objects = known < 0 ? [...wide.objects, {id, own: null}] : wide.objects;
  const item = {...defaults.items[0]!, object: known < 0 ? objects.length - 1 : known, offset_mm: besideAll(wide, defaults.items[0]!.layer, size_mm, lying)};
  return withItems({...wide, objects}, [...wide.design.items, item]);
}

/** The same once more, beside all others. */
export function duplicated(moment: Moment, item: number, defaults: Design, lying: readonly Lying[]): Moment {
  const wide = spread(moment, defaults);
  const bounds = lying[item]?.bounds;
  const offset_mm = besideAll(wide, wide.design.items[item]!.layer, bounds ? sum(bounds.max, bounds.min, -1) : null, lying);
  return withItems(wide, [...wide.design.items, {...wide.design.items[item]!, offset_mm, lock: false}]);
}

/** A place for one more in a layer; none while all lie in their row. */
function besideAll({design}: Moment, layer: number, size_mm: Triple | null, lying: readonly Lying[]): Triple | null {
  const {items, space} = design;
  if (!size_mm || lying.length === 0 || items.every((item) => item.offset_mm === null)) return null;
  const apart = between(design, 2);
  const ends = [Math.max(...lying.map(({bounds}) => bounds.max[2])), Math.min(...lying.map(({bounds}) => bounds.min[2]))];
  // To the side where there is more room; in a space that follows its items there is as much on both.
  const side = space.blocks !== 'auto' && ends[0]! + ends[1]! > 0 ? -1 : 1;
  const z = ends[side > 0 ? 0 : 1]! + side * (apart + size_mm[2] / 2);
  const x = layersOf(design) > 1 ? (lying[items.findIndex((item) => item.layer === layer)]?.offset_mm[0] ?? 0) : 0;
  return [x, 0, Math.round(z * 2) / 2];
}

/** Without an item, and without its object where it was the last of it. */
export function withoutItem(moment: Moment, item: number): Moment {
  const {design, objects} = moment;
  const gone = design.items[item];
  const left = design.items.filter((_, i) => i !== item);
  if (!gone || left.length === 0) return moment;
  const last = left.every(({object}) => object !== gone.object);
  const items = left.map((one) => (last && one.object > gone.object ? {...one, object: one.object - 1} : one));
  const others: Moment = {
    design: withFittingParting({...design, items: closedUp(items)}),
    objects: last ? objects.filter((_, i) => i !== gone.object) : objects,
  };
  return items.length === 1 ? alone(others) : others;
}

/** Whether no hand moves an item. */
export function isLocked({design}: Moment, item: number): boolean {
  return design.items[item]?.lock ?? false;
}

export function withLock(moment: Moment, item: number, lock: boolean): Moment {
  const items = moment.design.items.map((one, i) => (i === item ? {...one, lock} : one));
  return {...moment, design: {...moment.design, items}};
}

/** What was chosen for one item alone becomes its own, before others join it. */
function spread(moment: Moment, defaults: Design): Moment {
  const {design, objects} = moment;
  const [item] = design.items;
  if (design.items.length !== 1 || !item) return moment;
  const {rotation_deg, offset_mm} = design.placement;
  const own = {
    ...item,
    rotation_deg: same(rotation_deg, defaults.placement.rotation_deg) ? null : rotation_deg,
    offset_mm: same(offset_mm, defaults.placement.offset_mm) ? null : offset_mm,
    mass_kg: design.workshop.mass_kg,
    centre_mm: item.centre_mm ?? design.protection.centre_mm,
    zones: item.zones.length > 0 ? item.zones : design.protection.zones,
  };
  return {
    ...moment,
    objects: objects.map((use) => ({...use, own: same(design.object, defaults.object) ? null : design.object})),
    design: {
      ...design,
      object: defaults.object,
      placement: defaults.placement,
      items: [own],
      protection: {...design.protection, centre_mm: null, zones: []},
      workshop: {...design.workshop, mass_kg: null},
    },
  };
}

/** The other way round, as the library does it for projects. A space that follows its item needs no offset. */
function alone(moment: Moment): Moment {
  const {design, objects} = moment;
  const item = design.items[0]!;
  const {placement} = design;
  const offset = design.space.blocks === 'auto' ? placement.offset_mm : (item.offset_mm ?? placement.offset_mm);
  const clearance_mm = item.clearance_mm ?? design.cut.clearance_mm;
  return {
    ...moment,
    objects: objects.map((use) => ({...use, own: null})),
    design: {
      ...design,
      object: objects[0]?.own ?? design.object,
      placement: {rotation_deg: item.rotation_deg ?? placement.rotation_deg, offset_mm: offset},
      items: [{...item, rotation_deg: null, offset_mm: null, clearance_mm: null, mass_kg: null, centre_mm: null, fragility_g: null, zones: [], lock: false}],
      cut: {...design.cut, clearance_mm},
      protection: {
        ...design.protection,
        centre_mm: item.centre_mm ?? design.protection.centre_mm,
        ...(item.fragility_g === null ? {} : {fragility_g: item.fragility_g, fragility: null}),
        zones: item.zones.length > 0 ? item.zones : design.protection.zones,
      },
      workshop: {...design.workshop, mass_kg: item.mass_kg ?? design.workshop.mass_kg},
    },
  };
}

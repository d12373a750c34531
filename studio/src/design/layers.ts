import type {Design, Triple} from './design';
import {clearances, withParting} from './edit';

// Items in layers that stand on each other, the lowest is 1.

export type ItemOptions = Design['items'][number];

/** Where an item lies, and the box that it fills, as the design has offsets. */
export interface Lying {
  readonly offset_mm: Triple;
  readonly bounds: {readonly min: Triple; readonly max: Triple};
}

export function layersOf({items}: Pick<Design, 'items'>): number {
  return Math.max(...items.map(({layer}) => layer));
}

/** Levels are chosen for each layer: where there are more or fewer of them now, they are chosen anew. */
export function withFittingParting(design: Design): Design {
  const {level} = design.parting;
  return level === 'auto' || [level].flat().length === layersOf(design) ? design : withParting(design, 'auto');
}

/** Without the layers in which nothing lies any more. */
export function closedUp(items: readonly ItemOptions[]): ItemOptions[] {
  const layers = [...new Set(items.map(({layer}) => layer))].sort((a, b) => a - b);
  return items.map((item) => ({...item, layer: layers.indexOf(item.layer) + 1}));
}

/** What items stand apart along an axis, mm: as much foam as is wanted, and a block more, so that whole blocks lie between
 *  them wherever they are. */
export function between({space}: Pick<Design, 'space'>, axis: 0 | 1 | 2): number {
  const block = space.block_mm[axis];
  const wanted = space.between_mm ?? Math.max(space.block_mm[1], space.block_mm[2], 12.7);
  return (Math.ceil(wanted / block) + 1) * block;
}

/** After an item was put into another layer. Items that a hand has placed would stay as high as they are: all of them go
 *  where their layers stand on each other, the one in the middle of its new layer, and stay where they are in the plan. */
export function withLayersStacked(design: Design, item: number, lying: readonly Lying[]): Design {
  const fitting = withFittingParting(design);
  const {items} = design;
  if (lying.length !== items.length || items.every(({offset_mm}) => offset_mm === null)) return fitting;
  const rises = risesToStack(design, item, lying);
  const stacked = items.map((one, i): ItemOptions => {
    const [x, y, z] = lying[i]!.offset_mm;
    return {...one, offset_mm: [Math.round((x + rises[i]!) * 2) / 2, y, z]};
  });
  return {...fitting, items: stacked};
}

function risesToStack(design: Design, item: number, lying: readonly Lying[]): number[] {
  const {items} = design;
  const heights = lying.map((one, i) => heightsOf(design, items[i]!, one));
  const beside = heights.filter((_, i) => i !== item && items[i]!.layer === items[item]!.layer);
  const rises = items.map((_, i) => (i === item && beside.length > 0 ? middle(hull(beside)) - middle(heights[i]!) : 0));
  const apart = between(design, 0);
  let at = 0;
  for (let layer = 1; layer <= layersOf(design); layer++) {
    const own = [...items.keys()].filter((i) => items[i]!.layer === layer);
    const [low, high] = hull(own.map((i) => heights[i]!.map((mm) => mm + rises[i]!) as Heights));
    for (const i of own) rises[i]! += at - low;
    at += high - low + apart;
  }
  return rises.map((rise) => rise - (at - apart) / 2);
}

type Heights = [low: number, high: number];

/** With its clearance, mm along x. */
function heightsOf(design: Design, {clearance_mm}: ItemOptions, {bounds: {min, max}}: Lying): Heights {
  const own = clearances({cut: {...design.cut, clearance_mm: clearance_mm ?? design.cut.clearance_mm}});
  const {liner_mm} = design.cut;
  return [min[0] - (own[0] ?? 0) - liner_mm, max[0] + (own[3] ?? 0) + liner_mm];
}

function hull(all: readonly Heights[]): Heights {
  return [Math.min(...all.map(([low]) => low)), Math.max(...all.map(([, high]) => high))];
}

function middle([low, high]: Heights): number {
  return (low + high) / 2;
}

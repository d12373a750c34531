import {pathsBelow, type OptionPath, type Schema} from './options';

// What stands in which panel, in which order, and which of it is usual: the rest is behind the panel's More. Nothing else
// says so.

export const STEPS = ['object', 'foam', 'placement', 'check', 'make'] as const;
export type Step = (typeof STEPS)[number];

/** What a panel has besides options: tools, and what is told. */
export type Tool =
  | 'length'
  | 'parts'
  | 'zones'
  | 'walls-apart'
  | 'sides'
  | 'fine-turn'
  | 'optimize'
  | 'arrange'
  | 'smallest'
  | 'map'
  | 'quarters'
  | 'own-foams'
  | 'walls'
  | 'gaps'
  | 'kind'
  | 'command';
export type FieldName = OptionPath | Tool;

interface Panel {
  step: Step;
  usual: readonly FieldName[];
  more: readonly FieldName[];
}

export const PANELS = {
  object: {
    step: 'object',
    usual: ['object.units', 'object.cap', 'length'],
    more: ['parts', 'object.point_radius_mm', 'zones'],
  },
  /** Of the one that is selected. */
  items: {
    step: 'object',
    usual: ['items.0.name', 'items.0.mass_kg'],
    more: ['items.0.group', 'items.0.layer', 'items.0.clearance_mm', 'items.0.fragility_g', 'items.0.lock'],
  },
  foam: {
    step: 'foam',
    usual: ['space.preset', 'space.wall_mm', 'case.inside_mm'],
    more: [
      'cut.clearance_mm',
      'walls-apart',
      'cut.liner_mm',
      'fit.least_rib_mm',
      'fit.settle',
      'fit.pads',
      'fit.relief',
      'fit.notches',
      'fit.lift',
      'cut.cut_on_touch',
      'space.open',
      'parting.level',
      'space.blocks',
      'space.block_mm',
    ],
  },
  placement: {
    step: 'placement',
    usual: ['sides', 'optimize', 'arrange'],
    more: [
      'fine-turn',
      'quarters',
      'placement.offset_mm',
      'search.weights',
      'search.upright',
      'search.turns',
      'search.layers',
      'smallest',
      'map',
    ],
  },
  drops: {
    step: 'check',
    usual: ['protection.foam', 'protection.rule', 'protection.fragility', 'workshop.mass_kg'],
    more: ['own-foams', 'protection.centre_mm'],
  },
  check: {
    step: 'check',
    usual: [],
    more: ['walls', 'gaps'],
  },
  workshop: {
    step: 'make',
    usual: [
      'workshop.for',
      'workshop.sheets.thickness_mm',
      'workshop.sheets.stock_mm',
      'workshop.print.bed_mm',
      'workshop.bricks.lower_color',
      'workshop.bricks.lid_color',
      'workshop.mill.cutter_mm',
      'workshop.mill.flute_mm',
    ],
    more: [
      'workshop.paper',
      'workshop.sponge.maps',
      'workshop.price_per_litre',
      'workshop.currency',
      'workshop.sheets.kerf_mm',
      'workshop.sheets.liner_slit_mm',
      'workshop.sheets.copies',
      'workshop.sheets.second_color',
      'workshop.print.dowels',
      'workshop.bricks.unit',
      'workshop.bricks.rim',
      'workshop.bricks.capacity_n',
      'workshop.bricks.family',
      'workshop.bricks.stock',
      'workshop.mill.step_down_mm',
      'workshop.mill.stepover',
      'workshop.mill.feed_mm_min',
      'workshop.mill.plunge_mm_min',
      'workshop.mill.spindle_rpm',
      'workshop.mill.safe_mm',
      'workshop.mill.pin_mm',
      'workshop.mill.origin',
      'kind',
      'command',
    ],
  },
} as const satisfies Record<string, Panel>;
export type PanelName = keyof typeof PANELS;

/** Options that a field sets which its name does not say. */
const SETS: Partial<Record<FieldName, readonly OptionPath[]>> = {
  length: ['object.scale'],
  parts: ['object.clean.drop_parts'],
  sides: ['placement.rotation_deg'],
  'protection.rule': ['protection.rule', 'protection.height_mm'],
  'protection.fragility': ['protection.fragility', 'protection.fragility_g'],
};

/** Options with fields of their own inside another one. */
const HOLDS: Partial<Record<FieldName, readonly OptionPath[]>> = {
  parts: ['object.clean.drop_below_mm'],
  'case.inside_mm': ['case.lid_mm', 'case.play_mm', 'case.corner_radius_mm'],
  'fit.pads': ['fit.pads.sheet_mm', 'fit.pads.squeeze_mm'],
  'fit.relief': ['fit.relief.height_mm', 'fit.relief.island_mm'],
  'fit.notches': ['fit.notches.width_mm', 'fit.notches.depth_mm', 'fit.notches.room_mm', 'fit.notches.axis'],
  'fit.lift': ['fit.lift.width_mm', 'fit.lift.depth_mm'],
};

/** Answers about the object, and the choices that bring others with them: nothing to be put back to how it was. */
const ANSWERS: readonly FieldName[] = ['object.units', 'workshop.for', 'items.0.name', 'items.0.lock'];

/** Of an item: where it lies is told by the placement, and its centre of mass counts in the coordinates of its file. */
const NOT_LISTED: readonly OptionPath[] = ['edits', 'items.0.object', 'items.0.rotation_deg', 'items.0.offset_mm', 'items.0.centre_mm', 'items.0.zones'];

/** The fields of a panel. An option of items that is not named stands behind More. A way of working none of whose options is named has them all behind More, in the table's order. */
export function fieldsIn(panel: PanelName, rows: Schema): {usual: readonly FieldName[]; more: readonly FieldName[]} {
  const {usual, more}: Panel = PANELS[panel];
  if (panel === 'items') {
    const known = [...usual, ...more, ...NOT_LISTED];
    return {usual, more: [...more, ...pathsBelow(rows, 'items.0').filter((path) => !known.includes(path))]};
  }
  if (panel !== 'workshop') return {usual, more};
  const named = (way: string) => [...usual, ...more].some((name) => name.startsWith(`workshop.${way}.`));
  const others = (rows['workshop.for'].words ?? []).filter((way) => !named(way));
  return {usual, more: [...others.flatMap((way) => pathsBelow(rows, `workshop.${way}`)), ...more]};
}

export function isOption(name: FieldName): name is OptionPath {
  return name.includes('.');
}

/** The options that a field by itself sets. */
export function setBy(name: FieldName): readonly OptionPath[] {
  return SETS[name] ?? (isOption(name) ? [name] : []);
}

export function heldBy(name: FieldName): readonly OptionPath[] {
  return HOLDS[name] ?? [];
}

export function isAnswer(name: FieldName): boolean {
  return ANSWERS.includes(name);
}

/** The way of working that an option is of; null where it is of all. What is printed is printed in moulds, too. */
export function waysOf(name: FieldName, ways: readonly string[]): readonly string[] | null {
  const way = /^workshop\.(\w+)\./.exec(name)?.[1];
  if (!way || !ways.includes(way)) return null;
  return way === 'print' ? ['print', 'mould'] : [way];
}

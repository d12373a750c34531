import type {Design, Preset, Triple, Work} from '../design/design';
import {usualPreset} from '../design/edit';
import type {Side} from '../design/rotation';
import {sideDown} from '../design/rotation';
import type {PlanWishes} from '../engine/plan';
import {remember, remembered} from '../words/remembered';

// What is asked before proposals are made: of the object it goes into the design, as the fields of the steps put it there;
// the rest are wishes. From both come the design and the wishes that the library plans with.

export const CARRIERS = ['store', 'hand', 'courier', 'parcel'] as const;
export const CASES = ['cartons', 'hard-cases', 'none', 'named'] as const;
export const WAYS = ['sponge', 'sheets', 'print', 'bricks', 'mill', 'mould'] as const satisfies readonly Work[];

export interface Wishes {
  carrier: PlanWishes['carrier'];
  /** `named`: the design has it. */
  cases: (typeof CASES)[number];
  /** `blocks`, `data`: the design has the foam’s blocks, or what is known of it. */
  foam: 'choose' | 'blocks' | 'data';
  /** Of working. */
  ways: readonly Work[];
}

export const USUAL_WISHES: Wishes = {carrier: 'parcel', cases: 'cartons', foam: 'choose', ways: ['sponge', 'sheets']};

const KEY = 'snug-wishes';

/** Who carries it, which cases and tools there are, as this person had it last. What the design has is asked anew. */
export function rememberedWishes(): Wishes {
  try {
    const {carrier, cases, ways} = JSON.parse(remembered(KEY) ?? '{}') as Partial<Wishes>;
    const known = WAYS.filter((way) => ways?.includes(way));
    return {
      ...USUAL_WISHES,
      carrier: CARRIERS.find((one) => one === carrier) ?? USUAL_WISHES.carrier,
      cases: CASES.find((one) => one === cases && one !== 'named') ?? USUAL_WISHES.cases,
      ways: known.length > 0 ? known : USUAL_WISHES.ways,
    };
  } catch {
    return USUAL_WISHES;
  }
}

export function rememberWishes(wishes: Wishes): void {
  remember(KEY, JSON.stringify(wishes));
}

export function planWishes({carrier, cases, foam, ways}: Wishes): PlanWishes {
  return {carrier, ways: [...ways], cases: cases === 'named' ? 'none' : cases, own_blocks: foam === 'blocks'};
}

/** The ways that work a foam as their own usual one is worked. */
export function waysFor(preset: Preset, presets: readonly Preset[]): readonly Work[] {
  const ways = WAYS.filter((way) => usualPreset(presets, way)?.worked === preset.worked);
  return ways.length > 0 ? ways : ['sponge'];
}

/** The design that proposals are made from: what was asked of the object stays, what was chosen for it, by a person or by
 *  an earlier proposal, is open again. `error_mm`: how far its measurements may be off. */
export function planned(design: Design, wishes: Wishes, defaults: Design, presets: readonly Preset[], error_mm = 0): Design {
  const {placement, protection, search} = design;
  const {play_mm, division} = design.case;
  const blocks: Design['space'] = wishes.foam === 'blocks' ? design.space : {...defaults.space, between_mm: design.space.between_mm};
  return {
    ...design,
    space: {...blocks, blocks: 'auto', wall_mm: defaults.space.wall_mm, open: null},
    placement: {...defaults.placement, rotation_deg: search.upright ? placement.rotation_deg : defaults.placement.rotation_deg},
    items: design.items.map((item) => (item.lock ? item : {...item, offset_mm: null, rotation_deg: null})),
    cut: {...design.cut, clearance_mm: plannedClearance(design, wishes, defaults, presets, error_mm)},
    fit: {...design.fit, settle: defaults.fit.settle},
    parting: {level: 'auto'},
    edits: defaults.edits,
    case: wishes.cases === 'named' ? design.case : {...defaults.case, play_mm, division},
    protection: {...protection, foam: wishes.foam === 'data' ? protection.foam : null, height_mm: null, rule: null},
    workshop: {...design.workshop, for: null},
  };
}

/** None: each foam brings its own. One that a person chose stays, and so does room for what was measured wrong. */
function plannedClearance({space, cut}: Design, {foam, ways}: Wishes, defaults: Design, presets: readonly Preset[], error_mm: number): Design['cut']['clearance_mm'] {
  const preset = presets.find(({name}) => name === space.preset);
  const own = preset?.clearance_mm ?? 0;
  const usual = foam === 'blocks' ? own : Math.max(...ways.map((way) => usualPreset(presets, way)?.clearance_mm ?? 0));
  const brought = [own, own + error_mm, defaults.cut.clearance_mm];
  if (!brought.some((mm) => mm === cut.clearance_mm)) return cut.clearance_mm;
  if (error_mm > 0) return usual + error_mm;
  return foam === 'blocks' ? cut.clearance_mm : defaults.cut.clearance_mm;
}

/** One side stays down; null: it may lie on any. */
export function withSideKept(design: Design, side: Side | null): Design {
  if (!side) return {...design, search: {...design.search, upright: null}};
  const upright = (side.startsWith('-') ? side.slice(1) : `-${side.slice(1)}`) as Design['search']['upright'];
  const rotation_deg: Triple = sideDown(design.placement.rotation_deg, side);
  return {...design, placement: {rotation_deg, offset_mm: [0, 0, 0]}, search: {...design.search, upright}};
}

/** Of a surface that comes off when it is rubbed: a cloth lies between. */
export const LOOSE_LINER_MM = 0.5;

export function withLooseSurface(design: Design, loose: boolean, defaults: Design): Design {
  return {...design, cut: {...design.cut, liner_mm: loose ? LOOSE_LINER_MM : defaults.cut.liner_mm}};
}

export function withMass(design: Design, item: number, mass_kg: number | null): Design {
  if (design.items.length === 1) return {...design, workshop: {...design.workshop, mass_kg}};
  return {...design, items: design.items.map((one, i) => (i === item ? {...one, mass_kg} : one))};
}

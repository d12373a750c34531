import type {Design, KnownCase, Preset, Triple, Unit, Work} from './design';
import {withFoamData} from './protection';

// Every change that a person can make, as a function from a design to the next one. Ranges are the library's
// business: it refuses what cannot be, with its own sentence.

export function withAxis(value: Triple, axis: number, to: number): Triple {
  return value.map((old, i) => (i === axis ? to : old)) as Triple;
}

/** Counts of other blocks would mean another size: the space fits itself again. `before`: what it takes the place of, whose
 *  walls go with it; what was added to its clearance stays added, and what is known of the foam stays where both are the same
 *  material. */
export function withPreset(design: Design, preset: Preset, before?: Preset): Design {
  const {wall_mm} = design.space;
  const brought = before && before.wall_mm !== null && wall_mm === before.wall_mm;
  const next: Design = {
    ...design,
    space: {...design.space, preset: preset.name, block_mm: [...preset.block_mm], blocks: 'auto', wall_mm: preset.wall_mm ?? (brought ? null : wall_mm)},
    cut: before ? withMoreClearance(design, preset.clearance_mm - before.clearance_mm, preset.least_clearance_mm).cut : {...design.cut, clearance_mm: preset.clearance_mm},
    case: {...design.case, division: preset.division},
    parting: {level: 'auto'},
  };
  return withFoamData(next, !before || isSameFoam(preset, before) ? design.protection.foam : null, preset);
}

/** Of a density that is not known, nobody can say so. */
function isSameFoam({density_kg_m3}: Preset, before: Preset): boolean {
  return density_kg_m3 !== null && density_kg_m3 === before.density_kg_m3;
}

/** The blocks that a way of working takes: the foam that is known stays, where these are of any foam at all. */
export function withPresetOfWay(design: Design, preset: Preset, before?: Preset): Design {
  const next = withPreset(design, preset, before);
  return preset.rigid ? next : withFoamData(next, design.protection.foam, preset);
}

/** `shown`: the counts on the screen, which a fitted space has chosen by itself. */
export function withBlocks(design: Design, axis: number, count: number, shown: Triple): Design {
  const blocks = withAxis(design.space.blocks === 'auto' ? shown : design.space.blocks, axis, count);
  return {...design, space: {...design.space, blocks}};
}

export function withSpace(design: Design, blocks: Design['space']['blocks']): Design {
  return {...design, space: {...design.space, blocks}};
}

export function withFittedSpace(design: Design, fitted: boolean, shown: Triple): Design {
  return {...design, space: {...design.space, blocks: fitted ? 'auto' : shown}};
}

export function withBlockSize(design: Design, axis: number, mm: number): Design {
  return {...design, space: {...design.space, block_mm: withAxis(design.space.block_mm, axis, mm)}};
}

/** The six walls, floor, roof, back, front, left, right. `fitted`: what each is where none is chosen and the space follows
 *  the object. */
export function walls({space}: Design, fitted: number): number[] {
  if (Array.isArray(space.wall_mm)) return space.wall_mm;
  return Array<number>(6).fill(space.wall_mm ?? (space.blocks === 'auto' ? fitted : 0));
}

export function withWalls(design: Design, wall_mm: number | number[]): Design {
  return {...design, space: {...design.space, wall_mm}};
}

/** A case of other sizes is no longer the one that has the name. */
export function withCase(design: Design, to: Partial<Design['case']>, {divisor}: Design['case']): Design {
  const other = 'inside_mm' in to || 'lid_mm' in to ? {name: '', divisor} : {};
  return {...design, case: {...design.case, ...other, ...to}};
}

/** A case that is known, with the object laid as it was ranked; several items stay as they lie. */
export function withKnownCase(design: Design, known: KnownCase, several = false): Design {
  const {name, inside_mm, lid_mm, divisor, rotation_deg} = known;
  const sides = {base_mm: null, top_mm: null, corner_radius_mm: 0};
  return {
    ...design,
    case: {...design.case, name, inside_mm, lid_mm, divisor, ...sides},
    placement: several ? design.placement : {rotation_deg, offset_mm: [0, 0, 0]},
    parting: {level: 'auto'},
  };
}

/** The one thing that a search looks for. */
export function withObjective(design: Design, objective: string): Design {
  const weights = Object.fromEntries(Object.keys(design.search.weights).map((name) => [name, Number(name === objective)]));
  return {...design, search: {...design.search, weights}};
}

export function objective({search}: Design): string {
  return Object.entries(search.weights).reduce((best, next) => (next[1] > best[1] ? next : best))[0];
}

export function withUpright(design: Design, upright: Design['search']['upright']): Design {
  return {...design, search: {...design.search, upright}};
}

export function withWorkshop(design: Design, to: Partial<Design['workshop']>): Design {
  return {...design, workshop: {...design.workshop, ...to}};
}

/** The foam that a way of working takes where none is chosen for it. */
export function usualPreset(presets: readonly Preset[], work: Work | null): Preset | null {
  return presets.find(({usual_for}) => work !== null && usual_for.includes(work)) ?? null;
}

export function withRotation(design: Design, rotation_deg: Triple): Design {
  return {...design, placement: {...design.placement, rotation_deg}};
}

export function withPlacement(design: Design, {rotation_deg, offset_mm}: Design['placement']): Design {
  return {...design, placement: {rotation_deg, offset_mm}};
}

export function withOffset(design: Design, offset_mm: Triple): Design {
  return {...design, placement: {...design.placement, offset_mm}};
}

export function withClearance(design: Design, clearance_mm: number | number[]): Design {
  return {...design, cut: {...design.cut, clearance_mm}};
}

/** x, y, z of the lower foam, then of the upper. */
export function clearances({cut}: Pick<Design, 'cut'>): number[] {
  return typeof cut.clearance_mm === 'number' ? Array<number>(6).fill(cut.clearance_mm) : cut.clearance_mm;
}

/** More on every side, less where `mm` is below 0, though never less than `least`. */
export function withMoreClearance(design: Design, mm: number, least = -Infinity): Design {
  // Without the dust of adding, so that there and back is the same.
  const all = clearances(design).map((old) => Math.max(least, Math.round((old + mm) * 1e6) / 1e6));
  return withClearance(design, typeof design.cut.clearance_mm === 'number' ? all[0]! : all);
}

export function withClearanceOf(design: Design, side: number, mm: number): Design {
  return withClearance(
    design,
    clearances(design).map((old, i) => (i === side ? mm : old)),
  );
}

export function withFit(design: Design, fit: Partial<Design['fit']>): Design {
  return {...design, fit: {...design.fit, ...fit}};
}

export function withParting(design: Design, level: Design['parting']['level']): Design {
  return {...design, parting: {level}};
}

/** A tray, whose surface follows how deep its items are sunk, and which is not dropped; null: foams that close. */
export function withTray(design: Design, open: Design['space']['open']): Design {
  const protection = open === null ? design.protection : {...design.protection, height_mm: null, rule: null};
  return withParting({...design, space: {...design.space, open}, protection}, 'auto');
}

export function withCap(design: Design, cap: boolean): Design {
  return {...design, object: {...design.object, cap}};
}

/** Drops a part of the object, or takes it back. */
export function withPart(design: Design, part: number, kept: boolean): Design {
  const others = design.object.clean.drop_parts.filter((number) => number !== part);
  const drop_parts = kept ? others : [...others, part].sort((a, b) => a - b);
  return {...design, object: {...design.object, clean: {...design.object.clean, drop_parts}}};
}

export function withUnits(design: Design, units: Unit): Design {
  return {...design, object: {...design.object, units, longest_mm: null}};
}

/** Whatever the unit of the file is. */
export function withLongest(design: Design, longest_mm: number): Design {
  return {...design, object: {...design.object, units: null, scale: 1, longest_mm}};
}

export const MM_PER_UNIT: Record<Unit, number> = {mm: 1, cm: 10, m: 1000, in: 25.4};

/** Scales the object so that what is `length` of the file's units long becomes `mm` long. A file that states its
 *  unit is in mm, whatever the design says. */
export function withLength(design: Design, length: number, mm: number, statesUnit = false): Design {
  const units = statesUnit ? null : (design.object.units ?? 'mm');
  const scale = mm / (length * MM_PER_UNIT[units ?? 'mm']);
  return {...design, object: {...design.object, units, scale, longest_mm: null}};
}

/** Millimetres for one unit of the file, as the design has it. */
export function mmPerFileUnit(design: Design, fileSize: Triple, statesUnit = false): number {
  const {units, scale, longest_mm} = design.object;
  if (longest_mm !== null) return longest_mm / Math.max(...fileSize);
  return MM_PER_UNIT[(statesUnit ? null : units) ?? 'mm'] * scale;
}

/** A design of another version, with what it does not say as it is by default. */
export function completed(design: Design, defaults: Design): Design {
  const parts = Object.entries(defaults).map(([name, part]) => {
    const own = design[name as keyof Design];
    if (Array.isArray(part) && part.length === 0) return [name, own ?? part];
    const [one] = Array.isArray(part) ? (part as unknown[]) : [];
    return [name, one ? ((own as object[] | undefined) ?? [one]).map((each) => ({...one, ...each})) : {...part, ...own}];
  });
  return Object.fromEntries(parts) as Design;
}

/** What a file begins with that was never opened here: a space that fits it. */
export function firstDesign(defaults: Design, object = defaults.object): Design {
  return withSpace({...defaults, object}, 'auto');
}

/** What a fresh object starts with. To the person belongs how they work: the foam and its blocks, the way of working
 *  with its machines and prices, what a search looks for. To the object belongs all that was chosen to hold or to
 *  place it: walls, case, tray, clearance, settling, pads, relief, notches, which axis is up, what it weighs and bears. The
 *  latter begins anew, with the foam's own clearance, so that a thin wall for a ring never holds the next vase. */
export function forNewObject(design: Design, defaults: Design, presets: readonly Preset[]): Design {
  const preset = presets.find(({name}) => name === design.space.preset);
  const {play_mm, division} = design.case;
  return {
    ...design,
    object: defaults.object,
    placement: defaults.placement,
    items: defaults.items,
    edits: defaults.edits,
    parting: {level: 'auto'},
    space: {...design.space, blocks: 'auto', wall_mm: preset?.wall_mm ?? defaults.space.wall_mm, open: defaults.space.open},
    cut: {...design.cut, clearance_mm: preset?.clearance_mm ?? defaults.cut.clearance_mm},
    fit: {...design.fit, settle: false, pads: null, relief: null, notches: null},
    case: {...defaults.case, play_mm, division},
    search: {...design.search, upright: null},
    protection: {...design.protection, fragility_g: null, fragility: null, centre_mm: null, zones: defaults.protection.zones},
    workshop: {...design.workshop, mass_kg: null},
  };
}

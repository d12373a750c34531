import type {Design, Preset, Triple, Unit} from '../engine/api';

// Every change that a person can make, as a function from a design to the next one. Ranges are the library's
// business: it refuses what cannot be, with its own sentence.

export function withAxis(value: Triple, axis: number, to: number): Triple {
  return value.map((old, i) => (i === axis ? to : old)) as Triple;
}

/** Counts of other blocks would mean another size: the space fits itself again. */
export function withPreset(design: Design, preset: Preset): Design {
  return {
    ...design,
    space: {...design.space, preset: preset.name, block_mm: [...preset.block_mm], blocks: 'auto'},
    cut: {...design.cut, clearance_mm: preset.clearance_mm},
    parting: {level: 'auto'},
  };
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

/** The thinnest of the walls that were chosen, where the sides differ. */
export function leastWall(wall_mm: number | number[] | null): number | null {
  return wall_mm === null ? null : Math.min(...[wall_mm].flat());
}

export function withWall(design: Design, wall_mm: number | null): Design {
  return {...design, space: {...design.space, wall_mm}};
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

export function withClearance(design: Design, clearance_mm: number): Design {
  return {...design, cut: {...design.cut, clearance_mm}};
}

export function withCutOnTouch(design: Design, cut_on_touch: boolean): Design {
  return {...design, cut: {...design.cut, cut_on_touch}};
}

export function withParting(design: Design, level: number | 'auto'): Design {
  return {...design, parting: {level}};
}

export function withCap(design: Design, cap: boolean): Design {
  return {...design, object: {...design.object, cap}};
}

export function withUnits(design: Design, units: Unit): Design {
  return {...design, object: {...design.object, units, longest_mm: null}};
}

export const MM_PER_UNIT: Record<Unit, number> = {mm: 1, cm: 10, m: 1000, in: 25.4};

/** Scales the object so that what is `length` of the file's units long becomes `mm` long. */
export function withLength(design: Design, length: number, mm: number): Design {
  const units = design.object.units ?? 'mm';
  const scale = mm / (length * MM_PER_UNIT[units]);
  return {...design, object: {...design.object, units, scale, longest_mm: null}};
}

/** Millimetres for one unit of the file, as the design has it. */
export function mmPerFileUnit(design: Design, fileSize: Triple): number {
  const {units, scale, longest_mm} = design.object;
  if (longest_mm !== null) return longest_mm / Math.max(...fileSize);
  return MM_PER_UNIT[units ?? 'mm'] * scale;
}

/** What a fresh object starts with: the foam stays as it was chosen, everything about the last object goes. */
export function forNewObject(design: Design, defaults: Design): Design {
  return {
    ...design,
    object: defaults.object,
    placement: defaults.placement,
    parting: {level: 'auto'},
    space: {...design.space, blocks: 'auto'},
  };
}

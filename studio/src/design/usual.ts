import type {Design, Preset} from './design';
import {usualPreset, withCase, withPreset, withTray} from './edit';
import {valueAt, withValue, type OptionPath, type Schema} from './options';

// What a design has where nobody chose, and the way back to it.

/** What that depends on. */
export interface Beginning {
  rows: Schema;
  defaults: Design;
  presets: readonly Preset[];
}

/** The row of an option, also of any item's. */
export function rowPath(path: OptionPath): OptionPath {
  return path.replace(/^items\.\d+\./, 'items.0.') as OptionPath;
}

/** A foam brings its blocks and its clearance, a way of working its foam. */
export function usualValue(design: Design, path: OptionPath, {rows, defaults, presets}: Beginning): unknown {
  const preset = presets.find(({name}) => name === design.space.preset);
  const brought: Partial<Record<OptionPath, unknown>> = {
    'space.preset': usualPreset(presets, design.workshop.for)?.name,
    'space.blocks': 'auto',
    'space.block_mm': preset?.block_mm,
    'space.wall_mm': preset?.wall_mm,
    'cut.clearance_mm': preset?.clearance_mm,
  };
  return brought[path] ?? valueAt(defaults, rowPath(path)) ?? rows[rowPath(path)].default ?? null;
}

/** Whether something else is chosen. What is not there is not. */
export function isOther(design: Design, path: OptionPath, beginning: Beginning): boolean {
  const value = valueAt(design, path);
  return value !== undefined && JSON.stringify(value) !== JSON.stringify(usualValue(design, path, beginning));
}

/** As if it had not been chosen, with all that was chosen with it. */
export function withUsual(design: Design, path: OptionPath, beginning: Beginning): Design {
  const usual = usualValue(design, path, beginning);
  if (path === 'case.inside_mm') return withCase(design, {inside_mm: null, lid_mm: null}, beginning.defaults.case);
  if (path === 'space.open') return withTray(design, null);
  const presetOf = (name: unknown) => beginning.presets.find((one) => one.name === name);
  const preset = path === 'space.preset' && presetOf(usual);
  return preset ? withPreset(design, preset, presetOf(design.space.preset)) : withValue(design, path, usual);
}

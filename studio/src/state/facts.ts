import type {BrickRange, Design, Preset} from '../design/design';
import type {Schema} from '../design/options';
import type {Engine} from '../engine/api';
import type {DropChoices} from '../engine/drops';

/** What the library says once, before anything is open. */
export interface Facts {
  defaults: Design;
  presets: Preset[];
  bricks: BrickRange;
  drops: DropChoices;
  /** The table of options. */
  rows: Schema;
  samples: string[];
  version: string;
}

export async function factsOf(engine: Engine): Promise<Facts> {
  const [defaults, presets, bricks, drops, rows, samples, version] = await Promise.all([
    engine.defaultDesign(),
    engine.presets(),
    engine.bricks(),
    engine.dropChoices(),
    engine.options(),
    engine.samples(),
    engine.version(),
  ]);
  return {defaults, presets, bricks, drops, rows, samples, version};
}

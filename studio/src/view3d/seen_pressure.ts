import type {Studio} from '../state/studio.svelte';
import {foamGrid, itemGrid, type PressureGrid} from './pressure_grid';

/** What squeezes what, as it is to be seen. */
export interface SeenPressure {
  items: PressureGrid[];
  foam: PressureGrid;
}

/** As it was chosen, of the pack on the screen; null while it is not known. */
export function seenPressure({packing, drops: {contacts}}: Studio): SeenPressure | null {
  const {current: map, most} = contacts;
  if (!packing || !map) return null;
  return {items: map.items.map((_, item) => itemGrid(map, packing, item, most)), foam: foamGrid(map, packing, most)};
}

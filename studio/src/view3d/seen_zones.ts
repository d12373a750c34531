import type {Triple} from '../design/design';
import {zonesOf} from '../design/zones';
import type {Painting} from '../state/painting.svelte';
import type {Studio} from '../state/studio.svelte';
import type {PaintHint, SeenZones} from './zone_paint';

/** The places of all items as the page shows them, and what the hand is about to paint. */
export function seenZones(studio: Studio, painting: Painting, brushAt: Triple | null): {zones: SeenZones[]; hint: PaintHint | null} {
  const {moment, selected, objects} = studio;
  const zones = (moment.design.items ?? []).map(({object}, item): SeenZones => {
    const own = item === selected;
    return {
      zones: own ? painting.shown(studio) : zonesOf(moment.design, item),
      chosen: own ? painting.chosen(studio) : null,
      origin: objects[object]?.origin_mm ?? [0, 0, 0],
    };
  });
  const {tool, radius_mm, height} = painting;
  const brush = brushAt && (tool === 'brush' || tool === 'eraser') ? {at: brushAt, radius_mm} : null;
  const origin = zones[selected]?.origin ?? [0, 0, 0];
  const band = tool === 'height' ? {axis: height.axis, from: height.from - origin[height.axis]!, to: height.to - origin[height.axis]!} : null;
  return {zones, hint: brush || band ? {brush, band} : null};
}

import {isFailure} from '../engine/failure';
import type {Studio} from '../state/studio.svelte';
import type {View} from '../state/view.svelte';
import {foamQuads, quadCentres, type Quads} from './foam_geometry';
import type {PieceColours} from './foam_meshes';

/** Of a piece; more faces than a person can tell apart. */
const MOST_TRIANGLES = 120_000;

/** The colours of the present packing, once they are known and as long as they are wanted. */
export function gapColours(studio: () => Studio, view: () => View): {readonly current: readonly PieceColours[] | null} {
  let known: {packing: unknown; colours: readonly PieceColours[]} | null = $state.raw(null);

  $effect(() => {
    const {packing, gap, engine} = studio();
    const {gapColours: wanted, moving} = view();
    if (!wanted || moving || !packing?.fit || !gap) return;
    const pieces = packing.pieces.map((_, piece) => foamQuads(packing, piece, MOST_TRIANGLES, true));
    const farthest = Math.max(gap.widest_mm / 2, 1e-9);
    const coloured = async (quads: Quads): Promise<PieceColours | null> => {
      const distances = await engine.distances(quadCentres(quads));
      if (isFailure(distances)) return null;
      return {quads, shares: distances.map((mm, quad) => (quads.inner[quad * 4] === 1 ? mm / farthest : -1))};
    };
    void Promise.all(pieces.map(coloured)).then((all) => {
      const colours = all.filter((piece) => piece !== null);
      if (colours.length === all.length) known = {packing, colours};
    });
  });

  return {
    get current() {
      return view().gapColours && known?.packing === studio().packing ? (known?.colours ?? null) : null;
    },
  };
}

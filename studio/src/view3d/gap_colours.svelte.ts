import {isFailure} from '../engine/failure';
import type {Studio} from '../state/studio.svelte';
import type {View} from '../state/view.svelte';
import {foamQuads, quadCentres} from './foam_geometry';
import type {GapColours} from './scene';

/** More faces than a person can tell apart. */
const MOST_TRIANGLES = 120_000;

/** The colours of the present packing, once they are known and as long as they are wanted. */
export function gapColours(studio: () => Studio, view: () => View): {readonly current: GapColours | null} {
  let known: {packing: unknown; colours: GapColours} | null = $state.raw(null);

  $effect(() => {
    const {packing, gap, engine} = studio();
    const {gapColours: wanted, moving} = view();
    if (!wanted || moving || !packing?.fit || !gap) return;
    const half = (name: 'lower' | 'upper') => foamQuads(packing, name, MOST_TRIANGLES, true);
    const quads = {lower: half('lower'), upper: half('upper')};
    const farthest = Math.max(gap.widest_mm / 2, 1e-9);
    const shares = async (name: 'lower' | 'upper') => {
      const distances = await engine.distances(quadCentres(quads[name]));
      if (isFailure(distances)) return null;
      const inner = (quad: number) => quads[name].inner[quad * 4] === 1;
      return distances.map((mm, quad) => (inner(quad) ? mm / farthest : -1));
    };
    void Promise.all([shares('lower'), shares('upper')]).then(([lower, upper]) => {
      if (!lower || !upper) return;
      known = {
        packing,
        colours: {lower: {quads: quads.lower, shares: lower}, upper: {quads: quads.upper, shares: upper}},
      };
    });
  });

  return {
    get current() {
      return view().gapColours && known?.packing === studio().packing ? (known?.colours ?? null) : null;
    },
  };
}

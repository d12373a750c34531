import type {Spot, View} from '../state/view.svelte';
import type {Picked} from './picked';
import type {FoamScene} from './scene';
import type {Stage} from './stage';

/** Between two places on whatever is seen, as a person measures. */
export class Tape {
  /** Where its length is said, px of the picture. */
  at: {x: number; y: number} | null = $state.raw(null);
  /** As they are drawn: the second one may be under the pointer still. */
  #shown: readonly Spot[] = $state.raw([]);

  constructor(
    private readonly view: View,
    private readonly content: FoamScene,
  ) {}

  get length_mm(): number | null {
    const [a, b] = this.#shown;
    return a && b ? Math.hypot(...a.at.map((mm, axis) => mm - b.at[axis]!)) : null;
  }

  /** It goes from one thing to another, which are drawn elsewhere than they lie. */
  get parted(): boolean {
    const [a, b] = this.#shown;
    return a !== undefined && b !== undefined && this.view.opening > 0 && JSON.stringify(a.on) !== JSON.stringify(b.on);
  }

  /** Begins, goes on or begins anew. */
  take({spot}: Picked) {
    if (!spot) return;
    const spots = this.view.spots ?? [];
    this.view.spots = spots.length === 1 ? [...spots, spot] : [spot];
  }

  /** The person points at something. */
  hover({spot}: Picked) {
    if (this.view.spots?.length === 1) this.show(spot ? [...this.view.spots, spot] : this.view.spots);
  }

  show(spots: readonly Spot[]) {
    this.#shown = spots;
    this.content.spots = spots;
  }

  /** After each picture. */
  follow(stage: Stage) {
    const [a, b] = this.#shown;
    if (!a || !b) return void (this.at = null);
    const middle = this.content.drawnSpot(a).lerp(this.content.drawnSpot(b), 0.5);
    const {x, y} = stage.onPicture(middle);
    if (Math.round(x) !== this.at?.x || Math.round(y) !== this.at.y) this.at = {x: Math.round(x), y: Math.round(y)};
  }
}

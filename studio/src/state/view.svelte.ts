import type {Triple} from '../design/design';
import type {PieceKind} from '../engine/pieces';
import {Painting} from './painting.svelte';

export type Part = 'object' | 'space' | PieceKind;
export type Look = 'shown' | 'glass' | 'hidden';
export type Handles = 'none' | 'turn' | 'shift';
/** The map of a piece, its cavity facing the reader: the lower one and trays from above, the lid from below, and one
 *  between two layers, by its number, from either side. */
export type PieceMap = 'lower' | `middle-${number}-${'above' | 'below'}` | 'lid';
export type Drawing = 'slice' | PieceMap;
export interface Cell {
  j: number;
  k: number;
}

/** How the person looks at the work; no part of it. */
export class View {
  /** 0 closed, 1 wide open. */
  opening = $state(0);
  looks: Record<Part, Look> = $state({object: 'shown', lower: 'shown', middle: 'shown', upper: 'shown', space: 'shown'});
  handles: Handles = $state('none');
  drawing: Drawing = $state('slice');
  /** Where the section lies, mm along x from the middle of the space: the layer of blocks there is shown, however
   *  thick and many they are. */
  slice_mm = $state(0);
  hovered: Cell | null = $state.raw(null);
  gapColours = $state(false);
  /** The two clicks on the object, in its own mm, while a length is being shown to Snug. */
  measuring: Triple[] | null = $state.raw(null);
  /** Places to keep off, by hand. */
  readonly painting = new Painting();
  /** A pointer or a key is moving something just now: draw less, but at once. */
  moving = $state(false);
  #still: ReturnType<typeof setTimeout> | undefined;

  /** Call at every change; the picture gets its details back a moment after the last. */
  nowMoving() {
    this.moving = true;
    clearTimeout(this.#still);
    this.#still = setTimeout(() => (this.moving = false), 250);
  }
}

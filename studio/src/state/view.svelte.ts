import type {Triple} from '../design/design';
import type {PieceKind} from '../engine/pieces';
import {remember, remembered} from '../words/remembered';
import {Painting} from './painting.svelte';

export type Part = 'object' | 'space' | PieceKind;
export type Look = 'shown' | 'glass' | 'hidden';
export type Handles = 'none' | 'turn' | 'shift';
/** Where the pieces of foam go when they are opened: above each other, or like an opened book. */
export type Opened = 'above' | 'book';
/** The map of a piece, its cavity facing the reader: the lower one and trays from above, the lid from below, and one
 *  between two layers, by its number, from either side. */
export type PieceMap = 'lower' | `middle-${number}-${'above' | 'below'}` | 'lid';
export type Drawing = 'upright' | 'slice' | PieceMap;
/** What a place belongs to, which is drawn elsewhere while the foams are open: an item, or a piece of foam from the lowest. */
export type SpotOwner = {item: number} | {piece: number};

/** A place on something, where it lies in the space; design coordinates. */
export interface Spot {
  on: SpotOwner;
  at: Triple;
}

/** A plane that takes away what is before it. */
export interface Section {
  axis: 0 | 1 | 2;
  /** Of its way through all that is seen, from the lower end. */
  share: number;
  /** Takes away what lies before it from the lower end instead. */
  flipped: boolean;
}
export interface Cell {
  j: number;
  k: number;
}

const OPENED = 'snug-opened';

/** How the person looks at the work; no part of it. */
export class View {
  /** 0 closed, 1 wide open. */
  opening = $state(0);
  opened: Opened = $state(remembered(OPENED) === 'book' ? 'book' : 'above');
  looks: Record<Part, Look> = $state({object: 'shown', lower: 'shown', middle: 'shown', upper: 'shown', space: 'shown'});
  /** The object by itself, while it is asked about. */
  alone = $state(false);
  handles: Handles = $state('none');
  /** Null until a person chooses: the upright section of one item, the plan of several. */
  drawing: Drawing | null = $state(null);
  /** Where the section lies, mm along x from the middle of the space: the layer of blocks there is shown, however
   *  thick and many they are. */
  slice_mm = $state(0);
  /** And the upright one, mm along y. */
  upright_mm = $state(0);
  hovered: Cell | null = $state.raw(null);
  gapColours = $state(false);
  /** The two clicks on the object, in its own mm, while a length is being shown to Snug. */
  measuring: Triple[] | null = $state.raw(null);
  /** In three dimensions; null: nothing is taken away. */
  section: Section | null = $state.raw(null);
  /** Two places between which a person measures, or as many as there are yet; null while nobody does. */
  spots: Spot[] | null = $state.raw(null);
  /** Where the view's menu is open, px of the page. */
  menu: {x: number; y: number} | null = $state.raw(null);
  /** What lies over the edges of the 3D view, px. */
  covered = $state.raw({top: 0, bottom: 0});
  /** Of them what is said while a person measures, and what a hand paints with. */
  helpHeight = $state(0);
  paintBar = $state(0);
  /** Places to keep off, by hand. */
  readonly painting = new Painting();
  /** A pointer or a key is moving something just now: draw less, but at once. */
  moving = $state(false);
  #still: ReturnType<typeof setTimeout> | undefined;

  openLike(opened: Opened) {
    this.opened = opened;
    remember(OPENED, opened);
  }

  /** Call at every change; the picture gets its details back a moment after the last. */
  nowMoving() {
    this.moving = true;
    clearTimeout(this.#still);
    this.#still = setTimeout(() => (this.moving = false), 250);
  }
}

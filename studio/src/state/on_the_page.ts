import type {BesideFile, DisplayMesh} from '../engine/api';
import type {Pair} from '../words/words';

// What the page shows beside the design and its object.

/** A sentence for the person, and what it is about. */
export interface Problem {
  control: string;
  text: Pair;
}

export type Work = 'start' | 'read' | 'gaps' | 'search' | 'arrange' | 'map' | 'walls' | 'plan' | 'make';
/** What takes long just now. `fraction`: 0 to 1 where it is known. */
export interface Busy {
  work: Work;
  /** What is read. */
  file?: FileFacts;
  fraction: number | null;
  cancel: (() => void) | null;
}

export interface FileFacts {
  name: string;
  bytes: number;
}

/** A reading under way: whoever works on it looks after each step whether it still goes on. */
export interface Reading {
  cancelled: boolean;
  cancel(): void;
  /** Settles when the page is as it was, or shows what was read. */
  ended: Promise<void>;
}

/** A file's content as an object. */
export interface Content {
  name: string;
  content: Blob;
  converted: boolean;
  /** Files that it may need. */
  beside?: readonly BesideFile[];
}

/** A file as a person gave it. */
export type Given = Omit<Content, 'converted'>;

export interface DisplayMeshes {
  moving: DisplayMesh;
  still: DisplayMesh;
}

/** An item where it lies, to be drawn. */
export interface PlacedItem {
  meshes: DisplayMeshes;
  /** Column-major 4 x 4. */
  placement: readonly number[];
}

/** From an input to its new foams. */
export interface Timing {
  /** When the change was made, as performance.now() tells. */
  input: number;
  /** Until the foams were back on the page. */
  answer_ms: number;
  library_ms: number;
}

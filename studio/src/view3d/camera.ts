import type {Triple} from '../design/design';
import type {Side} from './stage';

/** What other parts of the page may ask of the 3D view. */
export interface CameraMoves {
  view(side: Side): void;
  all(): void;
  /** `layer`: of the item that the place belongs to, which is drawn elsewhere while the foams are open. */
  lookAt(place: Triple, layer?: number): void;
  /** What is seen, as it can be kept. */
  picture(): HTMLCanvasElement | null;
}

/** How the world is turned to who looks, as CSS has it: x to the right, y downward, z to the reader. */
export type Turned = string;

/** The view comes and goes; who asks while there is none is not heard. */
export class Camera implements CameraMoves {
  #moves: CameraMoves | null = null;
  #followers = new Set<(turned: Turned) => void>();
  attach(moves: CameraMoves | null) {
    this.#moves = moves;
  }
  view = (side: Side) => this.#moves?.view(side);
  all = () => this.#moves?.all();
  lookAt = (place: Triple, layer?: number) => this.#moves?.lookAt(place, layer);
  picture = () => this.#moves?.picture() ?? null;

  /** Tells of each picture how it is turned, until what is returned is called. */
  follow(follower: (turned: Turned) => void): () => void {
    this.#followers.add(follower);
    return () => this.#followers.delete(follower);
  }

  /** `inverse`: from the world to the camera, column-major 4 x 4. */
  turned(inverse: readonly number[]) {
    const turned = turnedAs(inverse);
    for (const follower of this.#followers) follower(turned);
  }
}

/** Without the camera's place, and with y downward. */
export function turnedAs(inverse: readonly number[]): Turned {
  const turned = inverse.map((value, i) => {
    const [column, row] = [i >> 2, i & 3];
    if (column === 3 || row === 3) return i === 15 ? 1 : 0;
    return Math.round((row === 1 !== (column === 1) ? -value : value) * 1e4) / 1e4 + 0;
  });
  return `matrix3d(${turned.join()})`;
}

import type {Triple} from '../design/design';
import type {Side} from './stage';

/** What other parts of the page may ask of the 3D view. */
export interface CameraMoves {
  view(side: Side): void;
  all(): void;
  /** `layer`: of the item that the place belongs to, which is drawn elsewhere while the foams are open. */
  lookAt(place: Triple, layer?: number): void;
}

/** The view comes and goes; who asks while there is none is not heard. */
export class Camera implements CameraMoves {
  #moves: CameraMoves | null = null;
  attach(moves: CameraMoves | null) {
    this.#moves = moves;
  }
  view = (side: Side) => this.#moves?.view(side);
  all = () => this.#moves?.all();
  lookAt = (place: Triple, layer?: number) => this.#moves?.lookAt(place, layer);
}

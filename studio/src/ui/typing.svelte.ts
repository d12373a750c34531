import type {Pair} from '../words/words';

/** What is being typed into a field, which need not be a number yet, is shown until the field is left, or until the
 *  design is changed by anything but this typing: undo, a button, a search. */
class Typing {
  /** The change of the design that was the last. */
  change = $state(0);

  /** Hears why a number was not taken; null: the next one was. */
  onrefusal: (why: Pair | null) => void = () => {};

  designChanged() {
    this.change++;
  }
}

export const typing = new Typing();

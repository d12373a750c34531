import {remember, remembered} from '../words/remembered';

export type Theme = 'system' | 'light' | 'dark';

const KEY = 'snug-theme';
const FINE_TURN = 'snug-fine-turn';

class Preferences {
  theme: Theme = $state(stored());
  #system = matchMedia('(prefers-color-scheme: dark)');
  #systemDark = $state(this.#system.matches);
  dark = $derived(this.theme === 'system' ? this.#systemDark : this.theme === 'dark');

  /** The three angles stand open until they are put away. */
  fineTurn = $state(remembered(FINE_TURN) !== 'closed');

  constructor() {
    this.#system.addEventListener('change', ({matches}) => (this.#systemDark = matches));
  }

  choose(theme: Theme) {
    this.theme = theme;
    remember(KEY, theme);
  }

  openFineTurn(open: boolean) {
    this.fineTurn = open;
    remember(FINE_TURN, open ? 'open' : 'closed');
  }
}

function stored(): Theme {
  const value = remembered(KEY);
  return value === 'light' || value === 'dark' ? value : 'system';
}

export const preferences = new Preferences();

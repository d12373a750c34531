import type {PanelName} from '../design/panel_fields';
import {remember, remembered} from '../words/remembered';
import {level} from './level';

export type Theme = 'system' | 'light' | 'dark';

const KEY = 'snug-theme';
const MORE = 'snug-more';
const EVERYTHING = 'snug-everything';

class Preferences {
  theme: Theme = $state(stored());
  #system = matchMedia('(prefers-color-scheme: dark)');
  #systemDark = $state(this.#system.matches);
  dark = $derived(this.theme === 'system' ? this.#systemDark : this.theme === 'dark');

  #more: readonly string[] = $state.raw((remembered(MORE) ?? '').split(' '));
  /** Every field of every step at once, for those who want it so. */
  wantsAll = $state(remembered(EVERYTHING) === 'yes');
  showsAll = $derived(level === 'all' || this.wantsAll);

  constructor() {
    this.#system.addEventListener('change', ({matches}) => (this.#systemDark = matches));
  }

  choose(theme: Theme) {
    this.theme = theme;
    remember(KEY, theme);
  }

  showAll(all: boolean) {
    this.wantsAll = all;
    remember(EVERYTHING, all ? 'yes' : 'no');
  }

  /** Whether the More of a panel is open. */
  opens(panel: PanelName): boolean {
    return this.showsAll || this.#more.includes(panel);
  }

  openMore(panel: PanelName, open: boolean) {
    const others = this.#more.filter((name) => name !== panel && name !== '');
    this.#more = open ? [...others, panel] : others;
    remember(MORE, this.#more.join(' '));
  }
}

function stored(): Theme {
  const value = remembered(KEY);
  return value === 'light' || value === 'dark' ? value : 'system';
}

export const preferences = new Preferences();

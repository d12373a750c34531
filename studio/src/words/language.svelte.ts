import {ofLibrary} from './figures';
import {remember, remembered} from './remembered';
import {en, ja, type Texts} from './texts';
import type {Pair} from './words';

const KEY = 'snug-language';
export const LANGUAGES: readonly Texts[] = [en, ja];

class Language {
  code = $state(remembered(KEY) ?? (navigator.language.startsWith('ja') ? 'ja' : 'en'));
  text: Texts = $derived(LANGUAGES.find(({code}) => code === this.code) ?? en);

  /** A sentence that is there in both, such as the library's. */
  of(pair: Pair): string {
    return ofLibrary(pair[this.code === 'ja' ? 1 : 0]);
  }

  /** For dates: the browser's own way of this language, such as en-GB. */
  get locale(): string {
    return navigator.languages?.find((locale) => locale.startsWith(this.code)) ?? this.code;
  }

  choose(code: string) {
    this.code = code;
    remember(KEY, code);
  }
}

export const language = new Language();

import {ofLibrary} from './figures';
import {withFieldNames, type FlagNames} from './flags';
import {remember, remembered} from './remembered';
import {en, ja, type Texts} from './texts';
import type {Pair} from './words';

const KEY = 'snug-language';
export const LANGUAGES: readonly Texts[] = [en, ja];

class Language {
  code = $state(remembered(KEY) ?? (navigator.language.startsWith('ja') ? 'ja' : 'en'));
  text: Texts = $derived(LANGUAGES.find(({code}) => code === this.code) ?? en);

  /** By the code of a language; none before the page knows its fields. */
  #flags: Readonly<Record<string, FlagNames>> = $state.raw({});

  /** A sentence that is there in both, such as the library's. */
  of(pair: Pair): string {
    return this.ofLibrary(pair[this.code === 'ja' ? 1 : 0]);
  }

  /** A sentence that the library has in this language alone. */
  ofLibrary(sentence: string): string {
    const names = this.#flags[this.code];
    return ofLibrary(names ? withFieldNames(sentence, names, this.text.fieldsOf.quoted) : sentence);
  }

  /** What flags of the command line are called from now on, by the code of a language. */
  callFlags(names: Readonly<Record<string, FlagNames>>) {
    this.#flags = names;
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

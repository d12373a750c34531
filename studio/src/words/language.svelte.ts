import {en, ja, type Texts} from './texts';

const KEY = 'snug-language';
export const LANGUAGES: readonly Texts[] = [en, ja];

class Language {
  code = $state(localStorage.getItem(KEY) ?? (navigator.language.startsWith('ja') ? 'ja' : 'en'));
  text: Texts = $derived(LANGUAGES.find(({code}) => code === this.code) ?? en);

  choose(code: string) {
    this.code = code;
    localStorage.setItem(KEY, code);
  }
}

export const language = new Language();

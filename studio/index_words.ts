import type {Plugin} from 'vite';
import {noScript, waiting} from './src/words/before_start.ts';
import type {Pair} from './src/words/words.ts';

/** Puts what index.html says before the program runs into it, in both languages. `waits`: it may be opened where the program
 *  cannot run. */
export function indexWords(waits: boolean): Plugin {
  const texts = {waiting: waits ? inBoth(waiting) : '', noScript: inBoth(noScript)};
  return {
    name: 'snug-index-words',
    transformIndexHtml: (html) =>
      Object.entries(texts).reduce((whole, [name, text]) => whole.replace(`<!-- ${name} -->`, text), html),
  };
}

function inBoth([en, ja]: Pair): string {
  return `<p lang="en">${en}</p><p lang="ja">${ja}</p>`;
}

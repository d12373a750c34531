import {fieldsIn, heldBy, isOption, PANELS, setBy, waysOf, type FieldName, type PanelName, type Step} from '../design/panel_fields';
import type {OptionPath, Schema} from '../design/options';
import type {Texts} from '../words/texts';
import {fieldWords} from './field_words';

// Finding a field by any word: of its name, of what is said of it, in either language, or its flag on the command line.

export interface Place {
  field: FieldName;
  /** The field that it stands in; often itself. */
  within: FieldName;
  panel: PanelName;
  step: Step;
  /** It is there in these ways of working alone. */
  ways: readonly string[] | null;
}
interface Entry {
  place: Place;
  name: string;
  all: string;
}

/** Every field with all its words. */
export function fieldIndex(rows: Schema, texts: readonly Texts[]): Entry[] {
  return places(rows).map((place) => {
    const words = texts.map((text) => fieldWords(place.field, text, rows));
    return {
      place,
      name: folded(words.map(({name}) => name).join(' ')),
      all: folded([...words.flatMap(({name, tip}) => [name, tip]), ...setBy(place.field).flatMap((path) => tableWords(path, rows))].join(' ')),
    };
  });
}

/** Every field, in the order of the page. */
export function places(rows: Schema): Place[] {
  return (Object.keys(PANELS) as PanelName[]).flatMap((panel) => {
    const {usual, more} = fieldsIn(panel, rows);
    return [...usual, ...more].flatMap((within) => [within, ...heldBy(within)].map((field) => placeOf(field, within, panel, rows)));
  });
}

function placeOf(field: FieldName, within: FieldName, panel: PanelName, rows: Schema): Place {
  return {field, within, panel, step: PANELS[panel].step, ways: waysOf(field, rows['workshop.for'].words ?? [])};
}

/** As the library, the command line and a project call it. */
function tableWords(path: OptionPath, rows: Schema): string[] {
  const {label, help, flag} = rows[path];
  return [path, path.replaceAll(/[._]/g, ' '), ...label, ...(help ?? []), flag ?? ''];
}

/** Those that have every word of what was typed, first those that are called so. */
export function findFields(index: readonly Entry[], typed: string, most = 12): Place[] {
  const words = folded(typed).split(/\s+/).filter(Boolean);
  if (words.length === 0) return [];
  const rank = ({name, place}: Entry) => {
    if (words.every((word) => name.startsWith(word) || name.includes(` ${word}`))) return 0;
    if (words.every((word) => name.includes(word))) return 1;
    return isOption(place.field) && words.every((word) => place.field.includes(word)) ? 2 : 3;
  };
  const found = index.filter(({all}) => words.every((word) => all.includes(word)));
  return found.sort((a, b) => rank(a) - rank(b)).slice(0, most).map(({place}) => place);
}

/** Wide and narrow letters, large and small ones are the same. */
function folded(text: string): string {
  return text.normalize('NFKC').toLowerCase();
}

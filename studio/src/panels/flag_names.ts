import {setBy, type FieldName} from '../design/panel_fields';
import {fieldName, type OptionPath, type Schema} from '../design/options';
import type {FlagNames} from '../words/flags';
import type {Texts} from '../words/texts';
import {fieldWords} from './field_words';
import {places} from './find_fields';

// What the page calls the flags of the command line, so that sentences of the library speak of its fields.

/** Of commands, or of options that a field sets beside another one. */
const TOOLS: Readonly<Record<string, FieldName>> = {
  '--arrange': 'arrange',
  '--optimize': 'optimize',
  '--fit-case': 'smallest',
  '--keep-off': 'zones',
  '--longest': 'length',
};

export function flagNames(rows: Schema, text: Texts): FlagNames {
  const fields = places(rows).map(({field}) => field);
  const names = new Map(Object.entries(TOOLS).map(([flag, field]) => [flag, fieldWords(field, text, rows).name]));
  for (const [flag, paths] of optionsByFlag(rows)) {
    if (!names.has(flag)) names.set(flag, nameOf(paths, fields, text, rows));
    for (const [word, name] of Object.entries(wordsOf(paths, text))) names.set(`${flag} ${word}`, text.fieldsOf.chosen(names.get(flag)!, name));
  }
  // One switch of the page.
  return names.set('--blocks auto', text.foam.fitted);
}

function optionsByFlag(rows: Schema): Map<string, OptionPath[]> {
  const all = new Map<string, OptionPath[]>();
  for (const path of Object.keys(rows) as OptionPath[]) {
    const {flag} = rows[path];
    if (flag) all.set(flag, [...(all.get(flag) ?? []), path]);
  }
  return all;
}

/** Several options of one flag are a group with a field of its own; what has no field is called as in the table. */
function nameOf(paths: readonly OptionPath[], fields: readonly FieldName[], text: Texts, rows: Schema): string {
  const group = fields.find((field) => field === paths[0]!.slice(0, paths[0]!.lastIndexOf('.')));
  const own = fields.find((field) => setBy(field).some((path) => paths.includes(path)));
  const field = paths.length > 1 ? (group ?? own) : (own ?? group);
  return field ? fieldWords(field, text, rows).name : fieldName(rows[paths[0]!])[text.code === 'ja' ? 1 : 0];
}

function wordsOf(paths: readonly OptionPath[], {fields, workshop, foam}: Texts): Readonly<Record<string, string>> {
  if (paths.includes('workshop.for')) return workshop.works;
  if (paths.includes('space.preset')) return foam.presets;
  return Object.assign({}, ...paths.map((path) => fields[path]?.words ?? {})) as Record<string, string>;
}

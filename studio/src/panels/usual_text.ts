import {objective} from '../design/edit';
import type {Design} from '../design/design';
import type {OptionPath} from '../design/options';
import {rowPath} from '../design/usual';
import type {Studio} from '../state/studio.svelte';
import {plain, symbol} from '../words/figures';
import type {Texts} from '../words/texts';

/** What an option comes to where nobody chose it, in words. */
export function usualText(studio: Studio, path: OptionPath, text: Texts): string {
  const t = text.fieldsOf;
  const row = studio.options.rows[rowPath(path)];
  const usual = path === 'space.wall_mm' ? (studio.options.usual(path) ?? studio.options.fittedWall) : studio.options.usual(path);
  if (path === 'space.preset') return text.foam.presets[String(usual)] ?? String(usual);
  if (path === 'search.weights') return text.placement.objectives[objective({search: {weights: usual}} as Design)] ?? '';
  if (usual === 'auto' && row.kind !== 'word') return t.automatic;
  if (row.kind === 'switch') return usual ? t.on : t.off;
  if (path === 'protection.foam') return t.none;
  if (row.kind === 'group' || path === 'case.inside_mm' || path === 'space.open') return t.off;
  if (row.words) return text.fields[rowPath(path)]?.words?.[String(usual ?? 'none')] ?? (usual === null ? t.none : String(usual));
  const numbers = [usual].flat().filter((one): one is number => typeof one === 'number');
  if (numbers.length > 0) return `${numbers.map((one) => plain(one, 3)).join(', ')} ${symbol(row.unit)}`.trim();
  return typeof usual === 'string' && usual !== '' ? usual : t.none;
}

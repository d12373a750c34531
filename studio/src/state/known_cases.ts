import type {Triple} from '../design/design';
import type {CaseRanking, RankedCase} from '../engine/api';

// Known cases as one looks for them by name, and the foam that each has room for.

/** "Peli 1450": many makers have numbers alone for names. */
export function calledCase({name, maker}: Pick<RankedCase, 'name' | 'maker'>): string {
  return maker ? `${maker} ${name}` : name;
}

/** "hard case"; the library may know more kinds than the page. */
export function kindOfCase({kind}: Pick<RankedCase, 'kind'>, kinds: Readonly<Record<string, string>>): string {
  return kinds[kind] ?? kind;
}

/** By every word that any case has; one that none has, such as a maker's whom the list does not know, counts for nothing. */
export function findCases(cases: readonly RankedCase[], typed: string, kinds: Record<string, string>): RankedCase[] {
  const textOf = ({name, maker = '', kind}: RankedCase) => `${maker} ${name} ${kind} ${kinds[kind] ?? ''}`.toLowerCase();
  const words = typed.toLowerCase().split(/\s+/).filter((word) => word !== '');
  const known = words.filter((word) => /\d/.test(word) || cases.some((one) => textOf(one).includes(word)));
  if (words.length > 0 && known.length === 0) return [];
  return cases.filter((one) => known.every((word) => textOf(one).includes(word)));
}

/** The thickest foam on all sides with which a case holds it. `ranking`: without walls. `stands`: its height stays its height. */
export function mostWall({inside_mm}: RankedCase, {leastInside}: CaseRanking, stands: boolean): number {
  const room = (lying: Triple) => Math.min(...lying.map((mm, i) => (inside_mm[i]! - mm) / 2));
  const [h, w, l] = leastInside;
  const standing: Triple[] = [[h, w, l], [h, l, w]];
  const others: Triple[] = [[w, h, l], [w, l, h], [l, h, w], [l, w, h]];
  return Math.floor(Math.max(0, ...(stands ? standing : [...standing, ...others]).map(room)));
}

import type {Design} from '../design/design';
import type {PlanWishes, Proposal} from '../engine/plan';
import {kg, money, plain, shock} from '../words/figures';
import type {Texts} from '../words/texts';

// Proposals as they stand side by side.

export interface Column {
  /** What it is best in. */
  kinds: readonly Proposal['kind'][];
  proposal: Proposal;
}

/** What is best in two ways stands once. */
export function columnsOf(proposals: readonly Proposal[]): Column[] {
  const columns: {kinds: Proposal['kind'][]; proposal: Proposal; text: string}[] = [];
  for (const proposal of proposals) {
    const text = JSON.stringify(proposal.design);
    const same = columns.find((column) => column.text === text);
    if (same) same.kinds.push(proposal.kind);
    else columns.push({kinds: [proposal.kind], proposal, text});
  }
  return columns;
}

/** What it is best in. Where prices are not known, the cheapest is what a carrier charges least for. */
export function titleOf(kinds: Column['kinds'], proposals: readonly Proposal[], t: Texts['first']): string {
  return kinds.map((kind) => (kind === 'cheapest' && !isPriced(proposals) ? t.lightest : t.kinds[kind])).join(t.and);
}

/** As the library compares them: by money only where it knows all prices. */
function isPriced(proposals: readonly Proposal[]): boolean {
  return proposals.every(({cost}) => cost !== null);
}

export type Look = 'good' | 'danger' | 'unknown';

/** What it meets in a drop of what it bears, or why that is not known. */
export function shockOf({worst_g, asked_g, why_none, meets, design}: Proposal, carrier: PlanWishes['carrier'], t: Texts['first']): {look: Look; text: string} {
  if (carrier === 'store') return {look: 'unknown', text: t.shock.store};
  if (worst_g !== null && asked_g !== null)
    return meets === 'yes'
      ? {look: 'good', text: t.shock.meets(shock(worst_g), shock(asked_g))}
      : {look: 'danger', text: t.shock.fails(shock(worst_g), shock(asked_g))};
  if (why_none === 'bottoms') return {look: 'danger', text: t.shock.bottoms};
  if (why_none === 'thin' || why_none === 'unsettled') return {look: meets === 'no' ? 'danger' : 'unknown', text: t.shock.untold};
  if (worst_g !== null) return {look: 'unknown', text: t.shock.unasked(shock(worst_g))};
  return {look: 'unknown', text: lacksMass(design) ? t.shock.noMass : t.shock.noData};
}

function lacksMass({items, workshop}: Design): boolean {
  return items.some(({mass_kg}) => (mass_kg ?? workshop.mass_kg) === null);
}

/** What is to be said of the weight in `costOf`, where it is one. */
export function onWeight({cost}: Proposal, kinds: Column['kinds'], t: Texts['first']): string[] {
  if (cost !== null) return [];
  return kinds.includes('cheapest') ? [t.leastBilled, t.billedWhat] : [t.billedWhat];
}

export function costOf({cost, currency, billed_kg}: Proposal, t: Texts['first']): string {
  return cost === null ? t.billed(kg(billed_kg)) : money(cost, currency);
}

/** Hours, to a tenth; below one in minutes. */
export function workOf(pieces: number, seconds: number, t: Texts['first']): string {
  const minutes = (pieces * seconds) / 60;
  return minutes < 60 ? t.minutes(Math.max(1, Math.round(minutes))) : t.hours(plain(minutes / 60, 1));
}

/** The gravest two kinds; of the shock the worst is told already. */
export function worries({findings, meets}: Proposal): Proposal['findings'] {
  const grave = findings.filter(({severity, code}) => severity !== 'note' && !(meets === 'no' && code === 'shock'));
  return grave.filter(({code}, i) => grave.findIndex((other) => other.code === code) === i).slice(0, 2);
}

/** Nothing to worry about, and drops were judged, or it is never dropped. */
export function isFine(proposal: Proposal, carrier: PlanWishes['carrier'], t: Texts['first']): boolean {
  return worries(proposal).length === 0 && (carrier === 'store' || shockOf(proposal, carrier, t).look === 'good');
}

/** Of a preview what stands above its maps, which are too small to be read here. */
export function pictureOf(svg: string): string {
  const legend = /<g id="legend"([\s\S]*?)(?=<g id="|$)/.exec(svg)?.[1] ?? '';
  const lines = [...legend.matchAll(/ y="([\d.]+)"/g)].map(([, y]) => Number(y));
  if (lines.length < 2) return svg;
  const LINE = 7;
  return svg.replace(/ width="[^"]*" height="[^"]*" viewBox="0 0 ([\d.]+) [\d.]+"/, (_, width: string) => ` viewBox="0 0 ${width} ${Math.max(...lines) - LINE}"`);
}

import type {Finding} from '../engine/api';
import type {Texts} from '../words/texts';

export type Severity = Finding['severity'];

/** What a finding is headed by: how grave it is, and its short name where it has one. Never its code, which people do
 *  not know. */
export function findingTitle({severity, code}: Finding, t: Texts['check']): string {
  const name = t.codes[code];
  return name ? t.titled(t.severities[severity], name) : t.severities[severity];
}

const GRAVITY: readonly Severity[] = ['danger', 'warning', 'note'];

/** Those that are equally grave stay in their order. */
export function gravestFirst(findings: readonly Finding[]): Finding[] {
  return [...findings].sort((a, b) => GRAVITY.indexOf(a.severity) - GRAVITY.indexOf(b.severity));
}

export function countOf(findings: readonly Finding[], severity: Severity): number {
  return findings.filter((finding) => finding.severity === severity).length;
}

/** The gravest that asks for something to be done. */
export function worst(findings: readonly Finding[]): 'danger' | 'warning' | null {
  if (countOf(findings, 'danger') > 0) return 'danger';
  return countOf(findings, 'warning') > 0 ? 'warning' : null;
}

/** "1 danger, 2 warnings"; empty where there is nothing to do. */
export function counted(findings: readonly Finding[], t: Texts['check']): string {
  return (['danger', 'warning'] as const)
    .map((severity) => ({severity, n: countOf(findings, severity)}))
    .filter(({n}) => n > 0)
    .map(({severity, n}) => t.counts[severity](n))
    .join(t.between);
}

/** Their titles, each once, and how often where that is more. */
export function titles(findings: readonly Finding[], t: Texts['check']): string[] {
  const often = new Map<string, number>();
  for (const finding of findings) {
    const title = findingTitle(finding, t);
    often.set(title, (often.get(title) ?? 0) + 1);
  }
  return [...often].map(([title, n]) => (n > 1 ? `${title} (${n})` : title));
}

/** The items between which there is too little foam, by their numbers. */
export function tooNear(findings: readonly Finding[]): ReadonlySet<number> {
  return new Set(findings.flatMap(({code, items}) => (/^items_(near|overlap)/.test(code) ? (items ?? []) : [])));
}

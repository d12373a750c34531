/** A foam as a person types it. */
export interface TypedFoam {
  name: string;
  title: string;
  source: string;
  /** kg/m3; empty where it is not known. */
  density: string;
  /** Points of the stress-strain curve, or of a cushion curve. */
  kind: 'curve' | 'points';
  /** A point a line, its numbers apart by spaces, commas or semicolons. */
  rows: string;
}

/** A foams.json of one foam, for the library to understand or refuse. What is no number is left as it was typed. */
export function foamEntry({name, title, source, density, kind, rows}: TypedFoam): string {
  const points = rows
    .split('\n')
    .map((row) => row.split(/[\s,;]+/).filter((word) => word !== ''))
    .filter((row) => row.length > 0);
  const entry = {
    name,
    ...(title ? {title} : {}),
    ...(density.trim() ? {density_kg_m3: numberOf(density.trim())} : {}),
    [kind]: points.map((row) => row.map(numberOf)),
    source,
  };
  return JSON.stringify([entry]);
}

function numberOf(word: string): number | string {
  const value = Number(word);
  return Number.isFinite(value) ? value : word;
}

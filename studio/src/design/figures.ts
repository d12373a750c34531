import type {Triple} from './design';

// Numbers as people read them. A thin space between a number and its unit would be lost on screen readers.

export const mm = (value: number): string => `${tidy(value)} mm`;
export const size = (value: readonly number[]): string => `${value.map((side) => tidy(side)).join(' × ')} mm`;
export const litres = (mm3: number): string => `${(mm3 / 1e6).toFixed(mm3 < 1e7 ? 2 : 1)} L`;
/** A share as people read it: "98.2 %"; what is there is never "0 %". */
export const percent = (share: number): string => `${share > 0 && share < 0.0001 ? '< 0.01' : tidy(share * 100)} %`;
export const cm3 = (mm3: number): string => `${tidy(mm3 / 1000)} cm³`;
export const cm2 = (mm2: number): string => `${tidy(mm2 / 100)} cm²`;
export const kpa = (value: number): string => `${tidy(value)} kPa`;
export const bytes = (value: number): string =>
  value < 1e6 ? `${tidy(Math.max(value, 100) / 1e3)} kB` : `${tidy(value / 1e6)} MB`;
export const count = (value: number): string => Math.round(value).toLocaleString('en').replaceAll(',', ' ');
export const ratio = (value: number): string => value.toFixed(4);

export function spaceSize(blocks: Triple, block_mm: Triple): Triple {
  return blocks.map((n, i) => n * (block_mm[i] ?? 0)) as Triple;
}

/** Three digits that mean something. */
function tidy(value: number): string {
  const digits = Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : 2;
  return String(Number(value.toFixed(digits)));
}

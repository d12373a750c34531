// Numbers as people read them, in the one style of the page: a comma between thousands, a point before decimals, a space
// and the unit behind, × between lengths. A thin space between a number and its unit would be lost on screen readers.
// Lengths have no comma, as in the fields where they are typed.

export const mm = (value: number): string => `${tidy(value)} mm`;
/** As a tape has it. */
export const measured = (value: number): string => `${plain(value, 1)} mm`;
export const size = (value: readonly number[]): string => `${value.map(tidy).join(' × ')} mm`;
/** A point by its three numbers. */
export const place = (value: readonly number[]): string => `${value.map(tidy).join(', ')} mm`;
export const litres = (mm3: number): string => `${grouped(mm3 / 1e6, mm3 < 1e7 ? 2 : 1)} L`;
/** A share as people read it: "98.2 %"; what is there is never "0 %". */
export const percent = (share: number): string => `${share > 0 && share < 0.0001 ? '< 0.01' : tidy(share * 100)} %`;
export const cm3 = (mm3: number): string => `${amount(mm3 / 1000)} cm³`;
export const cm2 = (mm2: number): string => `${amount(mm2 / 100)} cm²`;
export const kpa = (value: number): string => `${amount(value)} kPa`;
export const kg = (value: number): string => `${amount(value)} kg`;
export const force = (newtons: number): string => (newtons >= 1000 ? `${amount(newtons / 1000)} kN` : `${amount(newtons)} N`);
/** A shock, as a multiple of gravity. */
export const shock = (g: number): string => `${amount(g)} G`;
/** Of a currency by its code; none where it is not known. */
export const money = (value: number, currency: string | null): string => [value.toFixed(2), currency ?? ''].join(' ').trim();
export const ms = (value: number): string => `${grouped(value, 0)} ms`;
export const bytes = (value: number): string =>
  value < 1e6 ? `${amount(Math.max(value, 100) / 1e3)} kB` : `${amount(value / 1e6)} MB`;
export const count = (value: number): string => grouped(value, 0);
export const ratio = (value: number): string => value.toFixed(4);
/** As a field has it: no more digits than there are, and none behind the last one that counts. */
export const plain = (value: number, digits: number): string => String(Number(value.toFixed(digits)));

/** A unit of the table of options as it stands behind a number. */
export const symbol = (unit = ''): string => ({degrees: '°', newtons: 'N'})[unit] ?? unit;

/** A sentence of the library, which writes for terminals, in the page's style. */
export function ofLibrary(sentence: string): string {
  return sentence.replace(/(\d) x (?=\d)/g, '$1 × ').replace(/\b([cm]m)([23])\b/g, (_, unit: string, power: string) => unit + (power === '2' ? '²' : '³'));
}

/** Three digits that mean something. */
function tidy(value: number): string {
  return plain(value, digitsOf(value));
}

function amount(value: number): string {
  return grouped(value, digitsOf(value));
}

function digitsOf(value: number): number {
  return Math.abs(value) >= 100 ? 0 : Math.abs(value) >= 10 ? 1 : 2;
}

function grouped(value: number, digits: number): string {
  return Number(value.toFixed(digits)).toLocaleString('en', {maximumFractionDigits: digits});
}

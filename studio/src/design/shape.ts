import type {Triple} from './design';

// An object from measurements, as the library reads it from a .shape file (snug/formats/shape_text.h). mm.

export const KINDS = ['box', 'cylinder', 'cone', 'ball'] as const;
export type SolidKind = (typeof KINDS)[number];

export interface Solid {
  kind: SolidKind;
  /** Of a box along x, y and z; of a cylinder its diameter and length, of a cone both diameters and its length, of a ball
   *  its diameter. */
  size: readonly number[];
  /** Of a box’s edges. */
  radius: number;
  /** Where the axis of a cylinder or cone points to. */
  along: 'x' | 'y' | 'z';
  /** Degrees, as the library turns it. */
  turn: Triple;
  /** Where its middle stands. */
  at: Triple;
}

export interface Shape {
  solids: readonly Solid[];
  /** How far the measurements may be off. */
  error_mm: number;
}

const NOWHERE: Triple = [0, 0, 0];
const ERROR = /#\s*measured to within ([\d.]+) mm/;

const box = (size: Triple): Solid => ({kind: 'box', size, radius: 0, along: 'z', turn: NOWHERE, at: NOWHERE});
export const FIRST_SHAPE: Shape = {solids: [box([150, 100, 60])], error_mm: 1};

/** Of the size that the last one has, on top of it, where it is seen. */
export function nextSolid(kind: SolidKind, {solids}: Shape): Solid {
  const last = solids.at(-1) ?? box([60, 60, 60]);
  const [wide = 40, , high = wide] = extent(last);
  const d = Math.max(1, Math.round(wide / 2));
  const size = {box: [d, d, d], cylinder: [d, d], cone: [d, Math.round(d / 2), d], ball: [d]}[kind];
  const at: Triple = [last.at[0], last.at[1], last.at[2] + high / 2 + d / 2];
  return {kind, size, radius: 0, along: 'z', turn: NOWHERE, at};
}

/** Along x, y and z, before it is turned. */
function extent({kind, size, along}: Solid): Triple {
  const [a = 0, b = a, c = b] = size;
  if (kind === 'box') return [a, b, c];
  if (kind === 'ball') return [a, a, a];
  const wide = kind === 'cone' ? Math.max(a, b) : a;
  const long = size.at(-1) ?? a;
  return ['x', 'y', 'z'].map((axis) => (axis === along ? long : wide)) as Triple;
}

const number = (value: number) => String(Number(value.toFixed(3)));
const three = (values: Triple) => values.map(number).join(',');
const isSome = (values: Triple) => values.some((value) => value !== 0);

function solidText({kind, size, radius, along, turn, at}: Solid): string {
  const words = [`${kind} ${size.map(number).join('x')}`];
  if (kind === 'box' && radius > 0) words.push(`r${number(radius)}`);
  if ((kind === 'cylinder' || kind === 'cone') && along !== 'z') words.push(`along ${along}`);
  if (isSome(turn)) words.push(`turn ${three(turn)}`);
  if (isSome(at)) words.push(`at ${three(at)}`);
  return words.join(' ');
}

/** With the likely error in a comment, which the library passes over. */
export function shapeText({solids, error_mm}: Shape): string {
  const error = error_mm > 0 ? [['# measured to within', number(error_mm), 'mm'].join(' ')] : [];
  return [...error, solids.map(solidText).join(' + '), ''].join('\n');
}

/** How far the measurements of such a text may be off; 0: it says nothing. */
export function errorIn(text: string): number {
  return Number(ERROR.exec(text)?.[1] ?? 0);
}

export function isShape(name: string): boolean {
  return /\.shape$/i.test(name);
}

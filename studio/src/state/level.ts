// How much of the page the address asks for: with `?level=all` every field is open and nothing is asked, not even a unit.

export type Level = 'all' | 'usual';

export function levelIn(address: string): Level {
  return new URLSearchParams(address).get('level') === 'all' ? 'all' : 'usual';
}

/** Of this page; there is no address without one. */
export const level: Level = levelIn(globalThis.location?.search ?? '');

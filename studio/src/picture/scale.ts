// Colours of the map, from few blocks cut (dark) to many (light): even steps of lightness, and legible without
// telling red from green. Corner colours of a blue-green-yellow scale.
const STOPS = [
  [38, 35, 84],
  [40, 82, 134],
  [36, 130, 142],
  [72, 175, 120],
  [168, 210, 76],
  [248, 231, 58],
] as const;

/** share: 0 for the least to 1 for the most. */
export function colourOf(share: number): [number, number, number] {
  const at = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const i = Math.min(Math.floor(at), STOPS.length - 2);
  const from = STOPS[i]!;
  const to = STOPS[i + 1]!;
  const mix = (channel: 0 | 1 | 2) => Math.round(from[channel] + (to[channel] - from[channel]) * (at - i));
  return [mix(0), mix(1), mix(2)];
}

export function css([red, green, blue]: readonly number[]): string {
  return `rgb(${red} ${green} ${blue})`;
}

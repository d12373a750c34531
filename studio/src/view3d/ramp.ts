import {Color} from 'three';

// Colours from little to much: lighter to darker through hues that people with every kind of colour vision tell apart.

const STOPS = ['#fdf3b4', '#fca650', '#d8456c', '#7b2382', '#2a0b54'].map((css) => new Color(css));

/** As the shader mixes them. `share`: 0 to 1. */
export function rampColour(share: number): Color {
  const at = Math.min(Math.max(share, 0), 1) * (STOPS.length - 1);
  const first = Math.min(Math.floor(at), STOPS.length - 2);
  return STOPS[first]!.clone().lerp(STOPS[first + 1]!, at - first);
}

/** The same as a legend has it. */
export function rampGradient(): string {
  const stops = Array.from({length: 17}, (_, i) => rampColour(i / 16).getStyle());
  return `linear-gradient(to right, ${stops.join(', ')})`;
}

const vec3 = ({r, g, b}: Color) => `vec3(${[r, g, b].map((value) => value.toFixed(4)).join(', ')})`;

/** vec3 muchRamp(float share) */
export const MUCH_RAMP = /* glsl */ `
vec3 muchRamp(float share) {
  float at = clamp(share, 0.0, 1.0) * ${(STOPS.length - 1).toFixed(1)};
  vec3 color = ${vec3(STOPS[0]!)};
${STOPS.slice(1)
  .map((stop, i) => `  color = mix(color, ${vec3(stop)}, clamp(at - ${i.toFixed(1)}, 0.0, 1.0));`)
  .join('\n')}
  return color;
}`;

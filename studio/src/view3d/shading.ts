import {Color, DoubleSide, ShaderMaterial, Vector3} from 'three';
import type {Look} from '../state/view.svelte';
import {FOAM_PRESSURE, ITEM_PRESSURE, pressureUniforms} from './pressure_paint';
import {ZONE_FRAGMENT, ZONE_VERTEX, zoneUniforms} from './zone_paint';

// One small shader for the object and the foams: two lights that go with the camera, block edges drawn from the
// design coordinates (so that they cost no triangles), the colours of the gaps, and of what is pressed.

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
varying vec3 vDesign;
varying vec3 vOwnNormal;
varying vec3 vNormal;
#ifdef FOAM
attribute float gap;
attribute float inner;
varying float vGap;
varying float vInner;
#else
${ZONE_VERTEX}
#endif
void main() {
  vDesign = position;
  vOwnNormal = normal;
  vNormal = normalMatrix * normal;
  #ifdef FOAM
  vGap = gap;
  vInner = inner;
  #else
  vPart = part;
  #endif
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <clipping_planes_vertex>
}`;

const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform vec3 color;
uniform vec3 edgeColor;
uniform float opacity;
uniform vec3 block;
uniform vec3 corner;
uniform float showGaps;
varying vec3 vDesign;
varying vec3 vOwnNormal;
varying vec3 vNormal;
#ifdef FOAM
varying float vGap;
varying float vInner;
vec3 ramp(float t) {
  vec3 near = vec3(0.16, 0.36, 0.78);
  vec3 middle = vec3(0.98, 0.85, 0.36);
  vec3 far = vec3(0.82, 0.14, 0.13);
  return t < 0.5 ? mix(near, middle, t * 2.0) : mix(middle, far, t * 2.0 - 1.0);
}
float edges() {
  vec3 cell = (vDesign - corner) / block;
  vec3 width = max(fwidth(cell), 1e-5);
  vec3 distance = abs(fract(cell + 0.5) - 0.5) / width;
  // Where blocks are smaller than a few pixels their edges would only darken the picture.
  vec3 faded = smoothstep(0.42, 0.18, width);
  vec3 line = (1.0 - smoothstep(0.35, 1.25, distance)) * faded * step(abs(vOwnNormal), vec3(0.5));
  // Fainter, the finer they are: many lines beside each other would be all that is seen.
  vec3 fine = mix(vec3(0.5), vec3(0.14), smoothstep(0.02, 0.14, width));
  line *= fine;
  return max(line.x, max(line.y, line.z));
}
/** Pores, about a millimetre wide: foam does not shine. */
float pores() {
  vec3 cell = floor(vDesign * 1.3 + vOwnNormal * 0.5);
  float each = fract(sin(dot(cell, vec3(12.9898, 78.233, 37.719))) * 43758.5453);
  // Smaller than a pixel they would flicker.
  return (each - 0.5) * smoothstep(1.2, 0.3, length(fwidth(vDesign)));
}
${FOAM_PRESSURE}
#else
${ZONE_FRAGMENT}
${ITEM_PRESSURE}
#endif
void main() {
  #include <clipping_planes_fragment>
  vec3 normal = normalize(vNormal) * (gl_FrontFacing ? 1.0 : FLIP);
  float key = max(dot(normal, normalize(vec3(-0.35, 0.8, 0.55))), 0.0);
  float fill = max(dot(normal, normalize(vec3(0.7, 0.1, 0.6))), 0.0);
  // From the sky more than from the ground, wherever one looks from.
  float sky = 0.5 + 0.5 * dot(normal, viewMatrix[1].xyz);
  vec3 shaded = color;
  #ifdef FOAM
  if (showGaps > 0.5 && vGap >= 0.0) shaded = ramp(min(vGap, 1.0));
  shaded = pressed(shaded);
  #else
  shaded = pressed(zoned(shaded));
  #endif
  #ifdef FOAM
  // Light goes some way into foam: its faces differ little.
  shaded *= 0.52 + 0.28 * key + 0.12 * fill + 0.14 * sky + 0.10 * pores();
  // Less of it comes into a cavity.
  shaded *= 1.0 - 0.16 * vInner;
  shaded = mix(shaded, edgeColor, edges());
  #else
  shaded *= 0.42 + 0.40 * key + 0.18 * fill + 0.14 * sky;
  #endif
  #if NUM_CLIPPING_PLANES > 0
  // What is cut open shows the inside of its far side: in one tone it looks filled.
  #ifdef FOAM
  if (dot(vNormal, vClipPosition) < 0.0) shaded = mix(color, vec3(1.0), 0.22);
  #else
  if (!gl_FrontFacing) shaded = color * 0.62;
  #endif
  #endif
  gl_FragColor = vec4(shaded, opacity);
  #include <colorspace_fragment>
}`;

/** Of what is seen through. */
export const GLASS = 0.28;

export interface Shading {
  material: ShaderMaterial;
  colour(face: string, edge: string, zone?: string): void;
  look(look: Look): void;
}

function shading(defines: Record<string, string>): Shading {
  const uniforms = {
    color: {value: new Color()},
    edgeColor: {value: new Color()},
    opacity: {value: 1},
    block: {value: new Vector3(1, 1, 1)},
    corner: {value: new Vector3()},
    showGaps: {value: 0},
    zoneColor: {value: new Color()},
    ...zoneUniforms(),
    ...pressureUniforms(),
  };
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms,
    defines,
    clipping: true,
    side: DoubleSide,
    polygonOffset: true,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
  return {
    material,
    colour(face, edge, zone = edge) {
      uniforms.color.value.set(face);
      uniforms.edgeColor.value.set(edge);
      uniforms.zoneColor.value.set(zone);
    },
    look(look) {
      const glass = look === 'glass';
      uniforms.opacity.value = glass ? GLASS : 1;
      material.transparent = glass;
      material.depthWrite = !glass;
    },
  };
}

/** Foam quads carry true normals for both windings, so nothing is flipped. */
export const foamShading = (): Shading => shading({FOAM: '', FLIP: '1.0'});
/** A scan's triangles may face either way; what is seen from behind is lit from behind. */
export const objectShading = (): Shading => shading({FLIP: '-1.0'});

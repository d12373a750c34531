import {DataTexture, FloatType, Matrix4, RGBAFormat, Vector2, Vector3, type IUniform, type ShaderMaterial} from 'three';
import type {PressureGrid} from './pressure_grid';
import {MUCH_RAMP} from './ramp';

// The colours of what is pressed: fragments look up the line that they lie on, so that faces may be as large as they are.

/** Of a texture; a grid may be longer in any direction than textures go. */
const WIDTH = 1024;

export function pressureUniforms(): Record<string, IUniform> {
  return {
    pressures: {value: null},
    pressAxis: {value: 0},
    /** Rows, columns and layers; 0: nothing is to be seen. */
    pressSize: {value: new Vector3()},
    pressFirst: {value: new Vector2()},
    pressCell: {value: new Vector2(1, 1)},
    pressPlaced: {value: new Matrix4()},
    pressSlack: {value: 0},
  };
}

/** Of one item, or of all foam. */
export class PressurePaint {
  #grid: PressureGrid | null = null;
  #texture: DataTexture | null = null;

  see(grid: PressureGrid | null) {
    if (grid === this.#grid) return;
    this.dispose();
    this.#grid = grid;
    if (!grid || grid.texels.length === 0) return;
    const height = Math.ceil(grid.texels.length / 4 / WIDTH);
    const texels = new Float32Array(WIDTH * height * 4);
    texels.set(grid.texels);
    this.#texture = new DataTexture(texels, WIDTH, height, RGBAFormat, FloatType);
    this.#texture.needsUpdate = true;
  }

  /** Before it is drawn. `placed`: where the item lies; `slack`: how far what is drawn of it may lie beside it, mm. */
  apply({uniforms}: ShaderMaterial, placed?: Matrix4, slack = 0) {
    const size = uniforms.pressSize!.value as Vector3;
    uniforms.pressures!.value = this.#texture;
    size.setScalar(0);
    if (!this.#grid || !this.#texture) return;
    const {axis, first, cell, rows, columns, layers} = this.#grid;
    size.set(rows, columns, layers);
    uniforms.pressAxis!.value = axis;
    (uniforms.pressFirst!.value as Vector2).set(...first);
    (uniforms.pressCell!.value as Vector2).set(...cell);
    if (placed) (uniforms.pressPlaced!.value as Matrix4).copy(placed);
    uniforms.pressSlack!.value = slack;
  }

  dispose() {
    this.#texture?.dispose();
    this.#texture = null;
  }
}

const LOOK_UP = /* glsl */ `
uniform sampler2D pressures;
uniform int pressAxis;
uniform vec3 pressSize;
uniform vec2 pressFirst;
uniform vec2 pressCell;
${MUCH_RAMP}
// How many rows and columns lie before a place.
vec2 cellsAt(vec3 place) {
  vec2 across = pressAxis == 0 ? place.yz : pressAxis == 1 ? place.zx : place.xy;
  return (across - pressFirst) / pressCell;
}
vec4 onLine(ivec2 at, int layer) {
  int i = (layer * int(pressSize.x) + at.x) * int(pressSize.y) + at.y;
  return texelFetch(pressures, ivec2(i % ${WIDTH}, i / ${WIDTH}), 0);
}
// What is not pressed: without a colour that could be taken for one of the legend's.
vec3 unpressed(vec3 color) {
  return mix(color, vec3(dot(color, vec3(0.3, 0.55, 0.15))), 0.85);
}`;

/** vec3 pressed(vec3 color), of an item. */
export const ITEM_PRESSURE = /* glsl */ `
uniform mat4 pressPlaced;
uniform float pressSlack;
${LOOK_UP}
vec3 pressed(vec3 color) {
  if (pressSize.z < 0.5) return color;
  vec3 place = (pressPlaced * vec4(vDesign, 1.0)).xyz;
  // Upright faces are not pressed, and where it is steep an end changes much within a cell.
  float facing = abs(normalize(mat3(pressPlaced) * vOwnNormal)[pressAxis]);
  if (facing < 0.1) return unpressed(color);
  float steep = sqrt(max(1.0 - facing * facing, 0.0)) / facing;
  float slack = 0.3 + pressSlack + steep * max(pressCell.x, pressCell.y);
  // Between the four nearest lines, those that end elsewhere left out.
  vec2 at = cellsAt(place) - 0.5;
  vec2 share = fract(at);
  float sum = 0.0, weight = 0.0;
  for (int i = 0; i < 4; i++) {
    ivec2 corner = ivec2(i / 2, i % 2);
    ivec2 cell = ivec2(floor(at)) + corner;
    if (min(cell.x, cell.y) < 0 || cell.x >= int(pressSize.x) || cell.y >= int(pressSize.y)) continue;
    vec4 ends = onLine(cell, 0);
    float pressure = abs(place[pressAxis] - ends.y) < slack ? ends.x : 0.0;
    if (abs(place[pressAxis] - ends.w) < slack) pressure = max(pressure, ends.z);
    vec2 near = mix(1.0 - share, share, vec2(corner));
    float counts = pressure > 0.0 ? near.x * near.y : 0.0;
    sum += counts * pressure;
    weight += counts;
  }
  return weight > 0.3 ? muchRamp(sum / weight) : unpressed(color);
}`;

/** The same of foam. */
export const FOAM_PRESSURE = /* glsl */ `
${LOOK_UP}
vec3 pressed(vec3 color) {
  if (pressSize.z < 0.5) return color;
  // Of the foam behind the face.
  vec3 place = vDesign - 0.01 * vOwnNormal * block;
  ivec2 at = ivec2(floor(cellsAt(place)));
  if (min(at.x, at.y) < 0 || at.x >= int(pressSize.x) || at.y >= int(pressSize.y)) return unpressed(color);
  float share = 0.0;
  for (int layer = 0; layer < int(pressSize.z); layer++) {
    vec4 column = onLine(at, layer);
    float along = place[pressAxis];
    if (along > column.y && along < column.z) share = max(share, column.x);
  }
  return share > 0.0 ? muchRamp(share) : unpressed(color);
}`;

import {Data3DTexture, DataTexture, LinearFilter, RedFormat, RGFormat, Vector2, Vector3, type IUniform, type ShaderMaterial} from 'three';
import type {Triple} from '../design/design';
import type {Zone} from '../design/options';
import {ballsOf} from '../design/zones';
import {zoneGrid} from './zone_grid';

// The colour of places to keep off: the object's fragments look up how deep they lie in balls, so that triangles may be
// as large as they are.

/** An item's places, as they are to be seen. */
export interface SeenZones {
  zones: readonly Zone[];
  chosen: number | null;
  /** Where its object's (0, 0, 0) lies in the coordinates of its file. */
  origin: Triple;
}

/** What a hand is about to paint, in the object's own mm. */
export interface PaintHint {
  brush: {at: Triple; radius_mm: number} | null;
  band: {axis: number; from: number; to: number} | null;
}

const ROW = 256;
const MOST_PARTS = ROW * ROW;

export function zoneUniforms(): Record<string, IUniform> {
  return {
    zoneDepths: {value: null},
    zoneLow: {value: new Vector3()},
    zoneExtent: {value: new Vector3()},
    zoneParts: {value: null},
    brushAt: {value: new Vector3()},
    brushRadius: {value: 0},
    bandAxis: {value: new Vector3()},
    band: {value: new Vector2()},
  };
}

/** Of one item. */
export class ZonePaint {
  #of = '';
  #zones: readonly Zone[] = [];
  #depths: Data3DTexture | null = null;
  #parts: DataTexture | null = null;
  readonly #low = new Vector3();
  readonly #extent = new Vector3();
  hint: PaintHint | null = null;

  see(seen: SeenZones | undefined) {
    const {zones, chosen, origin} = seen ?? {zones: [], chosen: null, origin: [0, 0, 0]};
    const of = JSON.stringify([chosen, origin]);
    if (zones === this.#zones && of === this.#of) return;
    [this.#zones, this.#of] = [zones, of];
    this.#fill(zones, chosen, origin as Triple);
    this.#mark(zones, chosen);
  }

  /** Before it is drawn: the material is that of all items. */
  apply({uniforms}: ShaderMaterial) {
    uniforms.zoneDepths!.value = this.#depths;
    uniforms.zoneParts!.value = this.#parts;
    (uniforms.zoneLow!.value as Vector3).copy(this.#low);
    (uniforms.zoneExtent!.value as Vector3).copy(this.#extent);
    const {brush, band} = this.hint ?? {brush: null, band: null};
    uniforms.brushRadius!.value = brush?.radius_mm ?? 0;
    if (brush) (uniforms.brushAt!.value as Vector3).fromArray(brush.at);
    (uniforms.bandAxis!.value as Vector3).setScalar(0);
    if (band) {
      (uniforms.bandAxis!.value as Vector3).setComponent(band.axis, 1);
      (uniforms.band!.value as Vector2).set(Math.min(band.from, band.to), Math.max(band.from, band.to));
    }
  }

  dispose() {
    this.#depths?.dispose();
    this.#parts?.dispose();
  }

  #fill(zones: readonly Zone[], chosen: number | null, origin: Triple) {
    const grid = zoneGrid(zones.map(ballsOf), chosen, origin);
    this.#depths?.dispose();
    this.#depths = null;
    this.#extent.setScalar(0);
    if (!grid) return;
    this.#low.fromArray(grid.low);
    this.#extent.fromArray(grid.extent);
    const texture = new Data3DTexture(grid.depths, ...grid.size);
    texture.format = RGFormat;
    texture.minFilter = texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    this.#depths = texture;
  }

  #mark(zones: readonly Zone[], chosen: number | null) {
    this.#parts?.dispose();
    this.#parts = null;
    const named = zones.map(({part = 0}) => (part < MOST_PARTS ? part : 0));
    const most = Math.max(0, ...named);
    if (most === 0) return;
    const marks = new Uint8Array(ROW * (Math.floor(most / ROW) + 1));
    named.forEach((part, i) => {
      if (part > 0) marks[part] = Math.max(marks[part]!, i === chosen ? 255 : 128);
    });
    this.#parts = new DataTexture(marks, ROW, marks.length / ROW, RedFormat);
    this.#parts.needsUpdate = true;
  }
}

export const ZONE_VERTEX = /* glsl */ `
attribute float part;
flat varying float vPart;
`;

/** Colours what lies in zones, and what a hand is about to paint. */
export const ZONE_FRAGMENT = /* glsl */ `
uniform sampler3D zoneDepths;
uniform sampler2D zoneParts;
uniform vec3 zoneLow;
uniform vec3 zoneExtent;
uniform vec3 zoneColor;
uniform vec3 brushAt;
uniform float brushRadius;
uniform vec3 bandAxis;
uniform vec2 band;
flat varying float vPart;
vec3 zoned(vec3 color) {
  vec2 inside = vec2(0.0);
  if (zoneExtent.x > 0.0) {
    vec3 at = (vDesign - zoneLow) / zoneExtent;
    vec2 depth = texture(zoneDepths, at).rg - 0.5;
    vec2 soft = max(fwidth(depth), 0.01);
    bool within = all(greaterThan(at, vec3(0.0))) && all(lessThan(at, vec3(1.0)));
    inside = within ? smoothstep(-soft, soft, depth) : inside;
  }
  int part = int(vPart + 0.5);
  float mark = texelFetch(zoneParts, ivec2(part % 256, part / 256), 0).r;
  inside = max(inside, vec2(step(0.25, mark), step(0.75, mark)));
  color = mix(color, zoneColor, max(0.5 * inside.r, 0.88 * inside.g));
  if (bandAxis.x + bandAxis.y + bandAxis.z > 0.0) {
    float height = dot(vDesign, bandAxis);
    color = mix(color, zoneColor, 0.4 * step(band.x, height) * step(height, band.y));
  }
  if (brushRadius > 0.0) {
    float away = distance(vDesign, brushAt);
    float rim = 1.0 - smoothstep(0.0, 1.6 * max(fwidth(away), 1e-5), abs(away - brushRadius));
    color = mix(color, zoneColor, 0.22 * step(away, brushRadius));
    color = mix(color, zoneColor * 0.45, rim);
  }
  return color;
}`;

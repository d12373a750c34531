import {Color, Group, Mesh, PlaneGeometry, ShaderMaterial, Vector2, type Plane, type Vector3} from 'three';
import type {Apart} from './apart';

/** How far a shadow goes beyond what stands there, as a share of its width. */
const SOFT = 0.16;
const DARK = 0.42;
/** So close to the ground that pieces beside each other share one, as a share of their height. */
const STANDS = 0.02;
/** Below the ground, as a share of the height of all: the foam's lower faces lie before it. */
const BELOW = 0.006;

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
varying vec2 vAt;
void main() {
  vAt = position.xy;
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * mvPosition;
  #include <clipping_planes_vertex>
}`;

/** A box's shadow, which is soft towards its edges: one factor along each, so that nothing has to be blurred. */
const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform vec3 color;
uniform vec2 soft;
varying vec2 vAt;
float lit(float at, float soft) {
  return 1.0 - smoothstep(0.5 - 2.0 * soft, 0.5, abs(at));
}
void main() {
  #include <clipping_planes_fragment>
  gl_FragColor = vec4(color, ${DARK} * lit(vAt.x, soft.x) * lit(vAt.y, soft.y));
}`;

type Shadow = Mesh<PlaneGeometry, ShaderMaterial>;

/** Soft shadows below what stands on the ground, so that it does not float. */
export class ContactShadow {
  readonly group = new Group();
  readonly #plane = new PlaneGeometry(1, 1);
  #shadows: Shadow[] = [];
  #planes: Plane[] | null = null;

  /** `corners`: of boxes, eight each. */
  place(corners: Apart['corners']) {
    const ground = Math.min(...corners.map(({x}) => x));
    const height = Math.max(...corners.map(({x}) => x)) - ground;
    const standing = boxes(corners).filter(({low}) => low <= ground + STANDS * height);
    while (this.#shadows.length < standing.length) this.#shadows.push(this.#join());
    this.#shadows.forEach((shadow, i) => {
      const box = standing[i];
      shadow.visible = box !== undefined;
      if (!box) return;
      const margin = SOFT * Math.min(box.size.x, box.size.y);
      const size = box.size.addScalar(2 * margin);
      shadow.position.set(ground - BELOW * height, box.middle.x, box.middle.y);
      // Its own x and y are z and y of the design; it is seen from above alone.
      shadow.scale.set(size.y, size.x, 1);
      (shadow.material.uniforms.soft!.value as Vector2).set(margin / size.y, margin / size.x);
    });
  }

  /** What lies behind these is seen, world coordinates. */
  clip(planes: Plane[] | null) {
    this.#planes = planes;
    for (const {material} of this.#shadows) material.clippingPlanes = planes;
  }

  #join(): Shadow {
    const uniforms = {color: {value: new Color('#000')}, soft: {value: new Vector2()}};
    const material = new ShaderMaterial({vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms, transparent: true, depthWrite: false, clipping: true});
    material.clippingPlanes = this.#planes;
    const shadow = new Mesh(this.#plane, material);
    shadow.rotation.set(0, Math.PI / 2, 0);
    shadow.renderOrder = -1;
    this.group.add(shadow);
    return shadow;
  }
}

/** Their lowest x, and middle and size along y and z. */
function boxes(corners: readonly Vector3[]) {
  return Array.from({length: Math.floor(corners.length / 8)}, (_, i) => {
    const own = corners.slice(8 * i, 8 * i + 8);
    const [low, high] = [(axis: 'x' | 'y' | 'z') => Math.min(...own.map((corner) => corner[axis])), (axis: 'y' | 'z') => Math.max(...own.map((corner) => corner[axis]))];
    return {
      low: low('x'),
      middle: new Vector2((low('y') + high('y')) / 2, (low('z') + high('z')) / 2),
      size: new Vector2(high('y') - low('y'), high('z') - low('z')),
    };
  });
}

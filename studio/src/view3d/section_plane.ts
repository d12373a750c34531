import {BufferAttribute, BufferGeometry, CanvasTexture, Group, LineBasicMaterial, LineLoop, PerspectiveCamera, Plane, Sprite, SpriteMaterial, SRGBColorSpace, Vector3} from 'three';
import type {Section} from '../state/view.svelte';

/** Of the picture's height. */
const KNOB = 0.026;
/** How far the frame stands out around what is cut, as a share of its size. */
const MARGIN = 0.03;
/** So that faces which lie in the plane at an end do not flicker. */
const BEYOND = 0.001;

/** A plane that takes away what is before it, and how it is seen: a frame with a knob to drag it by. */
export class SectionPlane {
  readonly group = new Group();
  /** It faces what it leaves: in design coordinates, and in the world. */
  readonly own = new Plane();
  readonly plane = new Plane();
  /** Where the knob is, and one mm further; design coordinates. */
  readonly knob = new Vector3();
  readonly along = new Vector3();
  #low = 0;
  #high = 1;
  readonly #frame = new LineLoop(
    new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(12), 3)),
    new LineBasicMaterial(),
  );
  #knob: Sprite | null = null;

  constructor() {
    this.#frame.frustumCulled = false;
    this.group.add(this.#frame);
    this.group.visible = false;
  }

  /** Without its frame and knob. */
  set bare(value: boolean) {
    this.#frame.visible = !value;
    if (this.#knob) this.#knob.visible = !value;
  }

  colour(value: string) {
    this.#frame.material.color.set(value);
    this.#knob?.material.color.set(value);
  }

  /** `corners`: of what it is dragged through, design coordinates. */
  place({axis, share, flipped}: Section, corners: readonly Vector3[]) {
    const [low, high] = [new Vector3(Infinity, Infinity, Infinity), new Vector3(-Infinity, -Infinity, -Infinity)];
    for (const corner of corners) [low.min(corner), high.max(corner)];
    const margin = low.distanceTo(high) * MARGIN;
    [this.#low, this.#high] = [low.getComponent(axis), high.getComponent(axis)];
    const size = this.#high - this.#low;
    const at = this.#low - BEYOND * size + share * size * (1 + 2 * BEYOND);
    this.along.set(0, 0, 0).setComponent(axis, 1);
    this.own.setFromNormalAndCoplanarPoint(this.along.clone().multiplyScalar(flipped ? 1 : -1), this.along.clone().multiplyScalar(at));
    this.#outline(axis, at, low.addScalar(-margin), high.addScalar(margin));
  }

  #outline(axis: number, at: number, low: Vector3, high: Vector3) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    const position = this.#frame.geometry.getAttribute('position');
    [[low, low], [high, low], [high, high], [low, high]].forEach(([across, up], i) => {
      const corner = new Vector3().setComponent(axis, at).setComponent(u, across!.getComponent(u)).setComponent(v, up!.getComponent(v));
      position.setXYZ(i, corner.x, corner.y, corner.z);
      // The uppermost to the right of an upright plane; of a flat one that nearest to the reader.
      if (i === 2) this.knob.copy(corner);
    });
    position.needsUpdate = true;
    this.#knob ??= this.#join();
    this.#knob.position.copy(this.knob);
  }

  #join(): Sprite {
    const material = new SpriteMaterial({map: drawn(), depthTest: false, transparent: true, sizeAttenuation: false});
    material.color.copy(this.#frame.material.color);
    const knob = new Sprite(material);
    knob.scale.setScalar(KNOB);
    knob.renderOrder = 11;
    // Its arrows point the way that it goes.
    knob.onBeforeRender = (_renderer, _scene, camera) => {
      const world = this.group.matrixWorld;
      const from = this.knob.clone().applyMatrix4(world).project(camera);
      const to = this.knob.clone().add(this.along).applyMatrix4(world).project(camera).sub(from);
      const {aspect} = camera as PerspectiveCamera;
      material.rotation = Math.atan2(to.y, to.x * aspect) - Math.PI / 2;
    };
    this.group.add(knob);
    return knob;
  }

  /** The share that lies so many mm further. */
  further(share: number, mm: number): number {
    return Math.min(Math.max(share + mm / Math.max(this.#high - this.#low, 1e-6), 0), 1);
  }
}

/** A disc with a rim, in white: the material colours it. */
function drawn(): CanvasTexture {
  const side = 64;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d');
  if (context) {
    const disc = (radius: number, colour: string) => {
      context.fillStyle = colour;
      context.beginPath();
      context.arc(side / 2, side / 2, radius, 0, 2 * Math.PI);
      context.fill();
    };
    disc(30, '#fff');
    // The material's colour makes it darker.
    context.fillStyle = '#000';
    for (const up of [-1, 1]) {
      context.beginPath();
      context.moveTo(32, 32 + up * 21);
      context.lineTo(21, 32 + up * 7);
      context.lineTo(43, 32 + up * 7);
      context.fill();
    }
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

import CameraControls from 'camera-controls';
import {
  Box3,
  MathUtils,
  Matrix4,
  Object3D,
  PerspectiveCamera,
  Quaternion,
  Raycaster,
  Sphere,
  Spherical,
  Vector2,
  Vector3,
  Vector4,
  WebGLRenderer,
} from 'three';
import type * as THREE from 'three';
import {TransformControls} from 'three/addons/controls/TransformControls.js';
import type {Triple} from '../design/design';
import type {Handles} from '../state/view.svelte';
import {fitCamera, freeReach, type Covered} from './fit_camera';
import {TO_WORLD, type FoamScene} from './scene';

CameraControls.install({
  THREE: {Vector2, Vector3, Vector4, Quaternion, Matrix4, Spherical, Box3, Sphere, Raycaster} as unknown as typeof THREE,
});

export type Side = 'corner' | 'front' | 'back' | 'left' | 'right' | 'top' | 'bottom';

/** Azimuth and polar angle, as camera-controls has them: from the front (+y) and from above. */
const VIEWS: Record<Side, [number, number]> = {
  corner: [0.55, 1.02],
  front: [0, Math.PI / 2],
  back: [Math.PI, Math.PI / 2],
  left: [-Math.PI / 2, Math.PI / 2],
  right: [Math.PI / 2, Math.PI / 2],
  top: [0, 0.001],
  bottom: [0, Math.PI - 0.001],
};
/** Twice the resolution when the picture stands still smooths its edges; while it moves that is left out, unless
 *  the machine draws so fast that nobody notices. */
const STILL_RATIO = 2;
const FAST_FRAME_MS = 8;
/** Of a picture to keep, the longer side. */
const PICTURE_PX = 2400;
/** Pixels are what a software renderer's time goes to. */
const MOVING_RATIO = 0.5;

export interface StageEvents {
  /** A turn about the world's axes since the handle was taken, or a shift in design coordinates. */
  turned(turn: Quaternion, start: boolean): void;
  shifted(by: Triple, start: boolean): void;
  /** The handle was let go. */
  released(): void;
  /** A person turns or moves the view, or it still glides after that. */
  looked(): void;
  lost(): void;
  restored(): void;
  /** After a picture was handed to the browser. */
  drawn(): void;
}

/** How the scene is looked at and drawn: camera, handles, resolution. Draws only when something changed. */
export class Stage {
  readonly camera = new PerspectiveCamera(32, 1, 1, 100_000);
  readonly #canvas: HTMLCanvasElement;
  readonly #content: FoamScene;
  readonly #events: StageEvents;
  readonly #renderer: WebGLRenderer;
  readonly #controls: CameraControls;
  readonly #handles: TransformControls;
  readonly #proxy = new Object3D();
  readonly #ray = new Raycaster();
  #grabbed: {quaternion: Quaternion; position: Vector3} | null = null;
  #pending = 0;
  #last = 0;
  #still = true;
  #fast = false;
  #measured = false;
  #painting = false;
  #covered: Covered = {top: 0, bottom: 0};
  #size = {width: 1, height: 1};
  /** All is seen, and stays so until a person looks elsewhere. */
  #framed = true;
  #radius = 1;

  /** Throws where there is no WebGL 2. */
  constructor(canvas: HTMLCanvasElement, content: FoamScene, events: StageEvents) {
    this.#canvas = canvas;
    this.#content = content;
    this.#events = events;
    this.#renderer = new WebGLRenderer({canvas, antialias: false, alpha: true, stencil: true, powerPreference: 'high-performance'});
    this.#renderer.localClippingEnabled = true;
    canvas.addEventListener('webglcontextlost', this.#onLost);
    canvas.addEventListener('webglcontextrestored', this.#onRestored);
    this.#controls = new CameraControls(this.camera, canvas);
    this.#controls.smoothTime = matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 0.18;
    this.#controls.draggingSmoothTime = 0.04;
    this.#controls.dollyToCursor = true;
    // One finger turns; so do two, which zoom as well.
    this.#controls.touches.two = CameraControls.ACTION.TOUCH_DOLLY_ROTATE;
    this.#controls.addEventListener('control', () => this.#look());
    this.#handles = new TransformControls(this.camera, canvas);
    content.scene.add(this.#proxy, this.#handles.getHelper());
    this.#handles.attach(this.#proxy);
    this.#listenToHandles();
    this.handles = 'none';
    this.view('corner', false);
  }

  dispose() {
    cancelAnimationFrame(this.#pending);
    this.#canvas.removeEventListener('webglcontextlost', this.#onLost);
    this.#canvas.removeEventListener('webglcontextrestored', this.#onRestored);
    this.#handles.dispose();
    this.#controls.dispose();
    this.#renderer.dispose();
  }

  /** Asks for a picture with the next frame. */
  draw() {
    if (this.#pending) return;
    this.#pending = requestAnimationFrame((now) => this.#frame(now));
  }

  resize(width: number, height: number) {
    if (width < 1 || height < 1) return;
    this.#size = {width, height};
    this.#renderer.setSize(width, height, false);
    this.#lay();
  }

  /** The middle of what is free of the bars becomes the picture's. */
  set covered(covered: Covered) {
    this.#covered = covered;
    this.#lay();
  }

  #lay() {
    const {width, height} = this.#size;
    const {top, bottom} = this.#covered;
    this.camera.setViewOffset(width, height, 0, Math.round((bottom - top) / 2), width, height);
    this.refit();
  }

  set still(value: boolean) {
    if (value === this.#still) return;
    this.#still = value;
    this.#content.detailed = value;
    this.#resolve();
    this.draw();
  }

  set handles(kind: Handles) {
    const helper = this.#handles.getHelper();
    helper.visible = kind !== 'none';
    this.#handles.enabled = kind !== 'none';
    if (kind !== 'none') this.#handles.setMode(kind === 'turn' ? 'rotate' : 'translate');
    this.draw();
  }

  /** Where the first button paints, the second one turns. */
  get painting(): boolean {
    return this.#painting;
  }

  set painting(value: boolean) {
    this.#painting = value;
    const {ROTATE, TRUCK} = CameraControls.ACTION;
    this.#controls.mouseButtons.right = value ? ROTATE : TRUCK;
  }

  paintHandles(x: string, y: string, z: string, active: string) {
    // The world's x, y and z are the design's z, x and y.
    this.#handles.setColors(z, x, y, active);
  }

  /** Handles stand where the object is, unless a hand is on them. */
  placeHandles() {
    if (this.#grabbed) return;
    this.#proxy.position.copy(this.#content.objectCentre);
    this.#proxy.quaternion.identity();
  }

  view(side: Side, smoothly = true) {
    const [azimuth, polar] = VIEWS[side];
    this.#controls.normalizeRotations();
    void this.#controls.rotateTo(azimuth, polar, smoothly);
    this.showAll(smoothly);
  }

  /** From where the camera looks, as near as all is seen beside the bars. */
  showAll(smoothly = true) {
    const {theta: azimuth, phi: polar} = this.#controls.getSpherical(new Spherical());
    const {corners} = this.#content;
    const fit = fitCamera(corners, {azimuth, polar}, freeReach(this.camera.fov, this.#size, this.#covered));
    if (fit) {
      this.#limits(new Sphere().setFromPoints(corners).radius, fit.distance);
      void this.#controls.moveTo(fit.target.x, fit.target.y, fit.target.z, smoothly);
      void this.#controls.dollyTo(fit.distance, smoothly);
    }
    this.#framed = true;
    this.draw();
  }

  /** What is seen grew, or there is room for more of it: still all of it, if all was seen. */
  refit(smoothly = false) {
    if (this.#framed && !this.#grabbed) this.showAll(smoothly);
    this.draw();
  }

  /** Brings the camera near a place, design coordinates. `layer`: that it belongs to. */
  lookAt(place: Triple, layer?: number) {
    const lies = new Vector3(...place);
    const point = (layer === undefined ? lies : this.#content.drawnAt(lies, layer)).applyMatrix4(TO_WORLD);
    this.#framed = false;
    void this.#controls.moveTo(point.x, point.y, point.z, true);
    void this.#controls.dollyTo(this.#radius * 1.6, true);
    this.draw();
  }

  orbit(azimuth: number, polar: number) {
    void this.#controls.rotate(azimuth, polar, true);
    this.#look();
  }

  zoom(factor: number) {
    void this.#controls.dollyTo(this.#controls.distance * factor, true);
    this.#look();
  }

  #look() {
    this.#framed = false;
    this.#events.looked();
    this.draw();
  }

  /** Moves what is seen by shares of the picture. */
  truck(right: number, up: number) {
    const high = 2 * this.#controls.distance * Math.tan(MathUtils.degToRad(this.camera.fov) / 2);
    void this.#controls.truck(-right * high, up * high, true);
    this.#look();
  }

  /** A place of the world, px of the picture. */
  onPicture(place: Vector3): Vector2 {
    const {x, y} = place.clone().project(this.camera);
    return new Vector2(((x + 1) / 2) * this.#size.width, ((1 - y) / 2) * this.#size.height);
  }

  /** The middle of what is free of the bars, px of the picture. */
  get middle(): {x: number; y: number} {
    const {width, height} = this.#size;
    return {x: width / 2, y: (this.#covered.top + height - this.#covered.bottom) / 2};
  }

  ray(at: Vector2): Raycaster {
    this.#ray.setFromCamera(at, this.camera);
    return this.#ray;
  }

  #frame(now: number) {
    this.#pending = 0;
    const moving = this.#controls.update(Math.min((now - this.#last) / 1000, 0.1));
    this.#last = now;
    this.#renderer.render(this.#content.scene, this.camera);
    this.#events.drawn();
    if (moving && !this.#still) this.#events.looked();
    if (moving) this.draw();
  }

  /** Times one picture, once there is something to draw. */
  measureSpeed() {
    if (this.#measured) return;
    this.#measured = true;
    const gl = this.#renderer.getContext();
    const start = performance.now();
    this.#renderer.render(this.#content.scene, this.camera);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
    this.#fast = performance.now() - start < FAST_FRAME_MS;
  }

  /** What is seen between the bars, without what stands there for a hand; clear where nothing is. */
  picture(): HTMLCanvasElement {
    const {width, height} = this.#size;
    const {top, bottom} = this.#covered;
    const scale = PICTURE_PX / Math.max(width, height);
    const helper = this.#handles.getHelper();
    const [before, handled] = [this.#content.bare, helper.visible];
    this.#content.bare = true;
    helper.visible = false;
    this.#renderer.setPixelRatio(scale);
    this.#renderer.render(this.#content.scene, this.camera);
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [Math.round(width * scale), Math.round((height - top - bottom) * scale)];
    // Before the browser takes it.
    canvas.getContext('2d')?.drawImage(this.#canvas, 0, -Math.round(top * scale));
    this.#content.bare = before;
    helper.visible = handled;
    this.#resolve();
    this.draw();
    return canvas;
  }

  #resolve() {
    const sharp = Math.max(window.devicePixelRatio, STILL_RATIO);
    this.#renderer.setPixelRatio(this.#still || this.#fast ? sharp : MOVING_RATIO);
  }

  #limits(radius: number, distance: number) {
    this.#radius = radius;
    this.#controls.minDistance = radius * 0.15;
    this.#controls.maxDistance = Math.max(radius * 8, distance * 2);
    this.camera.near = radius * 0.02;
    this.camera.far = this.#controls.maxDistance + radius * 12;
    this.camera.updateProjectionMatrix();
  }

  #listenToHandles() {
    this.#handles.addEventListener('change', () => this.draw());
    this.#handles.addEventListener('dragging-changed', ({value}) => {
      this.#controls.enabled = !value;
      this.#grabbed = value
        ? {quaternion: this.#proxy.quaternion.clone(), position: this.#proxy.position.clone()}
        : null;
      if (value) this.#tell(true);
      else this.#events.released();
      this.placeHandles();
    });
    this.#handles.addEventListener('objectChange', () => this.#tell(false));
  }

  #tell(start: boolean) {
    if (!this.#grabbed) return;
    if (this.#handles.mode === 'rotate') {
      const turn = this.#proxy.quaternion.clone().multiply(this.#grabbed.quaternion.clone().invert());
      // The same turn about the design's axes.
      const [x, y, z] = [turn.y, turn.z, turn.x];
      this.#events.turned(new Quaternion(x, y, z, turn.w), start);
    } else {
      const by = this.#proxy.position.clone().sub(this.#grabbed.position);
      this.#events.shifted([by.y, by.z, by.x], start);
    }
  }

  #onLost = (event: Event) => {
    event.preventDefault(); // or it never comes back
    this.#events.lost();
  };

  #onRestored = () => {
    this.#events.restored();
    this.draw();
  };
}

/** From the place of a pointer in the picture. */
export function pointerAt(event: {clientX: number; clientY: number}, canvas: HTMLElement): Vector2 {
  const {left, top, width, height} = canvas.getBoundingClientRect();
  return new Vector2(((event.clientX - left) / width) * 2 - 1, 1 - ((event.clientY - top) / height) * 2);
}

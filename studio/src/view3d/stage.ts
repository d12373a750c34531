import CameraControls from 'camera-controls';
import {
  Box3,
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

  /** Throws where there is no WebGL 2. */
  constructor(canvas: HTMLCanvasElement, content: FoamScene, events: StageEvents) {
    this.#canvas = canvas;
    this.#content = content;
    this.#events = events;
    this.#renderer = new WebGLRenderer({canvas, antialias: false, alpha: true, powerPreference: 'high-performance'});
    canvas.addEventListener('webglcontextlost', this.#onLost);
    canvas.addEventListener('webglcontextrestored', this.#onRestored);
    this.#controls = new CameraControls(this.camera, canvas);
    this.#controls.smoothTime = matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : 0.18;
    this.#controls.draggingSmoothTime = 0.04;
    this.#controls.dollyToCursor = true;
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
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.#renderer.setSize(width, height, false);
    this.draw();
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

  /** Where the first button or one finger paints, the second button or two fingers turn. */
  get painting(): boolean {
    return this.#painting;
  }

  set painting(value: boolean) {
    this.#painting = value;
    const {ROTATE, TRUCK, TOUCH_DOLLY_ROTATE, TOUCH_DOLLY_TRUCK} = CameraControls.ACTION;
    this.#controls.mouseButtons.right = value ? ROTATE : TRUCK;
    this.#controls.touches.two = value ? TOUCH_DOLLY_ROTATE : TOUCH_DOLLY_TRUCK;
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

  showAll(smoothly = true) {
    const {centre, radius} = this.#content.extent;
    this.#limits(radius);
    // The controls lie over the lower edge of the picture.
    void this.#controls.setFocalOffset(0, radius * 0.18, 0, false);
    void this.#controls.fitToSphere(new Sphere(centre, radius * 0.92), smoothly);
    this.draw();
  }

  /** Brings the camera near a place, design coordinates. `layer`: that it belongs to. */
  lookAt(place: Triple, layer?: number) {
    const lies = new Vector3(...place);
    const point = (layer === undefined ? lies : this.#content.drawnAt(lies, layer)).applyMatrix4(TO_WORLD);
    const {radius} = this.#content.extent;
    void this.#controls.moveTo(point.x, point.y, point.z, true);
    void this.#controls.dollyTo(radius * 1.6, true);
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
    this.#events.looked();
    this.draw();
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

  #resolve() {
    const sharp = Math.max(window.devicePixelRatio, STILL_RATIO);
    this.#renderer.setPixelRatio(this.#still || this.#fast ? sharp : MOVING_RATIO);
  }

  #limits(radius: number) {
    this.#controls.minDistance = radius * 0.15;
    this.#controls.maxDistance = radius * 8;
    this.camera.near = radius * 0.02;
    this.camera.far = radius * 20;
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

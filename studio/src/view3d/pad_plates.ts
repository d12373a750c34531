import {BoxGeometry, Color, Group, Matrix4, Mesh, MeshBasicMaterial, PlaneGeometry, Vector3, type Plane, type ShaderMaterial} from 'three';
import type {PackedPad} from '../engine/fit';
import type {PieceKind} from '../engine/pieces';
import type {Look} from '../state/view.svelte';
import {writing} from './furniture';
import {foamShading, type Shading} from './shading';

/** How far from the colour of its piece to white. */
const LIGHTER = 0.45;
/** Of a plate's shorter side, and at most, mm. */
const NUMBER_SHARE = 0.7;
const NUMBER_MM = 24;
/** So far before the plate, mm. */
const NUMBER_BEFORE = 0.2;

interface Plate {
  /** Where its piece is drawn. */
  lift: Group;
  mesh: Mesh<BoxGeometry, ShaderMaterial>;
  number: Mesh<PlaneGeometry, MeshBasicMaterial>;
  kind: PieceKind;
  piece: number;
}

/** Pads as thin plates with their numbers, each with the piece of foam that it lies on or hangs under. */
export class PadPlates {
  readonly group = new Group();
  readonly #shades: Record<PieceKind, Shading> = {lower: plateShading(), middle: plateShading(), upper: plateShading()};
  readonly #box = new BoxGeometry(1, 1, 1);
  readonly #face = new PlaneGeometry(1, 1);
  #plates: Plate[] = [];
  #planes: Plane[] | null = null;
  #looks: Record<PieceKind, Look> = {lower: 'shown', middle: 'shown', upper: 'shown'};

  paint(colours: Record<PieceKind, string>, edge: string) {
    const white = new Color('#fff');
    for (const [kind, shade] of this.#kinds()) shade.colour(`#${new Color(colours[kind]).lerp(white, LIGHTER).getHexString()}`, edge);
  }

  /** In the order of their numbers. `kindOf`: of a piece. */
  show(pads: readonly PackedPad[], kindOf: (piece: number) => PieceKind) {
    for (const {lift, number} of this.#plates) {
      number.material.map?.dispose();
      number.material.dispose();
      this.group.remove(lift);
    }
    this.#plates = pads.map((pad, i) => this.#plate(pad, i + 1, kindOf(pad.piece)));
    this.#dress();
  }

  set looks(looks: Record<PieceKind, Look>) {
    this.#looks = looks;
    for (const [kind, shade] of this.#kinds()) shade.look(looks[kind]);
    this.#dress();
  }

  /** What lies behind these is seen, world coordinates. */
  clip(planes: Plane[] | null) {
    this.#planes = planes;
    for (const [, {material}] of this.#kinds()) material.clippingPlanes = planes;
    for (const {number} of this.#plates) number.material.clippingPlanes = planes;
  }

  /** `at`: where a piece is drawn, from where it lies. */
  place(at: (piece: number) => Matrix4) {
    for (const {lift, piece} of this.#plates) {
      lift.matrix.copy(at(piece));
      lift.matrixWorldNeedsUpdate = true;
    }
  }

  #plate({piece, above, box}: PackedPad, number: number, kind: PieceKind): Plate {
    const [low, high] = [new Vector3(...box.min), new Vector3(...box.max)];
    const size = high.clone().sub(low);
    const mesh = new Mesh(this.#box, this.#shades[kind].material);
    mesh.scale.copy(size);
    mesh.position.copy(low).add(high).multiplyScalar(0.5);
    mesh.renderOrder = 2; // as its foam
    const written = this.#number(number, Math.min(NUMBER_SHARE * Math.min(size.y, size.z), NUMBER_MM), above);
    written.position.copy(mesh.position).setX(above ? low.x - NUMBER_BEFORE : high.x + NUMBER_BEFORE);
    const lift = new Group();
    lift.matrixAutoUpdate = false;
    lift.add(mesh, written);
    this.group.add(lift);
    return {lift, mesh, number: written, kind, piece};
  }

  /** To be read from the side of the item, as maps are: z to the right, -y up below it and y up above it. */
  #number(number: number, high: number, above: boolean) {
    const {texture, aspect} = writing(String(number), '#223');
    const material = new MeshBasicMaterial({map: texture, transparent: true, depthWrite: false, clippingPlanes: this.#planes});
    const mesh = new Mesh(this.#face, material);
    const up = above ? 1 : -1;
    mesh.setRotationFromMatrix(new Matrix4().makeBasis(new Vector3(0, 0, 1), new Vector3(0, up, 0), new Vector3(-up, 0, 0)));
    mesh.scale.set(high * Math.min(aspect, 1), high * Math.min(1, 1 / aspect), 1);
    mesh.renderOrder = 3;
    return mesh;
  }

  #kinds(): [PieceKind, Shading][] {
    return Object.entries(this.#shades) as [PieceKind, Shading][];
  }

  #dress() {
    for (const {lift, kind, number} of this.#plates) {
      lift.visible = this.#looks[kind] !== 'hidden';
      number.visible = this.#looks[kind] === 'shown';
    }
  }
}

/** A box of size 1 around its middle is one block, whose edges are drawn. */
function plateShading(): Shading {
  const shade = foamShading();
  shade.material.uniforms.corner?.value.setScalar(-0.5);
  return shade;
}

import {
  BufferGeometry,
  Group,
  Matrix4,
  Mesh,
  Raycaster,
  Scene,
  Vector3,
  type ShaderMaterial,
} from 'three';
import type {Triple} from '../design/design';
import type {DisplayMesh, PackedItem, Packing} from '../engine/api';
import type {PlacedItem} from '../state/on_the_page';
import type {Cell, Look, Part} from '../state/view.svelte';
import {apart, type Apart} from './apart';
import {CentreMarks, type SeenCentre} from './centre_marks';
import {FoamMeshes, type PieceColours} from './foam_meshes';
import {arrow, boxEdges, columnBox, ruler} from './furniture';
import {objectGeometry} from './object_geometry';
import {PressurePaint} from './pressure_paint';
import type {SeenPressure} from './seen_pressure';
import {GLASS, objectShading} from './shading';
import {ZonePaint, type PaintHint, type SeenZones} from './zone_paint';

/** Around an item. */
const FRAME_MM = 1;
/** Of a stack's height, so that it ends below and above the controls. */
const STACK_CLEAR = 0.66;

export interface Colours {
  background: string;
  object: string;
  lower: string;
  middle: string;
  upper: string;
  edge: string;
  space: string;
  own: string;
  mark: string;
  zone: string;
  /** Around the item that is selected, and around items that are too near each other. */
  selected: string;
  near: string;
}

/** Design coordinates to the world of three.js: x up, y to the reader, z to the right. */
export const TO_WORLD = new Matrix4().makeBasis(new Vector3(0, 1, 0), new Vector3(0, 0, 1), new Vector3(1, 0, 0));

/** What lies under a pointer; of the object its part, 0 where it is one alone. */
export interface Picked {
  own: Triple | null;
  cell: Cell | null;
  item: number | null;
  part: number;
}

interface Body {
  /** Where its layer is drawn, and in it where the object lies in the space. */
  lift: Group;
  group: Group;
  mesh: Mesh<BufferGeometry, ShaderMaterial>;
  geometries: Geometries;
  paint: ZonePaint;
  pressure: PressurePaint;
  /** How far what is drawn lies from the object at most, mm. */
  deviation: number;
}
type Geometries = {moving: BufferGeometry; still: BufferGeometry};

/** What is in the 3D view, without how it is looked at. */
export class FoamScene {
  readonly scene = new Scene();
  readonly #root = new Group();
  #bodies: Body[] = [];
  #selected = 0;
  readonly #frames = new Group();
  readonly #objectShade = objectShading();
  readonly #foams = new FoamMeshes();
  readonly #space = boxEdges();
  readonly #column = boxEdges();
  readonly #up = arrow();
  readonly #own = arrow();
  readonly #ruler = ruler();
  readonly #centres = new CentreMarks();
  /** By the copy that was drawn. */
  #geometries = new Map<DisplayMesh, BufferGeometry>();
  #colours: Colours | null = null;
  #packing: Packing | null = null;
  #detailed = false;
  #opening = 0;
  /** None while there is no space. */
  #apart: Apart | null = null;
  #shift: Triple = [0, 0, 0];
  #objectLook: Look = 'shown';
  #alone = false;

  constructor() {
    this.#root.matrixAutoUpdate = false;
    this.#root.matrix.copy(TO_WORLD);
    this.#root.add(this.#frames, this.#foams.group, this.#space, this.#column, this.#centres.group);
    this.scene.add(this.#root, this.#up.group);
    this.#column.visible = false;
    this.#column.material.depthTest = false;
    this.#column.renderOrder = 9;
    this.#objectShade.material.polygonOffset = false;
    this.show(null, null);
  }

  /** Of the space with its pieces as far apart as they are, or of an object that has none or is shown alone; world
   *  coordinates. */
  get extent(): {centre: Vector3; radius: number} {
    const alone = this.#packing ? null : this.#sphere();
    if (alone) return {centre: alone.center.clone().applyMatrix4(this.#root.matrix), radius: alone.radius};
    if (this.#alone) return {centre: this.objectCentre, radius: Math.max(this.#objectSize() / 2, 1)};
    const [x, y, z] = this.#size();
    const {low, high} = this.#apart ?? {low: -x / 2, high: x / 2};
    const centre = new Vector3((low + high) / 2, 0, 0).applyMatrix4(TO_WORLD);
    const clear = (this.#packing?.partingLevels.length ?? 1) > 1 ? STACK_CLEAR * (high - low) : 0;
    return {centre, radius: Math.max(Math.hypot(high - low, y, z) / 2, clear, 1)};
  }

  /** The middle of the item that is selected, world coordinates. */
  get objectCentre(): Vector3 {
    const item = this.#packing?.items[this.#selected];
    if (!item) return new Vector3();
    const {min, max} = item.bounds;
    const middle = new Vector3(...min).add(new Vector3(...max)).multiplyScalar(0.5);
    return this.drawnAt(middle, item.layer).applyMatrix4(this.#root.matrix);
  }

  /** Where a place of a layer is drawn, design coordinates. */
  drawnAt(place: Vector3, layer: number): Vector3 {
    return place.setX(place.x + (this.#apart?.layer(layer) ?? 0));
  }

  paint(colours: Colours, words: {up: string; own: string}) {
    this.#colours = colours;
    this.#objectShade.colour(colours.object, colours.edge, colours.zone);
    this.#foams.paint(colours, colours.edge);
    this.#space.material.color.set(colours.space);
    this.#column.material.color.set(colours.mark);
    this.#up.colour(colours.space);
    this.#up.say(words.up);
    this.#own.colour(colours.own);
    this.#own.say(words.own);
  }

  /** The items, each where it lies, and which of them is selected. */
  setItems(placed: readonly PlacedItem[], selected: number) {
    const meshes = new Set(placed.flatMap(({meshes: {moving, still}}) => [moving, still]));
    for (const [mesh, geometry] of this.#geometries)
      if (!meshes.has(mesh)) {
        geometry.dispose();
        this.#geometries.delete(mesh);
      }
    while (this.#bodies.length > placed.length) {
      const {lift, paint, pressure} = this.#bodies.pop()!;
      this.#root.remove(lift);
      paint.dispose();
      pressure.dispose();
    }
    placed.forEach(({meshes: {moving, still}, placement}, i) => {
      const body = (this.#bodies[i] ??= this.#body());
      body.geometries = {moving: this.#geometry(moving), still: this.#geometry(still)};
      body.deviation = Math.max(moving.deviation, still.deviation);
      body.group.matrix.fromArray([...placement]);
      body.group.matrixWorldNeedsUpdate = true;
    });
    this.#selected = selected;
    this.#uncover();
    const {group} = this.#bodies[selected] ?? this.#bodies[0] ?? {group: this.#root};
    group.add(this.#own.group, this.#ruler.group);
    this.#place();
    this.#dress();
  }

  #body(): Body {
    const mesh = new Mesh(new BufferGeometry(), this.#objectShade.material);
    const [lift, group] = [new Group(), new Group()];
    group.matrixAutoUpdate = false;
    lift.add(group.add(mesh));
    this.#root.add(lift);
    const geometries = {moving: mesh.geometry, still: mesh.geometry};
    const body = {lift, group, mesh, geometries, paint: new ZonePaint(), pressure: new PressurePaint(), deviation: 0};
    mesh.onBeforeRender = () => {
      body.paint.apply(mesh.material);
      body.pressure.apply(mesh.material, group.matrix, body.deviation);
      mesh.material.uniformsNeedUpdate = true;
    };
    return body;
  }

  #geometry(mesh: DisplayMesh): BufferGeometry {
    const known = this.#geometries.get(mesh);
    if (known) return known;
    const made = objectGeometry(mesh);
    this.#geometries.set(mesh, made);
    return made;
  }

  /** Of each item its places to keep off, and what a hand is about to paint on the one that is selected. */
  setZones(seen: readonly SeenZones[], hint: PaintHint | null) {
    this.#bodies.forEach(({paint}, i) => {
      paint.see(seen[i]);
      paint.hint = i === this.#selected ? hint : null;
    });
  }

  /** What squeezes what; null: not to be seen. */
  set pressure(seen: SeenPressure | null) {
    this.#bodies.forEach(({pressure}, i) => pressure.see(seen?.items[i] ?? null));
    this.#foams.pressure = seen?.foam ?? null;
  }

  set centres(seen: readonly SeenCentre[]) {
    this.#centres.see(seen);
    this.#place();
  }

  /** Frames around items: the one that is selected among several, and those that are too near each other. */
  frame(items: readonly PackedItem[], selected: number, near: ReadonlySet<number>) {
    const framed = items.length < 2 ? [] : [...items.keys()].filter((i) => i === selected || near.has(i));
    while (this.#frames.children.length > framed.length) this.#frames.remove(this.#frames.children.at(-1)!);
    for (const [at, i] of framed.entries()) {
      if (!this.#colours) return;
      const {bounds, layer} = items[i]!;
      const known = this.#frames.children[at] as ReturnType<typeof boxEdges> | undefined;
      const frame = known ?? boxEdges();
      frame.material.color.set(near.has(i) ? this.#colours.near : this.#colours.selected);
      const [low, high] = [new Vector3(...bounds.min), new Vector3(...bounds.max)];
      frame.userData = {layer, middle: low.clone().add(high).multiplyScalar(0.5)};
      frame.scale.copy(high.sub(low)).addScalar(2 * FRAME_MM);
      frame.material.depthTest = false;
      frame.renderOrder = 8;
      if (!known) this.#frames.add(frame);
    }
    this.#place();
  }

  /** `colours`: of the pieces, where they are wanted. */
  show(packing: Packing | null, colours: readonly PieceColours[] | null) {
    this.#packing = packing;
    const [x, y, z] = this.#size();
    // An object by itself lies wherever its file has it, in no space.
    this.#space.scale.set(x, y, z).multiplyScalar(packing ? 1 : 0);
    this.#placeUpArrow();
    this.#up.group.scale.setScalar(Math.max(x, 1) * 0.32);
    this.#up.group.visible = packing !== null && !this.#alone;
    this.#foams.show(packing, colours);
    this.#place();
    this.#placeOwnArrow();
  }

  /** Fewer triangles while something moves. */
  set detailed(value: boolean) {
    if (value === this.#detailed) return;
    this.#detailed = value;
    this.#dress();
    this.#foams.detailed = value;
  }

  /** Draws everything so much further, design coordinates. */
  set shift(by: Triple) {
    this.#shift = by;
    this.#placeUpArrow();
    this.#root.matrix.copy(TO_WORLD).multiply(new Matrix4().makeTranslation(...by));
    this.#root.matrixWorldNeedsUpdate = true;
  }

  set opening(value: number) {
    this.#opening = value;
    this.#place();
  }

  set looks(looks: Record<Part, Look>) {
    this.#objectLook = looks.object;
    this.#uncover();
    this.#objectShade.look(looks.object);
    this.#foams.looks = looks;
    this.#space.visible = looks.space !== 'hidden';
    this.#space.material.transparent = looks.space === 'glass';
    this.#space.material.opacity = looks.space === 'glass' ? GLASS : 1;
    this.#placeOwnArrow();
  }

  /** Nothing but the item that is selected. */
  set alone(value: boolean) {
    this.#alone = value;
    this.#up.group.visible = this.#packing !== null && !value;
    this.#uncover();
  }

  #uncover() {
    const selected = this.#selectedBody();
    for (const body of this.#bodies) body.mesh.visible = this.#objectLook !== 'hidden' && (!this.#alone || body === selected);
  }

  mark(cell: Cell | null) {
    this.#column.visible = cell !== null && this.#packing !== null;
    if (!cell || !this.#packing || !this.#apart) return;
    const {low, high} = this.#apart;
    const {centre, size} = columnBox(this.#packing, cell.j, cell.k);
    this.#column.position.set((low + high) / 2, centre[1], centre[2]);
    this.#column.scale.set(high - low, size[1], size[2]);
  }

  measure(points: readonly Triple[]) {
    this.#ruler.show(points, this.#objectSize() * 0.012);
  }

  /** What lies under a point of the picture (-1 to 1): on the object in its own mm, and the column of the space. */
  pick(ray: Raycaster): Picked {
    const bodies = this.#bodies.map(({mesh}) => mesh);
    const targets = [...bodies.filter(({visible}) => visible), ...this.#foams.visible];
    const hit = ray.intersectObjects<Mesh>(targets, false)[0];
    if (!hit) return {own: null, cell: null, item: null, part: 0};
    const item = bodies.findIndex((mesh) => mesh === hit.object);
    const own = item < 0 ? null : this.#bodies[item]!.group.worldToLocal(hit.point.clone());
    const design = this.#root.worldToLocal(hit.point.clone());
    const part = (item >= 0 && hit.face && hit.object.geometry.getAttribute('part')?.getX(hit.face.a)) || 0;
    return {own: own && [own.x, own.y, own.z], cell: this.#cellAt(design), item: item < 0 ? null : item, part};
  }

  #cellAt({y, z}: Vector3): Cell | null {
    if (!this.#packing) return null;
    const [, ny, nz] = this.#packing.blocks;
    const [, sy, sz] = this.#packing.block_mm;
    const j = Math.floor(y / sy + ny / 2);
    const k = Math.floor(z / sz + nz / 2);
    return j >= 0 && j < ny && k >= 0 && k < nz ? {j, k} : null;
  }

  #size(): Triple {
    if (!this.#packing) return [this.#objectSize(), this.#objectSize(), this.#objectSize()];
    const {blocks, block_mm} = this.#packing;
    return [blocks[0] * block_mm[0], blocks[1] * block_mm[1], blocks[2] * block_mm[2]];
  }

  /** Of the item that is selected. */
  #objectSize(): number {
    return (this.#sphere()?.radius ?? 0) * 2;
  }

  /** Around it, in its object's own coordinates. */
  #sphere() {
    const geometry = this.#selectedBody()?.mesh.geometry;
    if (!geometry?.getAttribute('position')) return null;
    if (!geometry.boundingSphere) geometry.computeBoundingSphere();
    return geometry.boundingSphere;
  }

  #selectedBody(): Body | undefined {
    return this.#bodies[this.#selected] ?? this.#bodies[0];
  }

  #dress() {
    for (const {mesh, geometries} of this.#bodies) mesh.geometry = geometries[this.#detailed ? 'still' : 'moving'];
    this.#placeOwnArrow();
  }

  /** At a lower corner of the space, in the world. */
  #placeUpArrow() {
    const [x, y, z] = this.#size();
    const corner = new Vector3(-x / 2, y / 2, -z / 2).add(new Vector3(...this.#shift));
    this.#up.group.position.copy(corner.applyMatrix4(TO_WORLD));
  }

  /** At the end of the object's own z, so that a person sees how it has been turned. */
  #placeOwnArrow() {
    const box = this.#packing && this.#bodyBox();
    this.#own.group.visible = box !== null && this.#objectLook !== 'hidden';
    if (!box) return;
    const size = this.#objectSize();
    this.#own.group.position.set((box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, box.max.z);
    this.#own.group.rotation.set(Math.PI / 2, 0, 0);
    this.#own.group.scale.setScalar(size * 0.2);
  }

  #bodyBox() {
    const geometry = this.#selectedBody()?.mesh.geometry;
    if (!geometry?.getAttribute('position')) return null;
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    return geometry.boundingBox;
  }

  #place() {
    this.#apart = this.#packing && apart(this.#packing, this.#opening);
    const layer = (item: number) => this.#packing?.items[item]?.layer ?? 1;
    this.#foams.place((piece) => this.#apart?.piece(piece) ?? 0);
    this.#bodies.forEach(({lift}, item) => lift.position.copy(this.drawnAt(new Vector3(), layer(item))));
    this.#centres.place((place, layer) => this.drawnAt(place, layer));
    for (const {position, userData} of this.#frames.children)
      position.copy(this.drawnAt((userData.middle as Vector3).clone(), userData.layer as number));
  }
}

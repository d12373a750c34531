import {Box3, Group, Matrix4, Raycaster, Scene, Sphere, Vector3, type Mesh} from 'three';
import type {Triple} from '../design/design';
import type {PackedItem, Packing} from '../engine/api';
import type {PlacedItem} from '../state/on_the_page';
import type {Cell, Look, Opened, Part, Section, Spot} from '../state/view.svelte';
import {apart, cornersOf, type Apart} from './apart';
import {CentreMarks, type SeenCentre} from './centre_marks';
import {ColumnMarks} from './column_marks';
import {ContactShadow} from './contact_shadow';
import {FoamMeshes, type PieceColours} from './foam_meshes';
import {arrow, boxEdges, ruler} from './furniture';
import {ItemBodies} from './item_bodies';
import {ItemCaps} from './item_caps';
import {ItemFrames} from './item_frames';
import {NOTHING, type Picked} from './picked';
import {SectionPlane} from './section_plane';
import type {SeenPressure} from './seen_pressure';
import {GLASS} from './shading';
import type {PaintHint, SeenZones} from './zone_paint';

/** Of the space's height. */
const UP_LENGTH = 0.32;

export interface Colours {
  background: string;
  object: string;
  lower: string;
  middle: string;
  upper: string;
  edge: string;
  space: string;
  mark: string;
  zone: string;
  /** Around the item that is selected, and around items that are too near each other. */
  selected: string;
  near: string;
}

/** Design coordinates to the world of three.js: x up, y to the reader, z to the right. */
export const TO_WORLD = new Matrix4().makeBasis(new Vector3(0, 1, 0), new Vector3(0, 0, 1), new Vector3(1, 0, 0));

/** What is in the 3D view, without how it is looked at. */
export class FoamScene {
  readonly scene = new Scene();
  readonly #root = new Group();
  readonly #bodies = new ItemBodies();
  #selected = 0;
  readonly #frames = new ItemFrames();
  readonly #foams = new FoamMeshes();
  readonly #space = boxEdges();
  readonly #column = new ColumnMarks();
  readonly #up = arrow();
  /** On the object, and between any two places. */
  readonly #ruler = ruler();
  readonly #tape = ruler();
  #spots: readonly Spot[] = [];
  readonly #shadow = new ContactShadow();
  readonly #cut = new SectionPlane();
  readonly #itemCaps = new ItemCaps();
  #section: Section | null = null;
  readonly #centres = new CentreMarks();
  #colours: Colours | null = null;
  #packing: Packing | null = null;
  #detailed = false;
  #opening = 0;
  #opened: Opened = 'above';
  /** None while there is no space. */
  #apart: Apart | null = null;
  #shift: Triple = [0, 0, 0];
  #alone = false;
  #marked: Cell | null = null;
  #looks: Record<Part, Look> = {object: 'shown', lower: 'shown', middle: 'shown', upper: 'shown', space: 'shown'};

  constructor() {
    this.#root.matrixAutoUpdate = false;
    this.#root.matrix.copy(TO_WORLD);
    const {group: bodies} = this.#bodies;
    this.#root.add(bodies, this.#frames.group, this.#foams.group, this.#space, this.#column.group, this.#centres.group);
    this.#root.add(this.#tape.group, this.#shadow.group, this.#cut.group);
    this.scene.add(this.#root, this.#up.group, this.#itemCaps.group);
    this.show(null, null);
  }

  /** Corners of boxes around all that is seen, as far apart as it is: of an object by itself where it has no space or is
   *  shown alone. World coordinates. */
  get corners(): Vector3[] {
    const all = this.#packing && !this.#alone ? [...(this.#apart?.corners ?? []), this.#upEnd()] : this.#ownCorners();
    return all.map((corner) => corner.clone().applyMatrix4(this.#root.matrix));
  }

  /** Of the item that is selected. */
  #ownCorners(): Vector3[] {
    const {selected: body, box} = this.#bodies;
    if (!body || !box) return [];
    const item = this.#packing?.items[this.#selected];
    if (!item) return cornersOf(box, body.group.matrix);
    const [low, high] = [new Vector3(...item.bounds.min), new Vector3(...item.bounds.max)];
    return cornersOf(new Box3(low, high), new Matrix4().makeTranslation(body.lift.position));
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
    return this.#apart ? place.add(this.#apart.layer(layer)) : place;
  }

  paint(colours: Colours, words: {up: string}) {
    this.#colours = colours;
    this.#bodies.colour(colours.object, colours.edge, colours.zone);
    this.#foams.paint(colours, colours.edge);
    this.#space.material.color.set(colours.space);
    this.#column.colour(colours.mark);
    this.#up.colour(colours.space);
    this.#up.say(words.up);
    this.#cut.colour(colours.selected);
    this.#itemCaps.colour(colours.object);
  }

  /** The items, each where it lies, and which of them is selected. */
  setItems(placed: readonly PlacedItem[], selected: number) {
    this.#selected = selected;
    this.#bodies.show(placed, selected);
    (this.#bodies.selected?.group ?? this.#root).add(this.#ruler.group);
    this.#place();
  }

  /** Of each item its places to keep off, and what a hand is about to paint on the one that is selected. */
  setZones(seen: readonly SeenZones[], hint: PaintHint | null) {
    this.#bodies.setZones(seen, hint);
  }

  /** What squeezes what; null: not to be seen. */
  set pressure(seen: SeenPressure | null) {
    this.#bodies.pressure = seen;
    this.#foams.pressure = seen?.foam ?? null;
  }

  set centres(seen: readonly SeenCentre[]) {
    this.#centres.see(seen);
    this.#place();
  }

  /** Frames around items: the one that is selected among several, and those that are too near each other. */
  frame(items: readonly PackedItem[], selected: number, near: ReadonlySet<number>) {
    if (this.#colours) this.#frames.show(items, selected, near, this.#colours);
    this.#place();
  }

  /** `colours`: of the pieces, where they are wanted. */
  show(packing: Packing | null, colours: readonly PieceColours[] | null) {
    this.#packing = packing;
    const [x, y, z] = this.#size();
    this.#space.scale.set(x, y, z);
    this.#placeUpArrow();
    this.#up.group.scale.setScalar(Math.max(x, 1) * UP_LENGTH);
    this.#up.group.visible = packing !== null && !this.#alone;
    this.#foams.show(packing, colours);
    this.#place();
  }

  /** Fewer triangles while something moves. */
  set detailed(value: boolean) {
    if (value === this.#detailed) return;
    this.#detailed = value;
    this.#bodies.detailed = this.#foams.detailed = value;
    this.#cutOpen();
  }

  /** Draws everything so much further, design coordinates. */
  set shift(by: Triple) {
    this.#shift = by;
    this.#placeUpArrow();
    this.#root.matrix.copy(TO_WORLD).multiply(new Matrix4().makeTranslation(...by));
    this.#root.matrixWorldNeedsUpdate = true;
  }

  open(opened: Opened, opening: number) {
    [this.#opened, this.#opening] = [opened, opening];
    this.#place();
  }

  set looks(looks: Record<Part, Look>) {
    this.#looks = looks;
    this.#bodies.look = looks.object;
    this.#foams.looks = looks;
    this.#space.material.transparent = looks.space === 'glass';
    this.#space.material.opacity = looks.space === 'glass' ? GLASS : 1;
    this.#place();
  }

  /** Nothing but the item that is selected. */
  get alone(): boolean {
    return this.#alone;
  }

  set alone(value: boolean) {
    this.#alone = this.#bodies.alone = value;
    this.#up.group.visible = this.#packing !== null && !value;
    this.#place();
  }

  /** Without frames, marks and knobs. */
  get bare(): boolean {
    return !this.#frames.group.visible;
  }

  set bare(value: boolean) {
    for (const {group} of [this.#frames, this.#column]) group.visible = !value;
    this.#cut.bare = value;
  }

  /** What is taken away before a plane; null: nothing. */
  set section(section: Section | null) {
    this.#section = section;
    const planes = section && [this.#cut.plane];
    this.#bodies.clip(planes);
    this.#foams.clip(planes);
    this.#shadow.clip(planes);
    this.#place();
  }

  /** Where its knob is, and a mm further along its way; world coordinates. */
  get knob(): {at: Vector3; further: Vector3} | null {
    if (!this.#cut.group.visible) return null;
    const {knob, along} = this.#cut;
    return {at: knob.clone().applyMatrix4(this.#root.matrix), further: knob.clone().add(along).applyMatrix4(this.#root.matrix)};
  }

  /** The share of its way that lies so many mm further. */
  sectionAfter(share: number, mm: number): number {
    return this.#cut.further(share, mm);
  }

  mark(cell: Cell | null) {
    this.#marked = cell;
    this.#column.show(cell, this.#packing, this.#apart);
  }

  measure(points: readonly Triple[]) {
    this.#ruler.show(points, this.#objectSize() * 0.012);
  }

  /** Between places on whatever is seen. */
  set spots(spots: readonly Spot[]) {
    this.#spots = spots;
    const [x, y, z] = this.#size();
    this.#tape.show(spots.map((spot) => this.#spotAt(spot).toArray()), Math.max(x, y, z) * 0.01);
  }

  /** Where a place on something is drawn, world coordinates. */
  drawnSpot(spot: Spot): Vector3 {
    return this.#spotAt(spot).applyMatrix4(this.#root.matrix);
  }

  #spotAt({on, at}: Spot): Vector3 {
    const place = new Vector3(...at);
    if ('item' in on) return this.drawnAt(place, this.#packing?.items[on.item]?.layer ?? 1);
    return this.#apart ? place.applyMatrix4(this.#apart.piece(on.piece)) : place;
  }

  /** What lies under a point of the picture (-1 to 1): on the object in its own mm, and the column of the space. */
  pick(ray: Raycaster): Picked {
    const bodies = this.#bodies.all;
    const targets = [...bodies.map(({mesh}) => mesh).filter(({visible}) => visible), ...this.#foams.visible];
    const left = ({point}: {point: Vector3}) => !this.#section || this.#cut.plane.distanceToPoint(point) >= 0;
    const hits = ray.intersectObjects<Mesh>(targets, false).filter(left);
    const [hit] = hits;
    if (!hit) return NOTHING;
    const item = bodies.findIndex(({mesh}) => mesh === hit.object);
    // Where an item is cut open, its inside is seen: an odd number of its faces lies behind.
    const inside = this.#section && item >= 0 && hits.filter(({object}) => object === hit.object).length % 2 === 1;
    const point = (inside && ray.ray.intersectPlane(this.#cut.plane, new Vector3())) || hit.point;
    const own = bodies[item]?.group.worldToLocal(point.clone()).toArray() ?? null;
    // As it lies in the space, wherever it is drawn.
    const design = (bodies[item]?.lift ?? hit.object).worldToLocal(point.clone());
    const part = (own && hit.face && hit.object.geometry.getAttribute('part')?.getX(hit.face.a)) || 0;
    const spot: Spot = {on: own ? {item} : {piece: this.#foams.pieceOf(hit.object)}, at: design.toArray()};
    return {own, cell: this.#cellAt(design), item: own ? item : null, part, spot};
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
    return (this.#bodies.sphere?.radius ?? 0) * 2;
  }

  /** Beside the word at its end, design coordinates. */
  #upEnd(): Vector3 {
    const [x, y, z] = this.#size();
    return new Vector3(-x / 2, y / 2, -z / 2).addScaledVector(new Vector3(1.3, 0, -0.35), x * UP_LENGTH);
  }

  /** At a lower corner of the space, in the world. */
  #placeUpArrow() {
    const [x, y, z] = this.#size();
    const corner = new Vector3(-x / 2, y / 2, -z / 2).add(new Vector3(...this.#shift));
    this.#up.group.position.copy(corner.applyMatrix4(TO_WORLD));
  }

  #place() {
    this.#apart = this.#packing && apart(this.#packing, this.#opened, this.#opening);
    const layer = (item: number) => this.#packing?.items[item]?.layer ?? 1;
    const drawnAt = (place: Vector3, of: number) => this.drawnAt(place, of);
    this.#foams.place((piece) => this.#apart?.piece(piece) ?? new Matrix4());
    this.#bodies.all.forEach(({lift}, item) => lift.position.copy(this.drawnAt(new Vector3(), layer(item))));
    this.#centres.place(drawnAt);
    this.#frames.place(drawnAt);
    this.#column.show(this.#marked, this.#packing, this.#apart);
    this.spots = this.#spots;
    // An object by itself lies wherever its file has it, in no space, and nor do pieces that lie beside each other.
    this.#space.visible = this.#looks.space !== 'hidden' && this.#packing !== null && (this.#opened === 'above' || this.#opening === 0);
    this.#shadow.group.visible = this.#apart !== null && !this.#alone;
    if (this.#apart) this.#shadow.place(this.#apart.corners);
    this.#cutOpen();
  }

  #cutOpen() {
    const corners = this.#section && this.#apart ? this.#apart.corners : null;
    this.#cut.group.visible = corners !== null;
    if (this.#section && corners) this.#cut.place(this.#section, corners);
    this.#foams.cap(corners && this.#cut.own);
    this.#cut.plane.copy(this.#cut.own).applyMatrix4(this.#root.matrix);
    const all = new Sphere().setFromPoints(corners ? [...corners] : []).applyMatrix4(this.#root.matrix);
    // Glass is not filled.
    const filled = this.#looks.object === 'shown' ? this.#bodies.visible : [];
    this.#itemCaps.show(filled, corners && this.#cut.plane, all.center, all.radius);
  }
}

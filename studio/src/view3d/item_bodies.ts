import {Box3, BufferGeometry, Group, Mesh, type Plane, type ShaderMaterial, type Sphere} from 'three';
import type {DisplayMesh} from '../engine/api';
import type {PlacedItem} from '../state/on_the_page';
import type {Look} from '../state/view.svelte';
import {objectGeometry} from './object_geometry';
import {PressurePaint} from './pressure_paint';
import type {SeenPressure} from './seen_pressure';
import {objectShading} from './shading';
import {ZonePaint, type PaintHint, type SeenZones} from './zone_paint';

export interface Body {
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

/** The items in the 3D view. */
export class ItemBodies {
  readonly group = new Group();
  readonly #shade = objectShading();
  #bodies: Body[] = [];
  #selected = 0;
  /** By the copy that was drawn. */
  #geometries = new Map<DisplayMesh, BufferGeometry>();
  #detailed = false;
  #look: Look = 'shown';
  #alone = false;

  constructor() {
    this.#shade.material.polygonOffset = false;
  }

  get all(): readonly Body[] {
    return this.#bodies;
  }

  get selected(): Body | undefined {
    return this.#bodies[this.#selected] ?? this.#bodies[0];
  }

  /** Around the selected one, in its object's own coordinates. */
  get sphere(): Sphere | null {
    const geometry = this.selected?.mesh.geometry;
    if (!geometry?.getAttribute('position')) return null;
    if (!geometry.boundingSphere) geometry.computeBoundingSphere();
    return geometry.boundingSphere;
  }

  get box(): Box3 | null {
    const geometry = this.selected?.mesh.geometry;
    if (!geometry?.getAttribute('position')) return null;
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    return geometry.boundingBox;
  }

  colour(face: string, edge: string, zone: string) {
    this.#shade.colour(face, edge, zone);
  }

  /** Each where it lies, and which of them is selected. */
  show(placed: readonly PlacedItem[], selected: number) {
    const meshes = new Set(placed.flatMap(({meshes: {moving, still}}) => [moving, still]));
    for (const [mesh, geometry] of this.#geometries)
      if (!meshes.has(mesh)) {
        geometry.dispose();
        this.#geometries.delete(mesh);
      }
    while (this.#bodies.length > placed.length) {
      const {lift, paint, pressure} = this.#bodies.pop()!;
      this.group.remove(lift);
      paint.dispose();
      pressure.dispose();
    }
    placed.forEach(({meshes: {moving, still}, placement}, i) => {
      const body = (this.#bodies[i] ??= this.#join());
      body.geometries = {moving: this.#geometry(moving), still: this.#geometry(still)};
      body.deviation = Math.max(moving.deviation, still.deviation);
      body.group.matrix.fromArray([...placement]);
      body.group.matrixWorldNeedsUpdate = true;
    });
    this.#selected = selected;
    this.#uncover();
    this.#dress();
  }

  #join(): Body {
    const mesh = new Mesh(new BufferGeometry(), this.#shade.material);
    const [lift, group] = [new Group(), new Group()];
    group.matrixAutoUpdate = false;
    lift.add(group.add(mesh));
    this.group.add(lift);
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

  /** Of each its places to keep off, and what a hand is about to paint on the selected one. */
  setZones(seen: readonly SeenZones[], hint: PaintHint | null) {
    this.#bodies.forEach(({paint}, i) => {
      paint.see(seen[i]);
      paint.hint = i === this.#selected ? hint : null;
    });
  }

  set pressure(seen: SeenPressure | null) {
    this.#bodies.forEach(({pressure}, i) => pressure.see(seen?.items[i] ?? null));
  }

  /** Fewer triangles while something moves. */
  set detailed(value: boolean) {
    this.#detailed = value;
    this.#dress();
  }

  set look(look: Look) {
    this.#look = look;
    this.#shade.look(look);
    this.#uncover();
  }

  /** Nothing but the selected one. */
  set alone(value: boolean) {
    this.#alone = value;
    this.#uncover();
  }

  /** Those that are seen. */
  get visible(): readonly Mesh[] {
    return this.#bodies.map(({mesh}) => mesh).filter(({visible}) => visible);
  }

  /** What lies behind these is seen, world coordinates. */
  clip(planes: Plane[] | null) {
    this.#shade.material.clippingPlanes = planes;
  }

  #uncover() {
    const {selected} = this;
    for (const body of this.#bodies) body.mesh.visible = this.#look !== 'hidden' && (!this.#alone || body === selected);
  }

  #dress() {
    for (const {mesh, geometries} of this.#bodies) mesh.geometry = geometries[this.#detailed ? 'still' : 'moving'];
  }
}

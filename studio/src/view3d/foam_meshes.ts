import {BufferAttribute, BufferGeometry, Group, Mesh, type Matrix4, type Plane, type ShaderMaterial} from 'three';
import type {Packing} from '../engine/api';
import {kindOf, type PieceKind} from '../engine/pieces';
import type {Look} from '../state/view.svelte';
import {CapMeshes} from './cap_meshes';
import {foamQuads, type Quads} from './foam_geometry';
import {PadPlates} from './pad_plates';
import type {PressureGrid} from './pressure_grid';
import {PressurePaint} from './pressure_paint';
import {foamShading, type Shading} from './shading';

/** What may be drawn of all pieces together: while something moves, with the objects' own copies besides, and later. */
const MOVING_TRIANGLES = 9_000;
const STILL_TRIANGLES = 400_000;

/** Of a piece the quads of its blocks' faces, and how far each is from the objects (0 to 1, -1 not said). */
export interface PieceColours {
  quads: Quads;
  shares: Float32Array;
}

type FoamMesh = Mesh<BufferGeometry, ShaderMaterial>;

/** The pieces of foam in the 3D view, the lowest first, with the pads that lie on them. */
export class FoamMeshes {
  readonly group = new Group();
  readonly #shades: Record<PieceKind, Shading> = {lower: foamShading(), middle: foamShading(), upper: foamShading()};
  readonly #pressure = new PressurePaint();
  readonly #pads = new PadPlates();
  readonly #caps = new CapMeshes();
  #meshes: FoamMesh[] = [];
  #quads: Quads[] = [];
  #packing: Packing | null = null;
  #colours: readonly PieceColours[] | null = null;
  #detailed = false;
  #looks: Record<PieceKind, Look> = {lower: 'shown', middle: 'shown', upper: 'shown'};

  constructor() {
    this.group.add(this.#pads.group, this.#caps.group);
  }

  /** Those pieces that are seen, and where they are cut open. */
  get visible(): readonly Mesh[] {
    return [...this.#meshes, ...this.#caps.meshes].filter(({visible}) => visible);
  }

  paint(colours: Record<PieceKind, string>, edge: string) {
    for (const [kind, shade] of this.#kinds()) shade.colour(colours[kind], edge);
    this.#pads.paint(colours, edge);
  }

  /** `colours`: of each piece, where they are wanted. */
  show(packing: Packing | null, colours: readonly PieceColours[] | null) {
    this.#packing = packing;
    this.#colours = colours;
    const count = packing?.pieces.length ?? 0;
    while (this.#meshes.length > count) this.#leave(this.#meshes.pop()!);
    while (this.#meshes.length < count) this.#meshes.push(this.#join());
    this.#quads.length = count;
    this.#meshes.forEach((mesh, piece) => {
      mesh.material = this.#shades[this.#kind(piece)].material;
      this.#build(piece);
    });
    this.#pads.show(packing?.pads ?? [], (piece) => this.#kind(piece));
    this.#dress();
  }

  /** How much it is squeezed; null: not to be seen. */
  set pressure(grid: PressureGrid | null) {
    this.#pressure.see(grid);
    for (const [, {material}] of this.#kinds()) this.#pressure.apply(material);
  }

  /** Fewer triangles while something moves. */
  set detailed(value: boolean) {
    if (value === this.#detailed) return;
    this.#detailed = value;
    // A coarser drawing is refined, and a finer one coarsened, only where there is a difference.
    this.#quads.forEach(({coarsened, indices}, piece) => {
      if (coarsened > 1 || (!value && indices.length / 3 > this.#most)) this.#build(piece);
    });
  }

  set looks(looks: Record<PieceKind, Look>) {
    this.#looks = looks;
    for (const [kind, shade] of this.#kinds()) shade.look(looks[kind]);
    this.#pads.looks = looks;
    this.#dress();
  }

  /** What lies behind these is seen, world coordinates. */
  clip(planes: Plane[] | null) {
    for (const [, {material}] of this.#kinds()) material.clippingPlanes = planes;
    this.#pads.clip(planes);
  }

  /** Fills what a plane cuts open. `plane`: in design coordinates as everything is drawn; null: none cuts. */
  cap(plane: Plane | null) {
    this.#caps.show(this.#packing, plane, this.#meshes);
  }

  /** Which one it is, from the lowest. */
  pieceOf(mesh: Mesh): number {
    return Math.max(this.#meshes.indexOf(mesh as FoamMesh), this.#caps.meshes.indexOf(mesh));
  }

  /** `at`: where a piece is drawn, from where it lies. */
  place(at: (piece: number) => Matrix4) {
    this.#meshes.forEach((mesh, piece) => {
      mesh.matrix.copy(at(piece));
      mesh.matrixWorldNeedsUpdate = true;
    });
    this.#pads.place(at);
  }

  #kinds(): [PieceKind, Shading][] {
    return Object.entries(this.#shades) as [PieceKind, Shading][];
  }

  #kind(piece: number): PieceKind {
    return this.#packing ? kindOf(this.#packing, piece) : 'lower';
  }

  #join(): FoamMesh {
    const mesh = new Mesh(new BufferGeometry(), this.#shades.lower.material);
    // Glass over the objects, not under them.
    mesh.renderOrder = 2;
    mesh.matrixAutoUpdate = false;
    this.group.add(mesh);
    return mesh;
  }

  #leave(mesh: FoamMesh) {
    mesh.geometry.dispose();
    this.group.remove(mesh);
  }

  #dress() {
    this.#meshes.forEach((mesh, piece) => (mesh.visible = this.#looks[this.#kind(piece)] !== 'hidden'));
  }

  /** Of one piece; a tray alone gets no more than one of two. */
  get #most(): number {
    return (this.#detailed ? STILL_TRIANGLES : MOVING_TRIANGLES) / Math.max(this.#meshes.length, 2);
  }

  #build(piece: number) {
    const mesh = this.#meshes[piece];
    if (!this.#packing || !mesh) return;
    const coloured = this.#colours?.[piece];
    const quads = coloured?.quads ?? foamQuads(this.#packing, piece, this.#most);
    this.#quads[piece] = quads;
    mesh.geometry.dispose();
    mesh.geometry = new BufferGeometry();
    mesh.geometry.setAttribute('position', new BufferAttribute(quads.positions, 3));
    mesh.geometry.setAttribute('normal', new BufferAttribute(quads.normals, 3, true));
    mesh.geometry.setAttribute('inner', new BufferAttribute(quads.inner, 1));
    mesh.geometry.setIndex(new BufferAttribute(quads.indices, 1));
    const {uniforms} = mesh.material;
    const {blocks, block_mm} = this.#packing;
    uniforms.block?.value.set(...block_mm);
    uniforms.corner?.value.set(...blocks.map((count, axis) => (-count * block_mm[axis]!) / 2));
    if (uniforms.showGaps) uniforms.showGaps.value = coloured ? 1 : 0;
    if (!coloured) return;
    const corners = new Float32Array(quads.inner.length);
    corners.forEach((_, i) => (corners[i] = coloured.shares[i >> 2] ?? -1));
    mesh.geometry.setAttribute('gap', new BufferAttribute(corners, 1));
  }
}

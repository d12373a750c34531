import {BufferAttribute, BufferGeometry, Group, Matrix3, Mesh, Vector3, type Matrix4, type Plane, type ShaderMaterial} from 'three';
import type {Packing} from '../engine/api';
import {foamCap, type Cut} from './foam_caps';

/** What a piece is drawn with, and where; it wears its own material where it is cut, too. */
export interface CutPiece {
  material: ShaderMaterial;
  matrix: Matrix4;
  visible: boolean;
}

/** Lighter than what was a face before. */
const FRESH = -1;
const ALONG_AN_AXIS = 0.9999;

/** Where a plane cuts the pieces of foam open. */
export class CapMeshes {
  readonly group = new Group();
  #meshes: Mesh<BufferGeometry, ShaderMaterial>[] = [];

  /** Those that are seen; in the order of the pieces. */
  get meshes(): readonly Mesh[] {
    return this.#meshes;
  }

  /** `plane`: in design coordinates as everything is drawn, facing what is left; null: none cuts. */
  show(packing: Packing | null, plane: Plane | null, pieces: readonly CutPiece[]) {
    const wanted = packing && plane ? pieces.length : 0;
    while (this.#meshes.length > wanted) {
      const mesh = this.#meshes.pop()!;
      mesh.geometry.dispose();
      this.group.remove(mesh);
    }
    if (!packing || !plane) return;
    pieces.forEach(({material, matrix, visible}, piece) => {
      const mesh = (this.#meshes[piece] ??= this.#join(material));
      mesh.material = material;
      mesh.matrix.copy(matrix);
      mesh.matrixWorldNeedsUpdate = true;
      const cut = visible ? cutOf(plane, matrix) : null;
      const cap = cut && foamCap(packing, piece, cut);
      mesh.visible = cap !== null;
      if (!cap) return;
      mesh.geometry.dispose();
      mesh.geometry = new BufferGeometry();
      mesh.geometry.setAttribute('position', new BufferAttribute(cap.positions, 3));
      mesh.geometry.setAttribute('normal', new BufferAttribute(cap.normals, 3, true));
      const corners = cap.positions.length / 3;
      mesh.geometry.setAttribute('inner', new BufferAttribute(new Int8Array(corners).fill(FRESH), 1));
      mesh.geometry.setAttribute('gap', new BufferAttribute(new Int8Array(corners).fill(-1), 1));
      mesh.geometry.setIndex(new BufferAttribute(cap.indices, 1));
    });
  }

  #join(material: ShaderMaterial) {
    const mesh = new Mesh(new BufferGeometry(), material);
    mesh.matrixAutoUpdate = false;
    mesh.renderOrder = 2;
    this.group.add(mesh);
    return mesh;
  }
}

/** Where a plane lies in a piece that is drawn elsewhere; null: it cuts askew, as while a lid is turned. */
function cutOf(plane: Plane, drawn: Matrix4): Cut | null {
  const own = plane.clone().applyMatrix4(drawn.clone().invert(), new Matrix3().getNormalMatrix(drawn.clone().invert()));
  const axis = ([0, 1, 2] as const).find((each) => Math.abs(own.normal.getComponent(each)) > ALONG_AN_AXIS);
  if (axis === undefined) return null;
  return {axis, at: own.coplanarPoint(new Vector3()).getComponent(axis), facing: own.normal.getComponent(axis) > 0 ? -1 : 1};
}

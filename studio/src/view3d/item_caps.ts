import {
  AlwaysStencilFunc,
  BackSide,
  DecrementWrapStencilOp,
  FrontSide,
  Group,
  IncrementWrapStencilOp,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  PlaneGeometry,
  Vector3,
  ZeroStencilOp,
  type BufferGeometry,
  type Plane,
} from 'three';

/** From the plane to the side that is left, so that it is no part of what is taken away. */
const BEHIND_MM = 0.02;
/** Darker than the object. */
const TONE = 0.66;

/** Where a plane cuts items open: wherever it is more often in than out of their surfaces, counted in the stencil. */
export class ItemCaps {
  /** In the world. */
  readonly group = new Group();
  readonly #into = counting(BackSide);
  readonly #outOf = counting(FrontSide);
  readonly #cap: Mesh<PlaneGeometry, MeshBasicMaterial>;
  #counts: Mesh[] = [];

  constructor() {
    const material = new MeshBasicMaterial({stencilWrite: true, stencilRef: 0, stencilFunc: NotEqualStencilFunc, stencilFail: ZeroStencilOp, stencilZFail: ZeroStencilOp, stencilZPass: ZeroStencilOp});
    this.#cap = new Mesh(new PlaneGeometry(1, 1), material);
    this.#cap.renderOrder = 1.5;
    this.group.add(this.#cap);
    this.group.visible = false;
  }

  colour(value: string) {
    this.#cap.material.color.set(value).multiplyScalar(TONE);
  }

  /** `bodies`: what is cut. `plane`: in the world, facing what is left; null: none cuts. `size`: of all that is seen. */
  show(bodies: readonly Mesh[], plane: Plane | null, middle: Vector3, size: number) {
    for (const count of this.#counts.splice(0)) count.removeFromParent();
    this.group.visible = plane !== null && bodies.length > 0;
    if (!plane) return;
    for (const body of bodies) this.#counts.push(this.#count(body.geometry, this.#into, body), this.#count(body.geometry, this.#outOf, body));
    for (const material of [this.#into, this.#outOf]) material.clippingPlanes = [plane];
    this.#cap.position.copy(plane.projectPoint(middle, new Vector3())).addScaledVector(plane.normal, BEHIND_MM);
    this.#cap.lookAt(this.#cap.position.clone().sub(plane.normal));
    this.#cap.scale.setScalar(2 * size);
  }

  #count(geometry: BufferGeometry, material: MeshBasicMaterial, body: Mesh) {
    const mesh = new Mesh(geometry, material);
    mesh.renderOrder = 1;
    body.add(mesh);
    return mesh;
  }
}

function counting(side: typeof BackSide | typeof FrontSide): MeshBasicMaterial {
  const operation = side === BackSide ? IncrementWrapStencilOp : DecrementWrapStencilOp;
  const material = new MeshBasicMaterial({side, colorWrite: false, depthWrite: false, depthTest: false, stencilWrite: true, stencilFunc: AlwaysStencilFunc});
  material.stencilFail = material.stencilZFail = material.stencilZPass = operation;
  return material;
}

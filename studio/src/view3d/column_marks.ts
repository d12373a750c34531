import {Group, Matrix4, Vector3} from 'three';
import type {Packing} from '../engine/api';
import type {Cell} from '../state/view.svelte';
import {levelsOf, type Apart} from './apart';
import {boxEdges} from './furniture';

/** The column under the pointer, on each piece of foam. */
export class ColumnMarks {
  readonly group = new Group();
  #boxes: ReturnType<typeof boxEdges>[] = [];
  #colour = '#000';

  colour(value: string) {
    this.#colour = value;
    for (const {material} of this.#boxes) material.color.set(value);
  }

  show(cell: Cell | null, packing: Packing | null, apart: Apart | null) {
    const levels = packing && cell ? levelsOf(packing) : [];
    this.#count(levels.length);
    if (!cell || !packing || !apart) return;
    const {middle, size} = columnOf(packing, cell);
    levels.forEach(([low, high], piece) => {
      const {matrix} = this.#boxes[piece]!;
      middle.setX((low + high) / 2);
      matrix.copy(apart.piece(piece)).multiply(new Matrix4().makeTranslation(middle)).scale(size.setX(Math.max(high - low, 1e-3)));
    });
  }

  #count(wanted: number) {
    while (this.#boxes.length < wanted) this.#boxes.push(this.#join());
    this.#boxes.forEach((box, i) => (box.visible = i < wanted));
  }

  #join() {
    const box = boxEdges();
    box.matrixAutoUpdate = false;
    box.material.depthTest = false;
    box.material.color.set(this.#colour);
    box.renderOrder = 9;
    this.group.add(box);
    return box;
  }
}

/** Of a column across the space; x as it is on each piece. */
function columnOf({blocks: [, ny, nz], block_mm: [, sy, sz]}: Packing, {j, k}: Cell): {middle: Vector3; size: Vector3} {
  return {middle: new Vector3(0, (j + 0.5 - ny / 2) * sy, (k + 0.5 - nz / 2) * sz), size: new Vector3(0, sy, sz)};
}

import {Group, Vector3} from 'three';
import type {PackedItem} from '../engine/api';
import {boxEdges} from './furniture';

/** Around an item. */
const FRAME_MM = 1;

/** Frames around items: the one that is selected among several, and those that are too near each other. */
export class ItemFrames {
  readonly group = new Group();
  #frames: {edges: ReturnType<typeof boxEdges>; layer: number; middle: Vector3}[] = [];

  show(items: readonly PackedItem[], selected: number, near: ReadonlySet<number>, colours: {selected: string; near: string}) {
    const framed = items.length < 2 ? [] : [...items.keys()].filter((i) => i === selected || near.has(i));
    while (this.#frames.length > framed.length) {
      const {edges} = this.#frames.pop()!;
      edges.geometry.dispose();
      edges.material.dispose();
      this.group.remove(edges);
    }
    this.#frames = framed.map((i, at) => {
      const {bounds, layer} = items[i]!;
      const edges = this.#frames[at]?.edges ?? this.#join();
      edges.material.color.set(near.has(i) ? colours.near : colours.selected);
      const [low, high] = [new Vector3(...bounds.min), new Vector3(...bounds.max)];
      const middle = low.clone().add(high).multiplyScalar(0.5);
      edges.scale.copy(high.sub(low)).addScalar(2 * FRAME_MM);
      return {edges, layer, middle};
    });
  }

  #join() {
    const edges = boxEdges();
    edges.material.depthTest = false;
    edges.renderOrder = 8;
    this.group.add(edges);
    return edges;
  }

  /** `drawnAt`: where a place of a layer is drawn. */
  place(drawnAt: (place: Vector3, layer: number) => Vector3) {
    for (const {edges, layer, middle} of this.#frames) edges.position.copy(drawnAt(middle.clone(), layer));
  }
}

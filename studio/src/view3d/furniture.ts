import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CanvasTexture,
  ConeGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Sprite,
  SRGBColorSpace,
  SpriteMaterial,
} from 'three';
import type {Triple} from '../design/design';

// What stands around the foams: the space, arrows, words, the column under the pointer.

export function boxEdges(): LineSegments<EdgesGeometry, LineBasicMaterial> {
  return new LineSegments(new EdgesGeometry(new BoxGeometry(1, 1, 1)), new LineBasicMaterial());
}

/** An arrow of length 1 along +y with a word at its tip. */
export function arrow(): {group: Group; colour(value: string): void; say(word: string): void} {
  const material = new MeshBasicMaterial();
  const shaft = new Mesh(new CylinderGeometry(0.022, 0.022, 0.72, 12).translate(0, 0.36, 0), material);
  const head = new Mesh(new ConeGeometry(0.075, 0.28, 20).translate(0, 0.86, 0), material);
  const label = new Sprite(new SpriteMaterial({depthTest: false, transparent: true}));
  label.position.set(0, 1.18, 0);
  const group = new Group();
  group.add(shaft, head, label);
  let [word, colour] = ['', '#000'];
  const draw = () => {
    label.material.map?.dispose();
    const {texture, aspect} = writing(word, colour);
    label.material.map = texture;
    label.material.needsUpdate = true;
    label.scale.set(0.26 * aspect, 0.26, 1);
  };
  return {
    group,
    colour(value) {
      material.color.set(value);
      colour = value;
      draw();
    },
    say(text) {
      word = text;
      draw();
    },
  };
}

/** A word as a picture; `aspect`: its width by its height. */
export function writing(word: string, colour: string): {texture: CanvasTexture; aspect: number} {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('2d');
  const height = 64;
  const font = '600 44px system-ui, sans-serif';
  if (context) context.font = font;
  canvas.width = Math.ceil(context?.measureText(word).width ?? 64) + 16;
  canvas.height = height;
  if (context) {
    context.font = font;
    context.fillStyle = colour;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    context.fillText(word, canvas.width / 2, height / 2);
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return {texture, aspect: canvas.width / height};
}

/** Two clicks and the line between them, drawn over everything. */
export function ruler(): {group: Group; show(points: readonly Triple[], size: number): void} {
  const line = new LineSegments(
    new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(6), 3)),
    new LineBasicMaterial({color: '#d6336c', depthTest: false}),
  );
  line.frustumCulled = false;
  const ball = () =>
    new Mesh(new BoxGeometry(1, 1, 1), new MeshBasicMaterial({color: '#d6336c', depthTest: false}));
  const ends = [ball(), ball()];
  const group = new Group();
  group.add(line, ...ends);
  group.renderOrder = 10;
  return {
    group,
    show(points, size) {
      ends.forEach((end, i) => {
        const point = points[i];
        end.visible = point !== undefined;
        if (point) end.position.set(...point);
        end.scale.setScalar(size);
      });
      line.visible = points.length === 2;
      const placed = line.geometry.getAttribute('position') as BufferAttribute;
      if (points.length === 2) placed.copyArray(points.flat()).needsUpdate = true;
    },
  };
}

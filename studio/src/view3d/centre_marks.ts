import {CanvasTexture, Group, Sprite, SpriteMaterial, SRGBColorSpace, Vector3} from 'three';
import type {Triple} from '../design/design';

/** An item's centre of mass, design coordinates. */
export interface SeenCentre {
  at: Triple;
  layer: number;
}

/** Of the picture's height. */
const SIZE = 0.018;

/** Where the centres of mass are taken to be, as drawings mark them, over everything and of one size. */
export class CentreMarks {
  readonly group = new Group();
  #material: SpriteMaterial | null = null;
  #centres: readonly SeenCentre[] = [];

  see(centres: readonly SeenCentre[]) {
    this.#centres = centres;
    while (this.group.children.length > centres.length) this.group.remove(this.group.children.at(-1)!);
    while (this.group.children.length < centres.length) this.group.add(this.#mark());
  }

  /** `drawnAt`: where a place of a layer is drawn. */
  place(drawnAt: (place: Vector3, layer: number) => Vector3) {
    this.#centres.forEach(({at, layer}, i) => this.group.children[i]!.position.copy(drawnAt(new Vector3(...at), layer)));
  }

  #mark(): Sprite {
    this.#material ??= new SpriteMaterial({map: drawn(), depthTest: false, transparent: true, sizeAttenuation: false});
    const mark = new Sprite(this.#material);
    mark.scale.setScalar(SIZE);
    mark.renderOrder = 9;
    return mark;
  }
}

/** A disc in quarters of black and white. */
function drawn(): CanvasTexture {
  const side = 64;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = side;
  const context = canvas.getContext('2d');
  if (context) {
    const middle = side / 2;
    for (let quarter = 0; quarter < 4; quarter++) {
      context.fillStyle = quarter % 2 === 0 ? '#111' : '#fff';
      context.beginPath();
      context.moveTo(middle, middle);
      context.arc(middle, middle, middle - 4, (quarter * Math.PI) / 2, ((quarter + 1) * Math.PI) / 2);
      context.fill();
    }
    context.lineWidth = 4;
    context.strokeStyle = '#111';
    context.beginPath();
    context.arc(middle, middle, middle - 4, 0, 2 * Math.PI);
    context.stroke();
  }
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  return texture;
}

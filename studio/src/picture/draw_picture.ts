import type {Picture} from './thumbnail';

/** A Svelte action: draws a picture as large as it is. */
export function drawPicture(canvas: HTMLCanvasElement, {size, pixels}: Picture) {
  canvas.width = size;
  canvas.height = size;
  canvas.getContext('2d')?.putImageData(new ImageData(pixels, size, size), 0, 0);
}

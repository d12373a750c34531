import type {Studio} from '../state/studio.svelte';
import {size} from '../words/figures';
import type {Texts} from '../words/texts';
import {download, stem} from './save_files';

// A picture to be put into a loan form or a condition report: as it is seen, on white, with what it shows below.

const INK = '#18212c';
const SOFT_INK = '#566273';
/** Of the picture's width. */
const MARGIN = 0.03;
const LINE = 0.026;
const FONTS = "system-ui, 'Hiragino Sans', 'Noto Sans CJK JP', 'Noto Sans JP', IPAGothic, sans-serif";

/** `seen`: as it is drawn, clear where nothing is. `language`: of the date. */
export async function savePicture(studio: Studio, seen: HTMLCanvasElement, texts: Texts, language: string): Promise<void> {
  const lines = [named(studio), sizes(studio, texts), new Date().toLocaleDateString(language, {dateStyle: 'long'})];
  const picture = composed(seen, lines.filter((line) => line !== ''));
  const blob = await new Promise<Blob | null>((resolve) => picture.toBlob(resolve, 'image/png'));
  if (blob) download(`${stem(studio)}.png`, [new Uint8Array(await blob.arrayBuffer())]);
}

function named({objects}: Studio): string {
  return [...new Set(objects.map(({file}) => file.name.replace(/\.[^.]+$/, '')))].join(', ');
}

/** Of the only object and of its foam. */
function sizes({objects, packing}: Studio, {view3d: {picture: t}}: Texts): string {
  const object = objects.length === 1 ? objects[0]?.size_mm : null;
  const foam = packing?.fit ? packing.blocks.map((count, axis) => count * packing.block_mm[axis]!) : null;
  return [object ? t.object(size(object)) : '', foam ? t.foam(size(foam)) : ''].filter((text) => text !== '').join(t.between);
}

function composed(whole: HTMLCanvasElement, lines: readonly string[]): HTMLCanvasElement {
  const canvas = document.createElement('canvas');
  const margin = Math.round(whole.width * MARGIN);
  const seen = trimmed(whole, margin);
  const line = Math.max(Math.round(seen.width * LINE), 22);
  canvas.width = seen.width;
  canvas.height = seen.height + lines.length * line * 1.5 + margin;
  const pen = canvas.getContext('2d');
  if (!pen) return canvas;
  pen.fillStyle = '#fff';
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(seen, 0, 0);
  pen.textBaseline = 'top';
  lines.forEach((text, i) => {
    pen.fillStyle = i === 0 ? INK : SOFT_INK;
    pen.font = `${i === 0 ? 600 : 400} ${line}px ${FONTS}`;
    pen.fillText(text, margin, seen.height + i * line * 1.5, canvas.width - 2 * margin);
  });
  return canvas;
}

/** Without the rows above and below in which nothing is, but for a margin. */
function trimmed(whole: HTMLCanvasElement, margin: number): HTMLCanvasElement {
  const {width, height} = whole;
  const pixels = whole.getContext('2d')?.getImageData(0, 0, width, height).data ?? [];
  const drawn = (row: number) => {
    for (let at = row * width * 4 + 3; at < (row + 1) * width * 4; at += 4) if (pixels[at]! > 0) return true;
    return false;
  };
  let [first, end] = [0, height];
  while (first < end && !drawn(first)) first++;
  while (end > first && !drawn(end - 1)) end--;
  if (first === end) return whole;
  const [top, bottom] = [Math.max(first - margin, 0), Math.min(end + margin, height)];
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width, bottom - top];
  canvas.getContext('2d')?.drawImage(whole, 0, -top);
  return canvas;
}

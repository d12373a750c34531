import type {Studio} from '../state/studio.svelte';
import {drawItemNumbers, drawMap, drawMarks, drawNumbers, drawOutlines} from '../view2d/draw';
import {PRINT_INK} from '../view2d/ink';
import {itemsIn, layOut, mapsOf, said} from '../view2d/page';
import {size} from '../words/figures';
import type {Texts} from '../words/texts';

/** Pixels of a drawing on paper; about 250 to the inch on A4. */
const WIDTH = 1900;
const HEIGHT = 2300;
const SCALE = 2.5;

/** Fills the sheets that only a printer sees (see index.html and app.css) and asks the browser to print. */
export async function printMaps(studio: Studio, texts: Texts): Promise<void> {
  const sheets = document.getElementById('print');
  const {packing, placed} = studio;
  const items = placed.map(({meshes, placement}) => ({mesh: meshes.still, placement}));
  if (!sheets || !packing?.fit) return;
  const pages = mapsOf(packing).map((map) => {
    const told = itemsIn(packing, map, 0);
    const canvas = document.createElement('canvas');
    [canvas.width, canvas.height] = [WIDTH, HEIGHT];
    const pen = canvas.getContext('2d');
    if (pen) {
      pen.setTransform(SCALE, 0, 0, SCALE, 0, 0);
      const page = layOut(packing, map, WIDTH / SCALE, HEIGHT / SCALE, 24);
      drawMap(pen, page, packing, map, PRINT_INK);
      drawOutlines(pen, page, packing, items.filter((_, i) => told.includes(i)), PRINT_INK);
      drawNumbers(pen, page, packing, map);
      if (items.length > 1) drawItemNumbers(pen, page, packing, told, PRINT_INK);
      drawMarks(pen, page, {back: texts.view2d.back}, PRINT_INK);
    }
    return sheet(studio, canvas, said(texts.view2d.notes, map, packing));
  });
  sheets.replaceChildren(...pages.map(({element}) => element));
  await Promise.all(pages.map(({image}) => image.decode()));
  window.print();
}

function sheet({packing, objects}: Studio, canvas: HTMLCanvasElement, note: string) {
  const element = document.createElement('section');
  const heading = document.createElement('h1');
  heading.textContent = objects.map(({file}) => file.name).join(', ');
  const line = document.createElement('p');
  const {blocks, block_mm} = packing ?? {blocks: [], block_mm: []};
  line.textContent = `${note} · ${blocks.join(' × ')} × (${size(block_mm)})`;
  const image = new Image();
  image.src = canvas.toDataURL('image/png');
  image.alt = note;
  element.append(heading, line, image);
  return {element, image};
}

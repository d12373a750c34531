import type {Triple} from '../design/design';
import type {Packing} from '../engine/api';
import type {Cell, Drawing} from '../state/view.svelte';

// Which way round (the same on every picture and sheet): the lower foam and slices are seen from +x, k to the
// right and j downward; the lid is seen from -x with its cavity to the reader, k to the right and j upward. The
// edge at -y is BACK.

/** The space on a canvas, at true proportions. Pixels. */
export interface Page {
  left: number;
  top: number;
  width: number;
  height: number;
  cellWidth: number;
  cellHeight: number;
  /** j runs upward. */
  flipped: boolean;
  ny: number;
  nz: number;
}

export function layOut(packing: Packing, drawing: Drawing, width: number, height: number, margin: number): Page {
  const [, ny, nz] = packing.blocks;
  const [, sy, sz] = packing.block_mm;
  const scale = Math.max(Math.min((width - 2 * margin) / (nz * sz), (height - 2 * margin) / (ny * sy)), 1e-6);
  const [pageWidth, pageHeight] = [nz * sz * scale, ny * sy * scale];
  return {
    left: (width - pageWidth) / 2,
    top: (height - pageHeight) / 2,
    width: pageWidth,
    height: pageHeight,
    cellWidth: sz * scale,
    cellHeight: sy * scale,
    flipped: drawing === 'lid',
    ny,
    nz,
  };
}

/** Upper left corner of a cell. */
export function cellCorner(page: Page, j: number, k: number): {x: number; y: number} {
  const row = page.flipped ? page.ny - 1 - j : j;
  return {x: page.left + k * page.cellWidth, y: page.top + row * page.cellHeight};
}

export function cellAt(page: Page, x: number, y: number): Cell | null {
  const k = Math.floor((x - page.left) / page.cellWidth);
  const row = Math.floor((y - page.top) / page.cellHeight);
  if (k < 0 || k >= page.nz || row < 0 || row >= page.ny) return null;
  return {j: page.flipped ? page.ny - 1 - row : row, k};
}

/** From design coordinates (y, z) in mm to the page. */
export function toPage(page: Page, packing: Packing): (y: number, z: number) => [number, number] {
  const [, sy, sz] = packing.block_mm;
  const [right, down] = [page.cellWidth / sz, page.cellHeight / sy];
  const middle = {x: page.left + page.width / 2, y: page.top + page.height / 2};
  return (y, z) => [middle.x + z * right, middle.y + (page.flipped ? -y : y) * down];
}

/** Back from the page to design coordinates (y, z) in mm. */
export function fromPage(page: Page, packing: Packing, x: number, y: number): [number, number] {
  const [, sy, sz] = packing.block_mm;
  const down = (y - page.top - page.height / 2) * (sy / page.cellHeight);
  return [page.flipped ? -down : down, (x - page.left - page.width / 2) * (sz / page.cellWidth)];
}

/** The page of another packing whose items stay where they were on this one, at the same scale: all were shifted by
 *  `by`, since a space that follows its items is centred anew. */
export function held(page: Page, from: Packing, to: Packing, by: Triple): Page {
  const [, ny, nz] = to.blocks;
  const [down, right] = [page.cellHeight / from.block_mm[1], page.cellWidth / from.block_mm[2]];
  const [cellWidth, cellHeight] = [to.block_mm[2] * right, to.block_mm[1] * down];
  const [width, height] = [nz * cellWidth, ny * cellHeight];
  return {
    ...page,
    ...{cellWidth, cellHeight, width, height, ny, nz},
    left: page.left + (page.width - width) / 2 - by[2] * right,
    top: page.top + (page.height - height) / 2 - (page.flipped ? -by[1] : by[1]) * down,
  };
}

/** The item whose box lies there, the smallest where there are several; none. */
export function itemAt(packing: Packing, y: number, z: number): number | null {
  const area = ({bounds: {min, max}}: Packing['items'][number]) => (max[1] - min[1]) * (max[2] - min[2]);
  const there = packing.items
    .map((item, i) => ({item, i}))
    .filter(({item: {bounds: {min, max}}}) => y >= min[1] && y <= max[1] && z >= min[2] && z <= max[2])
    .sort((a, b) => area(a.item) - area(b.item));
  return there[0]?.i ?? null;
}

/** How many blocks a person takes out of each column, from a half that is as high as its highest column. What a
 *  case has no room for is not there to be taken out. */
export function blocksToRemove(packing: Packing, half: 'lower' | 'lid'): {remove: Uint16Array; highest: number} {
  const lid = half === 'lid';
  const kept = lid ? packing.upper : packing.lower;
  const nx = packing.blocks[0];
  let highest = 0;
  for (const blocks of kept) highest = Math.max(highest, blocks);
  const remove = kept.map((height, column) => {
    const [low, high] = [packing.existsFirst[column] ?? 0, packing.existsEnd[column] ?? nx];
    const [first, end] = lid ? [nx - high, nx - low] : [low, high];
    return Math.max(0, Math.min(highest, end) - Math.max(height, first));
  });
  return {remove, highest};
}

/** The layer of blocks, from -x, in which a height (mm along x from the middle of the space) lies, or the nearest. */
export function layerAt(mm: number, {blocks: [layers], block_mm: [thick]}: Pick<Packing, 'blocks' | 'block_mm'>): number {
  return Math.min(Math.max(Math.floor(mm / thick + layers / 2), 0), layers - 1);
}

/** The height of a layer's middle. */
export function middleOf(layer: number, {blocks: [layers], block_mm: [thick]}: Pick<Packing, 'blocks' | 'block_mm'>): number {
  return (layer + 0.5 - layers / 2) * thick;
}

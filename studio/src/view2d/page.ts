import type {Triple} from '../design/design';
import type {Packing, Runs} from '../engine/api';
import {kindOf, type PieceKind} from '../engine/pieces';
import type {Cell, Drawing, PieceMap} from '../state/view.svelte';

// Which way round (the same on every picture and sheet): the lower foam and slices are seen from +x, k to the
// right and j downward; the lid is seen from -x with its cavity to the reader, k to the right and j upward, and so is
// whatever else is seen from below. The edge at -y is BACK. An upright section is seen from the front, k to the right and
// levels upward.

/** The space on a canvas, at true proportions. Pixels. */
export interface Page {
  left: number;
  top: number;
  width: number;
  height: number;
  cellWidth: number;
  cellHeight: number;
  /** The axis whose cells are the rows, first to last downward: y, or x in an upright section. */
  down: 0 | 1;
  /** They run upward. */
  flipped: boolean;
  ny: number;
  nz: number;
}

export function layOut(packing: Packing, drawing: Drawing, width: number, height: number, margin: number): Page {
  const down = drawing === 'upright' ? 0 : 1;
  const [ny, nz] = [packing.blocks[down], packing.blocks[2]];
  const [sy, sz] = [packing.block_mm[down], packing.block_mm[2]];
  const scale = Math.max(Math.min((width - 2 * margin) / (nz * sz), (height - 2 * margin) / (ny * sy)), 1e-6);
  const [pageWidth, pageHeight] = [nz * sz * scale, ny * sy * scale];
  return {
    left: (width - pageWidth) / 2,
    top: (height - pageHeight) / 2,
    width: pageWidth,
    height: pageHeight,
    cellWidth: sz * scale,
    cellHeight: sy * scale,
    down,
    flipped: down === 0 || drawing === 'lid' || drawing.endsWith('-below'),
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

/** From design coordinates (y, z) in mm to the page; (x, z) of an upright section. */
export function toPage(page: Page, packing: Packing): (y: number, z: number) => [number, number] {
  const [sy, sz] = [packing.block_mm[page.down], packing.block_mm[2]];
  const [right, down] = [page.cellWidth / sz, page.cellHeight / sy];
  const middle = {x: page.left + page.width / 2, y: page.top + page.height / 2};
  return (y, z) => [middle.x + z * right, middle.y + (page.flipped ? -y : y) * down];
}

/** Back from the page to design coordinates in mm. */
export function fromPage(page: Page, packing: Packing, x: number, y: number): [number, number] {
  const [sy, sz] = [packing.block_mm[page.down], packing.block_mm[2]];
  const down = (y - page.top - page.height / 2) * (sy / page.cellHeight);
  return [page.flipped ? -down : down, (x - page.left - page.width / 2) * (sz / page.cellWidth)];
}

/** The page of another packing whose items stay where they were on this one, at the same scale: all were shifted by
 *  `by`, since a space that follows its items is centred anew. */
export function held(page: Page, from: Packing, to: Packing, by: Triple): Page {
  const [ny, nz] = [to.blocks[page.down], to.blocks[2]];
  const [down, right] = [page.cellHeight / from.block_mm[page.down], page.cellWidth / from.block_mm[2]];
  const [cellWidth, cellHeight] = [to.block_mm[2] * right, to.block_mm[page.down] * down];
  const [width, height] = [nz * cellWidth, ny * cellHeight];
  return {
    ...page,
    ...{cellWidth, cellHeight, width, height, ny, nz},
    left: page.left + (page.width - width) / 2 - by[2] * right,
    top: page.top + (page.height - height) / 2 - (page.flipped ? -by[page.down] : by[page.down]) * down,
  };
}

/** The item whose box lies there, the smallest where there are several; none. `among`: by their numbers; `down`: the axis of
 *  the page's rows. */
export function itemAt(packing: Packing, y: number, z: number, among: readonly number[], down: Page['down'] = 1): number | null {
  const area = ({bounds: {min, max}}: Packing['items'][number]) => (max[down] - min[down]) * (max[2] - min[2]);
  const there = among
    .map((i) => ({item: packing.items[i]!, i}))
    .filter(({item: {bounds: {min, max}}}) => y >= min[down] && y <= max[down] && z >= min[2] && z <= max[2])
    .sort((a, b) => area(a.item) - area(b.item));
  return there[0]?.i ?? null;
}

/** The maps of all pieces, the lowest first; of foams that there are not yet those of two. */
export function mapsOf(packing: Packing | null): PieceMap[] {
  if (!packing?.fit) return ['lower', 'lid'];
  return packing.pieces.flatMap((_, piece): PieceMap[] => {
    const kind = kindOf(packing, piece);
    if (kind === 'middle') return [`middle-${piece}-above`, `middle-${piece}-below`];
    return [kind === 'upper' ? 'lid' : 'lower'];
  });
}

export interface ShownPiece {
  /** From the lowest, which is 0. */
  piece: number;
  kind: PieceKind;
  from: 'above' | 'below';
}

export function shownBy(map: PieceMap, {pieces}: Pick<Packing, 'pieces'>): ShownPiece {
  if (map === 'lower') return {piece: 0, kind: 'lower', from: 'above'};
  if (map === 'lid') return {piece: pieces.length - 1, kind: 'upper', from: 'below'};
  const [, number, from] = map.split('-');
  return {piece: Number(number), kind: 'middle', from: from as 'above' | 'below'};
}

/** What is said of a map, among words for all kinds of them. */
export interface MapWords {
  lower: string;
  middle: Record<ShownPiece['from'], (number: number) => string>;
  upper: string;
}

export function said(words: MapWords, map: PieceMap, packing: Pick<Packing, 'pieces'>): string {
  const {piece, kind, from} = shownBy(map, packing);
  return kind === 'middle' ? words.middle[from](piece) : words[kind];
}

/** How many blocks a person takes out of each column from one side, or from both, of a piece that is as high as its
 *  highest column and, between two layers, begins where its lowest does. What a case has no room for is not there to be
 *  taken out. */
export function blocksToRemove(packing: Packing, piece: number, from: 'above' | 'below' | 'both'): Int16Array {
  const {first, end} = packing.pieces[piece] ?? {first: new Int16Array(), end: new Int16Array()};
  const [low, high] = wholePiece({first, end}, kindOf(packing, piece), packing.blocks[0]);
  return first.map((bottom, column) => {
    const top = end[column] ?? 0;
    const lowest = Math.max(low, packing.exists.first[column] ?? 0);
    const highest = Math.min(high, packing.exists.end[column] ?? 0);
    if (top <= bottom || from === 'both') return Math.max(highest - lowest, 0) - Math.max(top - bottom, 0);
    return from === 'above' ? highest - top : bottom - lowest;
  });
}

/** The levels between which a piece lies before anything is taken out of it. */
function wholePiece({first, end}: Runs, kind: PieceKind, nx: number): [low: number, high: number] {
  let [low, high] = [nx, 0];
  end.forEach((top, column) => {
    const bottom = first[column] ?? 0;
    if (top > bottom) [low, high] = [Math.min(low, bottom), Math.max(high, top)];
  });
  return [kind === 'lower' ? 0 : low, kind === 'upper' ? nx : high];
}

/** The items that a drawing tells of, by their numbers: of a map those that lie against what is seen, in a section those of
 *  the layer that is nearest to it, and in an upright one those that it cuts. */
export function itemsIn(packing: Packing, drawing: Drawing, section_mm: number): number[] {
  const {items} = packing;
  const cut = ({bounds: {min, max}}: Packing['items'][number]) => min[1] <= section_mm && section_mm <= max[1];
  if (drawing === 'upright') return [...items.keys()].filter((i) => cut(items[i]!));
  const layers = drawing === 'slice' ? nearestLayers(packing, section_mm) : [layerSeen(packing, drawing)];
  return [...items.keys()].filter((i) => layers.includes(items[i]!.layer));
}

function layerSeen(packing: Packing, map: PieceMap): number {
  const {piece, from} = shownBy(map, packing);
  return from === 'above' ? piece + 1 : piece;
}

function nearestLayers({items}: Packing, x: number): number[] {
  const away = new Map<number, number>();
  for (const {layer, bounds: {min, max}} of items)
    away.set(layer, Math.min(away.get(layer) ?? Infinity, Math.max(min[0] - x, x - max[0], 0)));
  const least = Math.min(...away.values());
  return [...away.keys()].filter((layer) => away.get(layer) === least);
}

type Blocks = Pick<Packing, 'blocks' | 'block_mm'>;

/** The layer of blocks, from the lower end of an axis, in which a place lies (mm from the middle of the space), or the
 *  nearest. */
export function layerAt(mm: number, {blocks, block_mm}: Blocks, axis: 0 | 1 = 0): number {
  return Math.min(Math.max(Math.floor(mm / block_mm[axis] + blocks[axis] / 2), 0), blocks[axis] - 1);
}

/** Where a layer's middle is. */
export function middleOf(layer: number, {blocks, block_mm}: Blocks, axis: 0 | 1 = 0): number {
  return (layer + 0.5 - blocks[axis] / 2) * block_mm[axis];
}

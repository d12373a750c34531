import type {DisplayMesh, PackedItem, Packing} from '../engine/api';
import {isThere, kindOf, pieceAt} from '../engine/pieces';
import type {Cell, PieceMap} from '../state/view.svelte';
import {blocksToRemove, cellCorner, shownBy, toPage, type Page} from './page';
import {placedCoordinates, section} from './section';

export interface Ink {
  paper: string;
  text: string;
  line: string;
  cut: string;
  lower: string;
  middle: string;
  upper: string;
  object: string;
  mark: string;
  back: string;
  /** Around the item that is selected, and around items that are too near each other. */
  selected: string;
  near: string;
}

type Pen = CanvasRenderingContext2D;

/** An object as it is drawn, and where it lies. */
export interface Placed {
  mesh: DisplayMesh;
  placement: readonly number[];
}

/** Cells below this many pixels carry no lines, and below the second no numbers. */
const LEAST_LINED = 4;
const LEAST_NUMBERED = 11;

/** One layer of blocks, seen from above. */
export function drawSlice(pen: Pen, page: Page, packing: Packing, layer: number, items: readonly Placed[], ink: Ink) {
  const {pieces, blocks, block_mm} = packing;
  const [nx, , nz] = blocks;
  fillCells(pen, page, (j, k) => {
    const column = j * nz + k;
    if (pieces.length === 0) return ink.cut;
    if (!isThere(packing, column, layer)) return ink.paper;
    const piece = pieceAt(packing, column, layer);
    return piece < 0 ? ink.cut : ink[kindOf(packing, piece)];
  });
  lines(pen, page, ink);
  const x = (layer + 0.5 - nx / 2) * block_mm[0];
  for (const {mesh, placement} of items) drawSection(pen, page, packing, section(mesh, placement, x), ink);
  frame(pen, page, ink);
}

/** One row of columns, seen from the front: lid, object, lower foam and walls at once. */
export function drawUpright(pen: Pen, page: Page, packing: Packing, row: number, items: readonly Placed[], ink: Ink) {
  const {pieces, blocks, block_mm} = packing;
  const [, ny, nz] = blocks;
  fillCells(pen, page, (level, k) => {
    const column = row * nz + k;
    if (pieces.length === 0) return ink.cut;
    if (!isThere(packing, column, level)) return ink.paper;
    const piece = pieceAt(packing, column, level);
    return piece < 0 ? ink.cut : ink[kindOf(packing, piece)];
  });
  lines(pen, page, ink);
  const y = (row + 0.5 - ny / 2) * block_mm[1];
  for (const {mesh, placement} of items) drawSection(pen, page, packing, section(mesh, placement, y, 1), ink);
  frame(pen, page, ink);
}

/** Where the other section cuts this one, mm. */
export function drawOtherSection(pen: Pen, page: Page, packing: Packing, mm: number, ink: Ink) {
  const [, y] = toPage(page, packing)(mm, 0);
  pen.save();
  pen.strokeStyle = ink.text;
  pen.globalAlpha = 0.55;
  pen.setLineDash([7, 3, 1.5, 3]);
  pen.beginPath();
  pen.moveTo(page.left - 8, y);
  pen.lineTo(page.left + page.width + 8, y);
  pen.stroke();
  pen.restore();
}

/** How many blocks to take out of each column of a piece, as shades. */
export function drawMap(pen: Pen, page: Page, packing: Packing, map: PieceMap, ink: Ink) {
  const {piece, kind, from} = shownBy(map, packing);
  const remove = blocksToRemove(packing, piece, from);
  const most = remove.reduce((a, b) => Math.max(a, b), 1);
  const at = (j: number, k: number) => remove[j * page.nz + k] ?? 0;
  fillCells(pen, page, (j, k) => shade(ink[kind], at(j, k) / most));
  lines(pen, page, ink);
  frame(pen, page, ink);
}

/** The same as numbers, over whatever else was drawn. */
export function drawNumbers(pen: Pen, page: Page, packing: Packing, map: PieceMap) {
  const {piece, from} = shownBy(map, packing);
  const remove = blocksToRemove(packing, piece, from);
  const most = remove.reduce((a, b) => Math.max(a, b), 1);
  numbers(pen, page, (j, k) => remove[j * page.nz + k] ?? 0, most);
}

/** The objects' outlines as they are seen along x. Takes a while for many triangles. */
export function drawOutlines(pen: Pen, page: Page, packing: Packing, items: readonly Placed[], ink: Ink) {
  for (const item of items) drawOutline(pen, page, packing, item, ink);
}

function drawOutline(pen: Pen, page: Page, packing: Packing, {mesh, placement}: Placed, ink: Ink) {
  const canvas = new OffscreenCanvas(pen.canvas.width, pen.canvas.height);
  const mask = canvas.getContext('2d');
  if (!mask) return;
  const scale = pen.getTransform();
  mask.setTransform(scale);
  mask.fillStyle = ink.object;
  mask.beginPath();
  const placed = placedCoordinates(mesh, placement);
  const place = toPage(page, packing);
  const corner = (i: number) => place(placed[(mesh.indices[i] ?? 0) * 3 + 1] ?? 0, placed[(mesh.indices[i] ?? 0) * 3 + 2] ?? 0);
  for (let i = 0; i < mesh.indices.length; i += 3) {
    const [a, b, c] = [corner(i), corner(i + 1), corner(i + 2)];
    // All the same way round, or overlapping triangles would cancel.
    const turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    mask.moveTo(...a);
    mask.lineTo(...(turn > 0 ? b : c));
    mask.lineTo(...(turn > 0 ? c : b));
  }
  mask.fill('nonzero');
  const outline = rim(canvas, scale.a);
  pen.save();
  pen.resetTransform();
  pen.drawImage(outline, 0, 0);
  pen.restore();
}

export function drawMarks(pen: Pen, page: Page, text: {back: string}, ink: Ink) {
  pen.fillStyle = ink.back;
  pen.textAlign = 'center';
  const size = Math.max(10, Math.min(13, page.width / 24));
  pen.font = `600 ${size}px system-ui, sans-serif`;
  pen.textBaseline = page.flipped ? 'top' : 'bottom';
  const y = page.flipped ? page.top + page.height + 5 : page.top - 5;
  pen.fillText(text.back, page.left + page.width / 2, y);
  // The odd corner: at BACK, left.
  const odd = Math.max(7, Math.min(page.cellWidth, page.cellHeight) * 0.5);
  const corner = cellCorner(page, 0, 0);
  const edge = page.flipped ? page.top + page.height : corner.y;
  pen.beginPath();
  pen.moveTo(page.left, edge);
  pen.lineTo(page.left + odd, edge);
  pen.lineTo(page.left, edge + (page.flipped ? -odd : odd));
  pen.fill();
}

/** A frame around an item, a little wider than it is. */
export function drawItemFrame(pen: Pen, page: Page, packing: Packing, {bounds}: PackedItem, colour: string, thick: boolean) {
  const place = toPage(page, packing);
  const [ax, ay] = place(bounds.min[page.down], bounds.min[2]);
  const [bx, by] = place(bounds.max[page.down], bounds.max[2]);
  pen.strokeStyle = colour;
  pen.lineWidth = thick ? 3 : 1.5;
  pen.strokeRect(Math.min(ax, bx) - 3, Math.min(ay, by) - 3, Math.abs(bx - ax) + 6, Math.abs(by - ay) + 6);
}

/** Which item is which, as the list numbers them. `among`: those that the drawing tells of. */
export function drawItemNumbers(pen: Pen, page: Page, packing: Packing, among: readonly number[], ink: Ink) {
  const place = toPage(page, packing);
  const size = 9;
  pen.font = `700 11px system-ui, sans-serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (const i of among) {
    const {min, max} = packing.items[i]!.bounds;
    const [x, y] = place((min[page.down] + max[page.down]) / 2, (min[2] + max[2]) / 2);
    pen.fillStyle = ink.text;
    pen.beginPath();
    pen.arc(x, y, size, 0, 2 * Math.PI);
    pen.fill();
    pen.fillStyle = ink.paper;
    pen.fillText(String(i + 1), x, y + 0.5);
  }
}

export function drawHovered(pen: Pen, page: Page, cell: Cell, ink: Ink) {
  const {x, y} = cellCorner(page, cell.j, cell.k);
  // A column is as high as the space.
  if (page.down === 0) return hoveredColumn(pen, page, x, ink);
  pen.strokeStyle = ink.mark;
  pen.lineWidth = 2;
  pen.strokeRect(x, y, Math.max(page.cellWidth, 2), Math.max(page.cellHeight, 2));
}

function hoveredColumn(pen: Pen, page: Page, x: number, ink: Ink) {
  pen.strokeStyle = ink.mark;
  pen.lineWidth = 2;
  pen.strokeRect(x, page.top, Math.max(page.cellWidth, 2), page.height);
}

function fillCells(pen: Pen, page: Page, colour: (j: number, k: number) => string) {
  // Neighbours of one colour in one go: a fine grid has millions of cells.
  for (let j = 0; j < page.ny; j++) {
    let first = 0;
    let now = colour(j, 0);
    for (let k = 1; k <= page.nz; k++) {
      const next = k < page.nz ? colour(j, k) : '';
      if (next === now) continue;
      const {x, y} = cellCorner(page, j, first);
      pen.fillStyle = now;
      pen.fillRect(x, y, (k - first) * page.cellWidth + 0.3, page.cellHeight + 0.3);
      [first, now] = [k, next];
    }
  }
}

function lines(pen: Pen, page: Page, ink: Ink) {
  if (Math.min(page.cellWidth, page.cellHeight) < LEAST_LINED) return;
  pen.strokeStyle = ink.line;
  pen.lineWidth = 0.6;
  pen.beginPath();
  for (let k = 1; k < page.nz; k++) {
    pen.moveTo(page.left + k * page.cellWidth, page.top);
    pen.lineTo(page.left + k * page.cellWidth, page.top + page.height);
  }
  for (let j = 1; j < page.ny; j++) {
    pen.moveTo(page.left, page.top + j * page.cellHeight);
    pen.lineTo(page.left + page.width, page.top + j * page.cellHeight);
  }
  pen.stroke();
}

function numbers(pen: Pen, page: Page, value: (j: number, k: number) => number, most: number) {
  const size = Math.min(page.cellWidth, page.cellHeight);
  if (size < LEAST_NUMBERED) return;
  const digits = String(most).length;
  const fits = Math.min(page.cellHeight * 0.62, (page.cellWidth * 0.9) / (0.6 * digits));
  if (fits < 7) return;
  pen.font = `${Math.min(fits, 15)}px system-ui, sans-serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  for (let j = 0; j < page.ny; j++)
    for (let k = 0; k < page.nz; k++) {
      const number = value(j, k);
      if (number === 0) continue;
      const {x, y} = cellCorner(page, j, k);
      pen.fillStyle = number / most > 0.5 ? '#ffffff' : '#101820';
      pen.fillText(String(number), x + page.cellWidth / 2, y + page.cellHeight / 2 + 0.5);
    }
}

function frame(pen: Pen, page: Page, ink: Ink) {
  pen.strokeStyle = ink.text;
  pen.lineWidth = 1.2;
  pen.strokeRect(page.left, page.top, page.width, page.height);
}

function drawSection(pen: Pen, page: Page, packing: Packing, segments: Float64Array, ink: Ink) {
  const place = toPage(page, packing);
  pen.strokeStyle = ink.object;
  pen.lineWidth = 1.6;
  pen.lineCap = 'round';
  pen.beginPath();
  for (let i = 0; i < segments.length; i += 4) {
    pen.moveTo(...place(segments[i] ?? 0, segments[i + 1] ?? 0));
    pen.lineTo(...place(segments[i + 2] ?? 0, segments[i + 3] ?? 0));
  }
  pen.stroke();
}

/** The edge of what is filled: the shape smeared a little in every direction, without itself. */
function rim(shape: OffscreenCanvas, scale: number): OffscreenCanvas {
  const wide = new OffscreenCanvas(shape.width, shape.height);
  const pen = wide.getContext('2d');
  if (!pen) return wide;
  const reach = 1.3 * scale;
  for (let i = 0; i < 12; i++) {
    const angle = (i / 12) * 2 * Math.PI;
    pen.drawImage(shape, reach * Math.cos(angle), reach * Math.sin(angle));
  }
  pen.globalCompositeOperation = 'destination-out';
  pen.drawImage(shape, 0, 0);
  return wide;
}

/** From pale to dark with the share that is taken out. `colour`: #rrggbb. */
function shade(colour: string, share: number): string {
  const parts = [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16));
  const mix = (part: number) => {
    const pale = part + (255 - part) * 0.82;
    const dark = part * 0.5;
    return Math.round(pale + (dark - pale) * share);
  };
  return `rgb(${parts.map(mix).join(' ')})`;
}

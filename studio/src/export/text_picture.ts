// Words that the fonts of every PDF reader cannot say, drawn by the browser: its fonts have all scripts, and a font that
// goes into a file would be some MB.

/** What is drawn, in mm. */
export interface Lettering {
  text: string;
  height: number;
  bold: boolean;
  color: string;
}

export interface TextPicture {
  /** With clear ground. */
  png: Uint8Array<ArrayBuffer>;
  /** Of the picture, in mm. */
  width: number;
  height: number;
  /** From its left edge to where the text begins, and from its lower edge to the line that the text stands on. */
  left: number;
  below: number;
  /** How far the text goes on its line. */
  advance: number;
}

/** Null where there is nothing to draw with. */
export type DrawText = (lettering: Lettering) => Promise<TextPicture | null>;

/** 600 dots to the inch. */
const DOTS = 600 / 25.4;
/** Room for what reaches over the letters' own box, in dots. */
const EDGE = 2;
const FONTS = 'Helvetica, Arial, "Hiragino Sans", "Yu Gothic", "Noto Sans CJK JP", IPAPGothic, sans-serif';

export const drawText: DrawText = async ({text, height, bold, color}) => {
  if (typeof OffscreenCanvas === 'undefined') return null;
  const font = `${bold ? 'bold ' : ''}${height * DOTS}px ${FONTS}`;
  const measuring = new OffscreenCanvas(1, 1).getContext('2d');
  if (!measuring) return null;
  measuring.font = font;
  const box = measuring.measureText(text);
  const left = Math.ceil(Math.max(box.actualBoundingBoxLeft, 0)) + EDGE;
  const above = Math.ceil(Math.max(box.actualBoundingBoxAscent, 0)) + EDGE;
  const below = Math.ceil(Math.max(box.actualBoundingBoxDescent, 0)) + EDGE;
  const right = Math.ceil(Math.max(box.actualBoundingBoxRight, box.width)) + EDGE;
  const canvas = new OffscreenCanvas(left + right, above + below);
  const pen = canvas.getContext('2d');
  if (!pen) return null;
  pen.font = font;
  pen.fillStyle = color;
  pen.fillText(text, left, above);
  const png = new Uint8Array(await (await canvas.convertToBlob({type: 'image/png'})).arrayBuffer());
  return {
    png,
    width: canvas.width / DOTS,
    height: canvas.height / DOTS,
    left: left / DOTS,
    below: below / DOTS,
    advance: box.width / DOTS,
  };
};

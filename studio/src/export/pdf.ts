import {
  appendBezierCurve,
  beginText,
  closePath,
  concatTransformationMatrix,
  drawObject,
  endText,
  LineJoinStyle,
  lineTo,
  moveTo,
  PDFDocument,
  type PDFImage,
  type PDFPage,
  type PDFFont,
  type PDFName,
  PDFOperator,
  PDFOperatorNames,
  popGraphicsState,
  PrintScaling,
  pushGraphicsState,
  rgb,
  setDashPattern,
  setFillingColor,
  setFontAndSize,
  setLineJoin,
  setLineWidth,
  setStrokingColor,
  setTextMatrix,
  showText,
  StandardFonts,
  stroke,
} from 'pdf-lib';
import {drawText, type DrawText, type TextPicture} from './text_picture';

// A display list of the library (snug/drawing/drawing_json.h) as PDF. Lengths in mm, y downward.

interface Pen {
  color: string;
  width: number;
  dashes: number[];
}
interface Inked {
  fill: string | null;
  pen: Pen | null;
}
type PathItem = Inked & {path: number[][]; closed: boolean};
type CircleItem = Inked & {circle: [number, number, number]};
interface TextItem {
  text: string;
  at: [number, number];
  height: number;
  anchor: 'start' | 'middle' | 'end';
  turn: number;
  bold: boolean;
  color: string;
}
export interface Page {
  title: string;
  size: [number, number];
  items: (PathItem | CircleItem | TextItem)[];
}

const POINTS = 72 / 25.4;
/** How far the handles of a quarter circle reach, in radii. */
const QUARTER = 0.5522847498;

/** `draw` makes pictures of what the fonts that every PDF reader has cannot say. */
export async function writePdf(
  title: string,
  trueSize: boolean,
  pages: Page[],
  draw: DrawText = drawText,
): Promise<Uint8Array<ArrayBuffer>> {
  const pdf = await PDFDocument.create({updateMetadata: false});
  pdf.setTitle(title);
  pdf.setCreator('Snug');
  if (trueSize) pdf.catalog.getOrCreateViewerPreferences().setPrintScaling(PrintScaling.None);
  const fonts = [await pdf.embedFont(StandardFonts.Helvetica), await pdf.embedFont(StandardFonts.HelveticaBold)] as const;
  const pictures = new Pictures(pdf, draw);
  for (const {size, items} of pages) {
    const page = pdf.addPage([size[0] * POINTS, size[1] * POINTS]);
    const names = fonts.map((font) => page.node.newFontDictionary('F', font.ref));
    const drawn = await pictures.on(page, items);
    const painter = new Painter(size[1], fonts, names as [PDFName, PDFName], drawn);
    const operators = [setLineJoin(LineJoinStyle.Round)];
    for (const item of items)
      operators.push(...('text' in item ? painter.text(item) : 'circle' in item ? painter.circle(item) : painter.path(item)));
    const content = page.node.context.contentStream(operators);
    page.node.addContentStream(page.node.context.register(content));
  }
  // Printers' own readers of PDF may be old: no object streams.
  return (await pdf.save({useObjectStreams: false})) as Uint8Array<ArrayBuffer>;
}

interface Drawn extends TextPicture {
  name: PDFName;
}

/** The pictures of words in a document, each once. */
class Pictures {
  readonly #made = new Map<string, Promise<(TextPicture & {image: PDFImage}) | null>>();

  constructor(
    private readonly pdf: PDFDocument,
    private readonly draw: DrawText,
  ) {}

  /** Those that a page's texts need, by their texts. */
  async on(page: PDFPage, items: Page['items']): Promise<Map<TextItem, Drawn>> {
    const drawn = new Map<TextItem, Drawn>();
    for (const item of items) {
      if (!('text' in item) || isLatin(item.text)) continue;
      const picture = await this.#of(item);
      if (picture) drawn.set(item, {...picture, name: page.node.newXObject('T', picture.image.ref)});
    }
    return drawn;
  }

  #of({text, height, bold, color}: TextItem) {
    const key = JSON.stringify([text, height, bold, color]);
    const made = this.#made.get(key) ?? this.#make({text, height, bold, color});
    this.#made.set(key, made);
    return made;
  }

  async #make(lettering: Parameters<DrawText>[0]) {
    const picture = await this.draw(lettering);
    return picture && {...picture, image: await this.pdf.embedPng(picture.png)};
  }
}

class Painter {
  constructor(
    private readonly height: number,
    private readonly fonts: readonly [PDFFont, PDFFont],
    private readonly names: readonly [PDFName, PDFName],
    private readonly drawn: ReadonlyMap<TextItem, Drawn>,
  ) {}

  path({path, closed, fill: filling, pen}: PathItem): PDFOperator[] {
    const filled = closed && filling !== null;
    const lines = path.filter((line) => line.length >= 4);
    if ((!filled && !pen) || lines.length === 0) return [];
    const operators = this.#inks(filled ? filling : null, pen);
    for (const line of lines) {
      operators.push(moveTo(this.#x(line[0]!), this.#y(line[1]!)));
      for (let i = 2; i < line.length; i += 2) operators.push(lineTo(this.#x(line[i]!), this.#y(line[i + 1]!)));
      if (closed) operators.push(closePath());
    }
    return [...operators, painted(filled, pen !== null)];
  }

  circle({circle: [cx, cy, radius], fill: filling, pen}: CircleItem): PDFOperator[] {
    if (filling === null && !pen) return [];
    const [x, y, r, q] = [this.#x(cx), this.#y(cy), radius * POINTS, radius * POINTS * QUARTER];
    return [
      ...this.#inks(filling, pen),
      moveTo(x - r, y),
      appendBezierCurve(x - r, y + q, x - q, y + r, x, y + r),
      appendBezierCurve(x + q, y + r, x + r, y + q, x + r, y),
      appendBezierCurve(x + r, y - q, x + q, y - r, x, y - r),
      appendBezierCurve(x - q, y - r, x - r, y - q, x - r, y),
      closePath(),
      painted(filling !== null, pen !== null),
    ];
  }

  text(item: TextItem): PDFOperator[] {
    const {text, at, height, anchor, turn, bold, color} = item;
    const picture = this.drawn.get(item);
    const font = this.fonts[bold ? 1 : 0];
    const name = this.names[bold ? 1 : 0];
    const words = latin(text);
    const size = height * POINTS;
    const advance = picture ? picture.advance * POINTS : font.widthOfTextAtSize(words, size);
    const back = {start: 0, middle: 0.5, end: 1}[anchor] * advance;
    const quarter = ((Math.round(turn / 90) % 4) + 4) % 4; // clockwise
    const cosine = [1, 0, -1, 0][quarter]!;
    const sine = [0, -1, 0, 1][quarter]!;
    const x = this.#x(at[0]) - back * cosine;
    const y = this.#y(at[1]) - back * sine;
    if (picture) {
      const [width, tall, left, below] = [picture.width, picture.height, picture.left, picture.below].map((mm) => mm * POINTS) as [number, number, number, number];
      return [
        pushGraphicsState(),
        concatTransformationMatrix(cosine, sine, -sine, cosine, x, y),
        concatTransformationMatrix(width, 0, 0, tall, -left, -below),
        drawObject(picture.name),
        popGraphicsState(),
      ];
    }
    return [
      ...this.#inks(color, null),
      beginText(),
      setFontAndSize(name, size),
      setTextMatrix(cosine, sine, -sine, cosine, x, y),
      showText(font.encodeText(words)),
      endText(),
    ];
  }

  #x(mm: number): number {
    return mm * POINTS;
  }

  #y(mm: number): number {
    return (this.height - mm) * POINTS;
  }

  #inks(filling: string | null, pen: Pen | null): PDFOperator[] {
    const operators: PDFOperator[] = [];
    if (filling !== null) operators.push(setFillingColor(colour(filling)));
    if (pen)
      operators.push(
        setStrokingColor(colour(pen.color)),
        setLineWidth(pen.width * POINTS),
        setDashPattern(
          pen.dashes.map((mm) => mm * POINTS),
          0,
        ),
      );
    return operators;
  }
}

/** Several loops fill together by the even-odd rule. */
function painted(filled: boolean, stroked: boolean): PDFOperator {
  if (filled && stroked) return PDFOperator.of(PDFOperatorNames.FillEvenOddAndStroke);
  if (filled) return PDFOperator.of(PDFOperatorNames.FillEvenOdd);
  return stroke();
}

function colour(hexadecimal: string) {
  const part = (at: number) => parseInt(hexadecimal.slice(at, at + 2), 16) / 255;
  return rgb(part(1), part(3), part(5));
}

const WINDOWS =
  '\u20ac\u201a\u0192\u201e\u2026\u2020\u2021\u02c6\u2030\u0160\u2039\u0152\u017d\u2018\u2019\u201c\u201d\u2022\u2013\u2014\u02dc\u2122\u0161\u203a\u0153\u017e\u0178';

function isKnown(letter: string): boolean {
  return /[\x20-\x7e\xa0-\xff]/.test(letter) || WINDOWS.includes(letter);
}

/** Nothing of it needs another font; what steers a printer is no text. */
function isLatin(text: string): boolean {
  return Array.from(text.normalize('NFC')).every((letter) => isKnown(letter) || /\p{Cc}/u.test(letter));
}

/** What the fonts that every PDF reader has cannot say becomes a question mark. */
function latin(text: string): string {
  return Array.from(text.normalize('NFC'), (letter) => (isKnown(letter) ? letter : '?')).join('');
}

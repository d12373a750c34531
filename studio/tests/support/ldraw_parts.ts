// Stand-ins for the parts library, which is no package: a box with studs for each part of a parts list, with LDraw's own
// lengths (0.4 mm, -y up, the origin in the middle of the body's top, the long side along x).

export interface ListedPart {
  part: string;
  name: string;
  color: string;
  ldraw_color: string;
  bricklink_color: string;
  pieces: number;
}

/** The lines of a parts.csv. */
export function partsList(csv: string): ListedPart[] {
  const [head, ...rows] = csv.trim().split('\n').map((line) => line.split(','));
  return rows.map((row) => {
    const fields = Object.fromEntries(head!.map((name, i) => [name, row[i]!]));
    return {...(fields as unknown as ListedPart), pieces: Number(fields.pieces)};
  });
}

export const STUD_HEIGHT = 4;
export const bodyHeight = (name: string) => (name.startsWith('Brick') ? 24 : 8);
export const hasStuds = (name: string) => !name.startsWith('Tile');

/** The file with every part that it uses behind it. */
export function withParts(mpd: string, parts: readonly ListedPart[], sides = 8): string {
  const known = new Map(parts.map(({part, name}) => [part, name]));
  return mpd + [...known].map(([part, name]) => partFile(part, name, sides)).join('');
}

function partFile(part: string, name: string, sides: number): string {
  const [width, length] = name.match(/\d+/g)!.map(Number) as [number, number];
  const [x, z] = [10 * length, 10 * width];
  const lines = [`0 FILE ${part}.dat`, `0 ${name}`, '0 !LDRAW_ORG Unofficial_Part', '0 BFC CERTIFY CCW'];
  lines.push(...prism(rectangle(x, z), 0, bodyHeight(name)));
  if (hasStuds(name))
    for (let i = 0; i < length; i++)
      for (let j = 0; j < width; j++) lines.push(...prism(circle(20 * i + 10 - x, 20 * j + 10 - z, 6, sides), -STUD_HEIGHT, 0));
  return [...lines, '0 NOFILE', ''].join('\r\n');
}

type Ring = [number, number][];
const rectangle = (x: number, z: number): Ring => [[-x, -z], [x, -z], [x, z], [-x, z]];
const circle = (x: number, z: number, radius: number, sides: number): Ring =>
  Array.from({length: sides}, (_, i) => {
    const turn = (2 * Math.PI * i) / sides;
    return [x + radius * Math.cos(turn), z + radius * Math.sin(turn)];
  });

/** Faces of colour 16, the part's own, counterclockwise from outside, and edges of colour 24. */
function prism(ring: Ring, top: number, bottom: number): string[] {
  const at = ([x, z]: [number, number], y: number) => `${x.toFixed(3)} ${y} ${z.toFixed(3)}`;
  return ring.flatMap((a, i) => {
    const b = ring[(i + 1) % ring.length]!;
    const fan = i > 0 && i < ring.length - 1;
    return [
      `4 16 ${at(a, top)} ${at(a, bottom)} ${at(b, bottom)} ${at(b, top)}`,
      ...[top, bottom].map((y) => `2 24 ${at(a, y)} ${at(b, y)}`),
      ...(fan ? [`3 16 ${at(ring[0]!, top)} ${at(a, top)} ${at(b, top)}`, `3 16 ${at(ring[0]!, bottom)} ${at(b, bottom)} ${at(a, bottom)}`] : []),
    ];
  });
}

// The bricks that exist, as the library knows them (snug/design/brick_parts.cpp).

export const BRICK_SIZES = ['1x1', '1x2', '1x3', '1x4', '1x6', '1x8', '2x2', '2x3', '2x4', '2x6', '2x8', '2x10'] as const;

export const BRICK_COLORS = {
  black: '#1b2a34',
  blue: '#1e5aa8',
  green: '#00852b',
  red: '#b40000',
  yellow: '#fac80a',
  white: '#f4f4f4',
  tan: '#b0a06f',
  orange: '#d67923',
  'reddish brown': '#5f3109',
  'light bluish gray': '#969696',
  'dark bluish gray': '#646464',
  'dark blue': '#19325a',
  'dark brown': '#352100',
  'dark red': '#720012',
} as const;
export type BrickColor = keyof typeof BRICK_COLORS;

/** "4 x 2" as "2x4"; null where no brick has that size. */
function brickSize(text: string): string | null {
  const sides = text.split(/[x×]/).map(Number).sort((a, b) => a - b);
  const size = sides.join('x');
  return (BRICK_SIZES as readonly string[]).includes(size) ? size : null;
}

/** Sizes as they are shown, either way round. */
export function knownSizes(sizes: readonly string[]): string[] {
  return sizes.flatMap((size) => brickSize(size) ?? []);
}

/** "2x4=100, 1x1=40" as pieces by size, also as a Japanese keyboard types it; null where it is something else. */
export function stockFromText(text: string): Record<string, number> | null {
  const parts = text.normalize('NFKC').toLowerCase().split(/[,;、\n]/).map((part) => part.trim());
  const stock: Record<string, number> = {};
  for (const part of parts.filter((each) => each !== '')) {
    const [, named, pieces] = /^([\dx× ]+)[=:]\s*(\d{1,8})$/.exec(part) ?? [];
    const size = named && brickSize(named);
    if (!size) return null;
    stock[size] = Number(pieces);
  }
  return stock;
}

export function stockText(stock: Record<string, number>): string {
  return Object.entries(stock)
    .map(([size, pieces]) => `${size}=${pieces}`)
    .join(', ');
}

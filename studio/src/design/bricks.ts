// Sizes of bricks and how many there are, as people type them. `known`: those that exist, "2x4".

/** "4 x 2" as "2x4"; null where no brick has that size. */
function brickSize(text: string, known: readonly string[]): string | null {
  const sides = text.split(/[x×]/).map(Number).sort((a, b) => a - b);
  const size = sides.join('x');
  return known.includes(size) ? size : null;
}

/** Sizes as they are shown, either way round. */
export function knownSizes(sizes: readonly string[], known: readonly string[]): string[] {
  return sizes.flatMap((size) => brickSize(size, known) ?? []);
}

/** "2x4=100, 1x1=40" as pieces by size, also as a Japanese keyboard types it; null where it is something else. */
export function stockFromText(text: string, known: readonly string[]): Record<string, number> | null {
  const parts = text.normalize('NFKC').toLowerCase().split(/[,;、\n]/).map((part) => part.trim());
  const stock: Record<string, number> = {};
  for (const part of parts.filter((each) => each !== '')) {
    const [, named, pieces] = /^([\dx× ]+)[=:]\s*(\d{1,8})$/.exec(part) ?? [];
    const size = named && brickSize(named, known);
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

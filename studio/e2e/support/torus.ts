/** A ring as binary STL, mm, with 2 x along x around triangles. */
export function torusStl(along: number, around: number, radius = 80, tube = 32): Buffer {
  const bytes = Buffer.alloc(84 + along * around * 2 * 50);
  bytes.writeUInt32LE(along * around * 2, 80);
  const corner = (i: number, j: number) => {
    const u = ((i % along) / along) * 2 * Math.PI;
    const v = ((j % around) / around) * 2 * Math.PI;
    const r = radius + tube * Math.cos(v);
    return [r * Math.cos(u), r * Math.sin(u), tube * Math.sin(v)];
  };
  let at = 84;
  const write = (corners: number[][]) => {
    at += 12;
    for (const value of corners.flat()) at = bytes.writeFloatLE(value, at);
    at += 2;
  };
  for (let i = 0; i < along; i++)
    for (let j = 0; j < around; j++) {
      write([corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)]);
      write([corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)]);
    }
  return bytes;
}

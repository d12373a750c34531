/** A binary little-endian PLY. */
export function writePly({positions, indices}: {positions: Float32Array; indices: Uint32Array}): ArrayBuffer {
  const header = new TextEncoder().encode(
    [
      'ply',
      'format binary_little_endian 1.0',
      `element vertex ${positions.length / 3}`,
      'property float x',
      'property float y',
      'property float z',
      `element face ${indices.length / 3}`,
      'property list uchar int vertex_indices',
      'end_header',
      '',
    ].join('\n'),
  );
  const faceBytes = 13; // a count and three indices
  const bytes = new ArrayBuffer(header.length + positions.length * 4 + (indices.length / 3) * faceBytes);
  new Uint8Array(bytes).set(header);
  const view = new DataView(bytes, header.length);
  positions.forEach((value, i) => view.setFloat32(i * 4, value, true));
  for (let i = 0, at = positions.length * 4; i < indices.length; i += 3, at += faceBytes) {
    view.setUint8(at, 3);
    for (let corner = 0; corner < 3; corner++) view.setInt32(at + 1 + corner * 4, indices[i + corner]!, true);
  }
  return bytes;
}

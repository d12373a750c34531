import {deflateRawSync} from 'node:zlib';
import {describe, expect, it} from 'vitest';
import {inflate} from '../../src/import/inflate';


describe('what is packed', () => {
  it('comes out as it was, however large', () => {
    for (const size of [0, 1, 1000, 300_000]) {
      const bytes = Uint8Array.from({length: size}, (_, i) => (i * i) >> 3);
      const again = inflate(new Uint8Array(deflateRawSync(bytes)), size) as Uint8Array;
      expect(Buffer.compare(again, bytes), `${size} bytes`).toBe(0);
    }
  });

  it('is refused where it is more than it may be, long before all of it is there', () => {
    const bomb = new Uint8Array(deflateRawSync(new Uint8Array(50_000_000)));
    const before = process.memoryUsage().arrayBuffers;
    expect(inflate(bomb, 1000)).toBeNull();
    expect(process.memoryUsage().arrayBuffers - before).toBeLessThan(40_000_000);
    expect(inflate(new Uint8Array(deflateRawSync(new Uint8Array(11))), 10)).toBeNull();
  });

  it('is refused where it is cut off or changed', () => {
    const packed = new Uint8Array(deflateRawSync(Uint8Array.from({length: 50_000}, (_, i) => (i * i) >> 5)));
    expect(inflate(packed.slice(0, packed.length / 2), 50_000)).toBeNull();
    expect(inflate(new Uint8Array(0), 10)).toBeNull();
    expect(inflate(packed.slice().fill(255, 0, 10), 50_000)).toBeNull();
  });
});

import {describe, expect, it} from 'vitest';
import type {Design, Triple} from '../../src/design/design';
import type {Packing} from '../../src/engine/api';
import {numbers} from '../support/packing';
import {good, startCore} from '../support/snug';

/** What a packing says of the foams. */
function foams({pieces, exists, items, findings}: Packing) {
  return {pieces, exists, items, findings};
}

describe('the prepared surface', () => {
  // An object is packed plainly the first time and from its prepared surface from then on. That the plain way gives
  // the command line's bytes is another test's business.
  it('gives in WebAssembly what the plain way gives', {timeout: 120_000}, async () => {
    const [plain, prepared] = [await startCore(), await startCore()];
    const number = numbers(2503);
    for (const name of ['figurine', 'camera', 'vase']) {
      const file = good(await plain.sampleFile(name));
      const design = await plain.defaultDesign();
      await prepared.load(file.name, new Blob([file.bytes]), design.object);
      good(await prepared.pack(design));
      for (const columns of [12, 30, 150]) {
        const turn = (): number => number(360_000) / 1000 - 180;
        const turned: Design = {
          ...design,
          space: {...design.space, blocks: [30, columns, columns] as Triple, block_mm: [15, 400 / columns, 400 / columns]},
          placement: {rotation_deg: [turn(), turn(), turn()], offset_mm: [number(20) - 10, number(9) / 7, 0]},
          cut: {...design.cut, clearance_mm: number(3) / 2, cut_on_touch: number(2) === 1},
        };
        await plain.load(file.name, new Blob([file.bytes]), design.object);
        expect(foams(good(await prepared.pack(turned)))).toEqual(foams(good(await plain.pack(turned))));
      }
    }
  });
});

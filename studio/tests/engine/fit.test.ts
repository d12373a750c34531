import {beforeAll, expect, test} from 'vitest';
import type {Design} from '../../src/design/design';
import {withFit, withParting, withSpace} from '../../src/design/edit';
import type {Packing} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import {torus} from '../support/shapes';
import {good, startCore} from '../support/snug';

// Lying on foam, and pads, as the page gets them.

let core: EngineCore;
let design: Design;
beforeAll(async () => {
  core = await startCore();
  const defaults = await core.defaultDesign();
  good(await core.load('ring.stl', torus(60, 24), defaults.object));
  design = withSpace(defaults, 'auto');
});

const pack = async (fit: Partial<Design['fit']>, level: Design['parting']['level'] = 'auto') =>
  good(await core.pack(withParting(withFit(design, fit), level)));

/** The blocks of an axis that lie between two places, mm; whole where both are faces of blocks. */
function blocksBetween({blocks, block_mm}: Packing, axis: number, low: number, high: number): [number, number] {
  const at = (mm: number) => mm / block_mm[axis]! + blocks[axis]! / 2;
  return [Math.floor(at(low) + 1e-6), Math.ceil(at(high) - 1e-6)];
}

test('an item comes down by what is said, less than a block, and goes on cutting nothing more below', async () => {
  const floats = await pack({});
  const lies = await pack({settle: true}, floats.partingLevels[0]!);
  const down = lies.items[0]!.settled_mm;
  expect(floats.items[0]!.settled_mm).toBe(0);
  expect(down).toBeGreaterThan(0);
  expect(down).toBeLessThan(lies.block_mm[0]);
  expect(floats.items[0]!.bounds.min[0] - lies.items[0]!.bounds.min[0]).toBeCloseTo(down, 3);
  expect(lies.pieces[0]).toEqual(floats.pieces[0]);
  expect(lies.pads).toEqual([]);
});

test('pads lie on foam that ends under all of them, and in none', async () => {
  const packing = await pack({settle: true, pads: {sheet_mm: 2, squeeze_mm: 0}});
  expect(packing.pads.some(({above}) => above)).toBe(true);
  expect(packing.pads.some(({above}) => !above)).toBe(true);
  const [, , nz] = packing.blocks;
  for (const {box, piece, above, item, text} of packing.pads) {
    expect([item, piece]).toEqual([0, above ? 1 : 0]);
    const size = box.max.map((mm, axis) => mm - box.min[axis]!);
    expect(text[0]).toContain(`${Number(size[2]!.toFixed(1))} x ${Number(size[1]!.toFixed(1))} x ${Number(size[0]!.toFixed(1))} mm`);
    expect(Math.round(size[0]! / 2) * 2).toBeCloseTo(size[0]!);
    const [first, end] = blocksBetween(packing, 0, box.min[0], box.max[0]);
    const [j0, j1] = blocksBetween(packing, 1, box.min[1], box.max[1]);
    const [k0, k1] = blocksBetween(packing, 2, box.min[2], box.max[2]);
    for (let j = j0; j < j1; j++)
      for (let k = k0; k < k1; k++) {
        const column = j * nz + k;
        const [below, over] = packing.pieces.map((runs) => ({first: runs.first[column]!, end: runs.end[column]!}));
        expect(above ? over!.first : below!.end).toBe(above ? end : first);
        expect(above ? below!.end : over!.first)[above ? 'toBeLessThanOrEqual' : 'toBeGreaterThanOrEqual'](above ? first : end);
      }
  }
  expect(packing.findings.map(({code}) => code)).toContain('pads');
});

test('pads are those that the report tells', async () => {
  const fitted = {settle: true, pads: {sheet_mm: 2, squeeze_mm: 0}};
  const {pads, items} = await pack(fitted);
  const files = good(await core.outputFiles(withFit(design, fitted)));
  const report = JSON.parse(new TextDecoder().decode(files.find(({name}) => name === 'report.json')!.bytes)) as {
    pads: {thickness_mm: number}[];
    items: {settled_mm: number}[];
  };
  expect(report.pads.map(({thickness_mm}) => thickness_mm)).toEqual(pads.map(({box}) => expect.closeTo(box.max[0] - box.min[0], 2) as number));
  expect(report.items[0]!.settled_mm).toBeCloseTo(items[0]!.settled_mm, 1);
});

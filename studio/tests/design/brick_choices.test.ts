import {beforeAll, describe, expect, test} from 'vitest';
import {knownSizes, stockFromText, stockText} from '../../src/design/bricks';
import type {BrickOptions, BrickRange, Design} from '../../src/design/design';
import type {OutputFile} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import {good, refused, startCore} from '../support/snug';

let core: EngineCore;
let design: Design;
let range: BrickRange;

beforeAll(async () => {
  core = await startCore();
  design = await core.defaultDesign();
  range = await core.bricks();
  const file: OutputFile = good(await core.sampleFile('torus'));
  good(await core.load(file.name, new Blob([file.bytes]), design.object));
});

const withBricks = (bricks: Partial<BrickOptions>): string =>
  JSON.stringify({...design, workshop: {...design.workshop, bricks: {...design.workshop.bricks, ...bricks}}});

describe('the bricks that can be chosen', () => {
  test('are the sizes that the library knows', async () => {
    const {error} = refused(await core.parseProject(withBricks({family: ['9x9']})));
    expect(error.match(/\d+x\d+/g)!.slice(1).sort()).toEqual([...range.sizes].sort());
  });

  test('are the colours that the library knows', async () => {
    const {error} = refused(await core.parseProject(withBricks({lower_color: 'mauve'})));
    expect(error.split('take ')[1]!.split(', ').sort()).toEqual(range.colors.map(({name}) => name).sort());
  });
});

describe('the stock', () => {
  test.each([
    ['', {}],
    ['2x4=100', {'2x4': 100}],
    ['2x4=100, 1x1=40', {'2x4': 100, '1x1': 40}],
    ['  4 x 2 = 7 ;10×2=0,', {'2x4': 7, '2x10': 0}],
    ['２ｘ４＝１００、１×１：４０', {'2x4': 100, '1x1': 40}],
  ])('is read from "%s"', (text, stock) => {
    expect(stockFromText(text, range.sizes)).toEqual(stock);
    expect(stockFromText(stockText(stock), range.sizes)).toEqual(stock);
  });

  test.each(['2x4', '2x4=', '=3', '2x4=-3', '2x4=1.5', '5x5=1', '2x4x1=3', 'x=1', '2x4=1 1x1=3', 'many'])('is not "%s"', (text) => {
    expect(stockFromText(text, range.sizes)).toBeNull();
  });

  test('survives a project', async () => {
    const parsed = good(await core.parseProject(withBricks({stock: {'2x4': 100, '1x1': 40}, family: ['2x4', '1x1']})));
    expect(parsed.design.workshop.bricks).toMatchObject({stock: {'2x4': 100, '1x1': 40}, family: ['2x4', '1x1']});
  });
});

test('sizes are shown either way round', () => {
  expect(knownSizes(['4x2', '1x1'], range.sizes)).toEqual(['2x4', '1x1']);
});

import {beforeEach, expect, test, vi} from 'vitest';
import type {Design} from '../../src/design/design';
import {withWorkshop} from '../../src/design/edit';
import {withItemOptions} from '../../src/design/moment';
import {withDrop, withFoamData} from '../../src/design/protection';
import {contactsOf, type ContactMap} from '../../src/engine/drops';
import type {Studio} from '../../src/state/studio.svelte';
import {foamGrid, itemGrid, type PressureGrid} from '../../src/view3d/pressure_grid';
import {box} from '../support/shapes';
import {startStudio} from '../support/studio';

const NEWTON_PER_KG = 9.80665;
let studio: Studio;
const file = (name: string, size: [number, number, number]) => new File([box(size)], name);
const open = async (...files: File[]) => (await import('../../src/import/open_files')).openFiles(studio, files);

beforeEach(async () => {
  studio = await startStudio();
  await open(file('camera.stl', [80, 100, 150]));
});

async function change(edit: (design: Design) => Design) {
  const before = studio.packing;
  studio.change(edit, '');
  await vi.waitFor(() => expect(studio.packing).not.toBe(before));
}

const foam = (name: string) => studio.drops.choices.foams.find((one) => one.design.name === name)!.design;
const asked = (design: Design) => withWorkshop(withDrop(withFoamData(design, foam('ld33'), undefined), 300), {mass_kg: 1.6});

async function look(pressing: 'rest' | number): Promise<ContactMap> {
  studio.drops.contacts.choose(pressing);
  await studio.drops.contacts.look();
  return studio.drops.contacts.current!;
}

/** N, upward. */
function force(map: ContactMap, item: number): number {
  const area = map.cell_mm[0] * map.cell_mm[1];
  return contactsOf(map.items[item]!).reduce((sum, {kpa, high}) => sum + kpa * area * (high ? -1e-3 : 1e-3), 0);
}

test('what is asked for is of the foams on the screen, and goes with them', async () => {
  await change(asked);
  const {contacts} = studio.drops;
  await contacts.look();
  expect(contacts.current).toBeNull();
  const rest = await look('rest');
  expect(rest.axis).toBe(0);
  expect(force(rest, 0)).toBeCloseTo(1.6 * NEWTON_PER_KG, 1);
  contacts.choose(2);
  expect(contacts.current).toBeNull();
  expect((await look(2)).axis).toBe(1);
  await change((design) => withDrop(design, 200));
  expect(contacts.current).toBeNull();
  expect(contacts.chosen).toBe(2);
  await contacts.look();
  expect(contacts.current).not.toBeNull();
  contacts.choose(null);
  expect(contacts.current).toBeNull();
});

test('the most that is shown is the greatest figure that is told of the side', async () => {
  await change(asked);
  await studio.drops.look();
  for (const side of [0, 3, 4]) {
    await look(side);
    const told = studio.drops.last!.items[0]!.faces[side]!;
    expect(studio.drops.contacts.most.kpa).toBeCloseTo(told.peak_kpa, 3);
    expect(studio.drops.contacts.most.strain).toBeCloseTo(told.strain, 5);
  }
});

test('where nothing is known the sentence says why, and there are no colours', async () => {
  await change((design) => withDrop(withFoamData(design, foam('ld33'), undefined), 300));
  expect((await look('rest')).items[0]).toEqual({why: [expect.stringMatching(/without its mass/), expect.any(String)], columns: new Float32Array(0)});
  await change((design) => withWorkshop(design, {mass_kg: 400}));
  expect((await look('rest')).items[0]!.why![0]).toMatch(/beyond its data/);
  expect((await look(0)).items[0]!.why![0]).toMatch(/squeezed beyond its data/);
  expect(studio.drops.contacts.most).toEqual({kpa: 0, strain: 0});
  await change((design) => withFoamData(withWorkshop(design, {mass_kg: 1}), foam('ethafoam-220'), undefined));
  expect((await look('rest')).items[0]!.why![0]).toMatch(/nothing is known/);
});

/** The texels of a cell, layer by layer. */
const texels = ({rows, columns, layers, texels: all}: PressureGrid, cell: number) =>
  Array.from({length: layers}, (_, layer) => [...all.subarray((layer * rows * columns + cell) * 4, (layer * rows * columns + cell) * 4 + 4)]);

test('the grids of the picture hold each column where it lies, those of one line in layers', async () => {
  await change(asked);
  await open(file('camera.stl', [80, 100, 150]), file('lens.stl', [60, 60, 90]));
  await change(asked);
  const before = studio.packing;
  studio.becomes(withItemOptions(studio.moment, 1, {layer: 2}), '');
  await vi.waitFor(() => expect(studio.packing).not.toBe(before));
  const map = await look('rest');
  const {packing} = studio;
  const {most} = studio.drops.contacts;
  expect(map.items.map(({why}) => why)).toEqual([null, null]);
  expect(force(map, 1)).toBeCloseTo(1.6 * NEWTON_PER_KG, 0);
  const foamOf = foamGrid(map, packing!, most);
  expect(foamOf.layers).toBe(2);
  map.items.forEach((item, i) => {
    const grid = itemGrid(map, packing!, i, most);
    expect(grid.first).toEqual([-packing!.blocks[1] * packing!.block_mm[1] / 2, -packing!.blocks[2] * packing!.block_mm[2] / 2]);
    const {bounds} = packing!.items[i]!;
    for (const {row, column, high, from_mm, to_mm, kpa, strain} of contactsOf(item)) {
      const cell = row * map.columns + column;
      const y = grid.first[0] + (row + 0.5) * grid.cell[0];
      expect(y).toBeGreaterThan(bounds.min[1] - grid.cell[0]);
      expect(y).toBeLessThan(bounds.max[1] + grid.cell[0]);
      const [texel] = texels(grid, cell);
      expect(texel!.slice(high ? 2 : 0)[0]).toBeCloseTo(kpa / most.kpa, 5);
      expect(texel!.slice(high ? 2 : 0)[1]).toBe(high ? from_mm : to_mm);
      expect(texels(foamOf, cell)).toContainEqual([expect.closeTo(strain / most.strain, 4), from_mm, to_mm, 0]);
    }
  });
});

import {beforeEach, expect, test, vi} from 'vitest';
import type {Triple} from '../../src/design/design';
import {ballsOf, zonesOf, type Ball} from '../../src/design/zones';
import {Painting} from '../../src/state/painting.svelte';
import type {Studio} from '../../src/state/studio.svelte';
import {zoneGrid} from '../../src/view3d/zone_grid';
import {stl, torus} from '../support/shapes';
import {startStudio} from '../support/studio';

let studio: Studio;
let painting: Painting;
let openFiles: (studio: Studio, files: readonly File[], how?: {joins?: boolean}) => Promise<boolean>;
const ring = (name = 'ring.stl', thickness = 20) => new File([torus(24, 12, 60, thickness)], name);

beforeEach(async () => {
  studio = await startStudio();
  painting = new Painting();
  ({openFiles} = await import('../../src/import/open_files'));
});

const packed = async (change: () => void) => {
  const before = studio.packing;
  change();
  await vi.waitFor(() => expect(studio.packing).not.toBe(before));
};
const stroke = (...places: Triple[]) => {
  painting.press(studio);
  for (const place of places) painting.meet(studio, place);
  painting.release(studio);
};
const zones = () => zonesOf(studio.moment.design, studio.selected);
const line = async () => {
  const {files, design, objects} = studio.commanded!;
  return studio.engine.commandLine(files, design, 'en', objects);
};

test('a stroke is one step, keeps foam off, and stands in the command line; what becomes of it is told', async () => {
  await openFiles(studio, [ring()]);
  painting.begin(studio);
  const cut = studio.packing!.fit!.cut_blocks;
  await packed(() => stroke([80, 0, 0], [81, 0, 0], [60, 0, 20], [62, 12, 19]));
  expect(zones()).toEqual([{balls: [[80, 0, 0, 10], [60, 0, 20, 10], [62, 12, 19, 10]], keep_off_mm: 15}]);
  expect(studio.packing!.fit!.cut_blocks).toBeGreaterThan(cut);
  expect(await line()).toContain('--keep-off=80,0,0,10,60,0,20,10,62,12,19,10:15');
  await studio.zones.look();
  const result = studio.zones.of(0, 0)!;
  expect(result.cut_blocks).toBe(studio.packing!.fit!.cut_blocks - cut);
  expect(result.text[0]).toContain('kept off by 15 mm');
  expect(studio.findings.map(({code}) => code)).toContain('zone_free');
  await packed(() => void studio.undo());
  expect([zones(), studio.packing!.fit!.cut_blocks, studio.zones.of(0, 0)]).toEqual([[], cut, null]);
  await packed(() => void studio.redo());
  expect(zones().length).toBe(1);

  painting.tool = 'eraser';
  await packed(() => stroke([61, 6, 20]));
  expect(ballsOf(zones()[0]!)).toEqual([[80, 0, 0, 10]]);
  await packed(() => stroke([79, 0, 0]));
  expect(zones()).toEqual([]);
  // What was said of it waits for the brush.
  painting.tool = 'brush';
  painting.change(studio, {...painting.zone(studio), loose: true}, '');
  await packed(() => stroke([80, 0, 0]));
  expect(zones()).toEqual([{balls: [[80, 0, 0, 10]], keep_off_mm: 15, loose: true}]);
});

test('a hand that is dropped did nothing, and one that meets nothing new makes no step', async () => {
  await openFiles(studio, [ring()]);
  painting.begin(studio);
  painting.press(studio);
  painting.meet(studio, [80, 0, 0]);
  expect(painting.shown(studio).length).toBe(1);
  painting.drop();
  painting.release(studio);
  expect([painting.shown(studio), zones()]).toEqual([[], []]);
  painting.tool = 'eraser';
  const before = studio.moment;
  stroke([80, 0, 0]);
  expect(studio.moment).toBe(before);
});

test('of an object that lies far from its file’s origin it is the file’s coordinates that are kept', async () => {
  const far: Triple = [430_000, -560_000, 120];
  const p = (x: number, y: number, z: number): Triple => [far[0] + x, far[1] + y, far[2] + z];
  const text = `solid s
${[[p(0, 0, 0), p(0, 100, 0), p(100, 0, 0)], [p(0, 0, 0), p(100, 0, 0), p(0, 0, 100)], [p(0, 0, 0), p(0, 0, 100), p(0, 100, 0)], [p(100, 0, 0), p(0, 100, 0), p(0, 0, 100)]]
  .map((corners) => `facet normal 0 0 0\nouter loop\n${corners.map((corner) => `vertex ${corner.join(' ')}`).join('\n')}\nendloop\nendfacet`)
  .join('\n')}
endsolid s
`;
  await openFiles(studio, [new File([text], 'far.stl')]);
  const {origin_mm} = studio.object!;
  const {positions} = studio.meshes!.still;
  const low = [0, 1, 2].map((axis) => Math.min(...Array.from(positions).filter((_, i) => i % 3 === axis)));
  expect(low.map((mm, axis) => mm + origin_mm![axis]!)).toEqual(far);
  expect(Math.max(...low.map(Math.abs))).toBeLessThan(1000);
  painting.begin(studio);
  painting.begin(studio);
  await packed(() => stroke([low[0]! + 100, low[1]!, low[2]!]));
  expect(zones()[0]!.balls).toEqual([[...p(100, 0, 0), 10]]);
  expect(studio.problem).toBeNull();
});

test('of several items each has its own; what the library refuses leaves everything as it was', async () => {
  await openFiles(studio, [ring('a.stl')]);
  painting.begin(studio);
  await packed(() => stroke([80, 0, 0]));
  await openFiles(studio, [ring('b.stl', 18)], {joins: true});
  expect(studio.moment.design.items.map(({zones}) => zones.length)).toEqual([1, 0]);
  studio.select(1);
  painting.begin(studio);
  await packed(() => stroke([-78, 0, 0]));
  expect(studio.moment.design.items.map(({zones}) => zones[0]!.balls)).toEqual([[[80, 0, 0, 10]], [[-78, 0, 0, 10]]]);
  expect(await line()).toContain('a.stl:keep-off=80x0x0x10:15');
  await studio.zones.look();
  expect([studio.zones.of(0, 0) !== null, studio.zones.of(1, 0) !== null]).toEqual([true, true]);
  const before = studio.moment;
  painting.radius_mm = 500;
  stroke([0, 0, 0]);
  await vi.waitFor(() => expect(studio.problem?.text[0]).toContain('the whole object lies in it'));
  expect(studio.moment.design).toEqual(before.design);
});

test('a drop that brings foam too near a place is told with it, and farther off it is not', async () => {
  await openFiles(studio, [ring()]);
  const foam = {curve: [[0.25, 20], [0.5, 40], [0.6, 75], [0.7, 160]], density_kg_m3: 30} as never;
  await packed(() =>
    studio.change((design) => ({...design, protection: {...design.protection, foam, height_mm: 500}, workshop: {...design.workshop, mass_kg: 0.5}}), ''),
  );
  painting.begin(studio);
  painting.change(studio, {keep_off_mm: 5}, '');
  await packed(() => stroke([80, 0, 0], [78, 10, 0], [78, -10, 0]));
  await studio.zones.look();
  expect(studio.zones.of(0, 0)).toMatchObject({reached: true, pressed: false});
  expect(studio.zones.of(0, 0)!.text[0]).toContain('mm stay free in a drop');
  expect(studio.findings[0]!.code).toBe('zone_reached');
  await packed(() => painting.change(studio, {...painting.zone(studio), keep_off_mm: 60}, ''));
  await studio.zones.look();
  expect(studio.zones.of(0, 0)!.reached).toBe(false);
});

test('another object begins without the places of the last', async () => {
  await openFiles(studio, [ring()]);
  painting.begin(studio);
  await packed(() => stroke([80, 0, 0]));
  await openFiles(studio, [ring('other.stl')]);
  expect(zones()).toEqual([]);
});

test('a part is taken whole, and parts are numbered as the library numbers them', async () => {
  const shifted = (triangles: [Triple, Triple, Triple][], by: number, scale: number) =>
    triangles.map((corners) => corners.map(([x, y, z]) => [x * scale + by, y * scale, z * scale] as Triple) as [Triple, Triple, Triple]);
  const [o, a, b, c]: Triple[] = [[0, 0, 0], [50, 0, 0], [0, 50, 0], [0, 0, 50]];
  const solid: [Triple, Triple, Triple][] = [[o!, b!, a!], [o!, a!, c!], [o!, c!, b!], [a!, b!, c!]];
  await openFiles(studio, [new File([stl([...shifted(solid, 0, 1), ...shifted(solid, 100, 2)])], 'two.stl')]);
  const {positions, parts} = studio.meshes!.still;
  const partAt = (x: number) => parts![Array.from({length: parts!.length}, (_, i) => i).find((i) => positions[3 * i] === x)!];
  expect([partAt(50), partAt(200)]).toEqual([2, 1]);
  painting.begin(studio);
  painting.tool = 'part';
  await packed(() => painting.takePart(studio, 2));
  expect(await line()).toContain('--keep-off=part=2:15');
  await packed(() => painting.takePart(studio, 2));
  expect(zones()).toEqual([]);
});

test('the picture’s grid knows what lies in balls, and 2,000 of them take a moment', () => {
  const balls: Ball[] = [[110, 0, 0, 10], [140, 0, 0, 10]];
  const grid = zoneGrid([[balls[0]!], [balls[1]!]], 1, [100, 0, 0])!;
  const at = (p: Triple) => {
    const [i, j, k] = p.map((mm, axis) => Math.floor(((mm - grid.low[axis]!) / grid.extent[axis]!) * grid.size[axis]!)) as Triple;
    const cell = 2 * (i + grid.size[0] * (j + grid.size[1] * k));
    return [grid.depths[cell]! > 128, grid.depths[cell + 1]! > 128];
  };
  expect([at([10, 0, 0]), at([40, 0, 0]), at([10, 7, 0]), at([10, 10.4, 0]), at([25, 0, 0])]).toEqual([[true, false], [false, true], [true, false], [false, false], [false, false]]);
  const many = Array.from({length: 2000}, (_, i): Ball => [Math.cos(i) * 200, Math.sin(i) * 200, i * 0.2, 20]);
  const start = performance.now();
  zoneGrid([many], 0, [0, 0, 0]);
  expect(performance.now() - start).toBeLessThan(2000);
  expect(zoneGrid([], null, [0, 0, 0])).toBeNull();
});

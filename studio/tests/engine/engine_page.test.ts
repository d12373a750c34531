import {afterEach, beforeEach, expect, test, vi} from 'vitest';
import type {Design} from '../../src/design/design';
import type {SearchStep, Engine, Failure} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import {createEngine} from '../../src/engine/engine';
import {failure} from '../../src/engine/failure';
import {latest} from '../../src/engine/latest';
import {Cores} from '../support/cores';
import {box, torus} from '../support/shapes';
import {good, refused} from '../support/snug';

let cores: Cores;
let engine: Engine;
let design: Design;
let restarts: Failure[];

beforeEach(async () => {
  cores = new Cores();
  restarts = [];
  engine = await createEngine({startCore: cores.start, onRestart: (reason) => restarts.push(reason)});
  design = await engine.defaultDesign();
});

afterEach(() => vi.restoreAllMocks());

const load = async (content: Blob, name = 'object.stl') => good(await engine.load(name, content, design.object));
const breakNext = (core: EngineCore, method: 'pack' | 'load' | 'displayMesh' | 'gaps' | 'outputFiles') =>
  vi.spyOn(core, method).mockResolvedValueOnce(failure('memory', ['no memory left', 'メモリー不足']));

test('of many requests the first and the newest are answered, the others are told', async () => {
  const ran: number[] = [];
  const call = latest(
    async (n: number) => {
      ran.push(n);
      await new Promise((resolve) => setTimeout(resolve, 5));
      if (n === 5) throw new Error('five');
      return n;
    },
    () => -1,
  );
  expect(await Promise.all([call(1), call(2), call(3), call(4)])).toEqual([1, -1, -1, 4]);
  expect(ran).toEqual([1, 4]);
  await expect(call(5)).rejects.toThrow('five');
  expect(await call(6)).toBe(6);
});

test('a slider that moves faster than foams are made ends with the newest foam', async () => {
  await load(box([120, 80, 60]));
  const answers = await Promise.all(
    Array.from({length: 20}, (_, i) =>
      engine.pack({...design, placement: {...design.placement, rotation_deg: [i, 0, 0]}}),
    ),
  );
  const made = answers.filter((answer) => !('error' in answer));
  expect(made.length).toBe(2);
  expect(refused(answers[10]).kind).toBe('cancelled');
  design.placement.rotation_deg = [19, 0, 0];
  expect(good(answers[19]!).items).toEqual(good(await engine.pack(design)).items);
});

test('gaps, searches and files leave the quick core free and share one other', async () => {
  await load(box([120, 80, 60]));
  design.placement.rotation_deg = [0, 9, 0];
  good(await engine.pack(design));
  const steps: SearchStep[] = [];
  const [gap, search, files] = await Promise.all([
    engine.gaps(),
    engine.search(design, (step) => steps.push(step)),
    engine.outputFiles(design),
  ]);
  expect(good(gap).widest_mm).toBeGreaterThan(0);
  expect(good(search)).toMatchObject(steps.at(-1)!);
  expect(good(files).map(({name}) => name)).toContain('report.json');
  expect(cores.started.length).toBe(2);
});

test('cancelling a search gives the best so far and keeps the core', async () => {
  await load(torus(60, 30));
  design.placement.rotation_deg = [31, 17, -43];
  const steps: SearchStep[] = [];
  const end = await engine.search(design, (step) => {
    steps.push(step);
    if (steps.length === 2) void engine.cancel();
  });
  expect(good(end)).toMatchObject(steps.at(-1)!);
  expect(steps.length).toBeLessThan(4);
  expect(cores.started[1]!.ended).toBe(false);
});

test('cancelling gaps ends their core, and the next ones work again', async () => {
  await load(box([120, 80, 60]));
  good(await engine.pack(design));
  const first = engine.gaps();
  const files = engine.outputFiles(design);
  await engine.cancel();
  expect(refused(await first).kind).toBe('cancelled');
  expect(refused(await files).kind).toBe('cancelled');
  expect(cores.started[1]!.ended).toBe(true);
  expect(cores.started[0]!.ended).toBe(false);
  good(await engine.gaps());
  expect(cores.started.length).toBe(3);
});

test('newer gaps take the place of older ones', async () => {
  await load(box([120, 80, 60]));
  good(await engine.pack(design));
  const [first, second] = await Promise.all([engine.gaps(), engine.gaps()]);
  expect(refused(first).kind).toBe('cancelled');
  good(second);
});

test('gaps are those of the last packing', async () => {
  await load(box([120, 80, 60]));
  expect(refused(await engine.gaps()).kind).toBe('usage');
  good(await engine.pack(design));
  const snug = good(await engine.gaps());
  design.cut.clearance_mm = 20;
  good(await engine.pack(design));
  expect(good(await engine.gaps()).widest_mm).toBeGreaterThan(snug.widest_mm + 10);
});

test('out of memory starts a new core with the object in it', async () => {
  await load(box([120, 80, 60]), 'mine.stl');
  design.object.units = 'cm';
  design.space.blocks = 'auto';
  const before = good(await engine.pack(design));
  breakNext(cores.started[0]!.core, 'pack');
  const [broken, waiting] = await Promise.all([engine.pack(design), engine.pack(design)]);
  expect(refused(broken).kind).toBe('memory');
  expect(good(waiting).fit).toEqual(before.fit);
  expect(restarts.map(({error}) => error[0])).toEqual(['no memory left']);
  expect(cores.started.map(({ended}) => ended)).toEqual([true, false]);
  expect(await engine.projectText(design)).toContain('mine.stl');
});

test('an object too large for the memory leaves the last one in place and names the command', async () => {
  await load(box([120, 80, 60]), 'mine.stl');
  breakNext(cores.started[0]!.core, 'load');
  const answer = refused(await engine.load('huge scan.ply', box([1, 1, 1]), design.object));
  expect(answer.kind).toBe('memory');
  expect(answer.error).toContain("snug make 'huge scan.ply' --blocks=auto -o 'huge scan-foam'");
  good(await engine.pack(design));
  expect(await engine.projectText(design)).toContain('mine.stl');
});

test('a reading that is stopped ends at once, and the last object is there again', async () => {
  await load(box([120, 80, 60]), 'first.stl');
  const first = good(await engine.pack(design));
  vi.spyOn(cores.started[0]!.core, 'load').mockReturnValue(new Promise(() => {}));
  const reading = engine.load('second.stl', box([10, 10, 10]), design.object);
  await engine.stopReading();
  expect(refused(await reading).kind).toBe('cancelled');
  expect(cores.started[0]!.ended).toBe(true);
  expect(restarts).toEqual([]);
  const again = good(await engine.pack(design));
  expect(again.fit).toEqual(first.fit);
});

test('objects beside each other are all there again in every core', async () => {
  const joins = async (content: Blob, name: string) => good(await engine.load(name, content, design.object, [], {joins: true}));
  const objects = [await load(box([120, 80, 60]), 'first.stl'), await joins(box([40, 40, 40]), 'second.stl')].map(({id}) => ({id, own: null}));
  const items = [0, 1].map((object) => ({...design.items[0]!, object}));
  const both = {...design, items};
  const first = good(await engine.pack(both, objects));
  good(await engine.gaps()); // by the slow core, which loads both by itself
  await engine.stopReading();
  expect(good(await engine.pack(both, objects)).pieces).toEqual(first.pieces);
  expect((await engine.displayMesh(2000, objects[0]!.id)).positions).not.toEqual((await engine.displayMesh(2000, objects[1]!.id)).positions);
  await engine.keep([objects[1]!.id]);
  const {fit} = good(await engine.pack(design));
  expect(fit!.cut_blocks).toBeLessThan(first.fit!.cut_blocks);
  expect(refused(await engine.pack(both, objects)).kind).toBe('usage');
});

test('out of memory in long work leaves the quick core alone', async () => {
  await load(box([120, 80, 60]));
  good(await engine.outputFiles(design));
  breakNext(cores.started[1]!.core, 'outputFiles');
  expect(refused(await engine.outputFiles(design)).kind).toBe('memory');
  expect(cores.started.map(({ended}) => ended)).toEqual([false, true]);
  good(await engine.outputFiles(design));
});

test('a drawn copy is made once until the object changes', async () => {
  await load(torus(100, 50));
  const first = await engine.displayMesh(2000);
  expect(await engine.displayMesh(2000)).toBe(first);
  expect((await engine.displayMesh(500)).indices.length).toBeLessThan(first.indices.length);
  design.object.scale = 2;
  good(await engine.pack(design));
  const second = await engine.displayMesh(2000);
  expect(second).not.toBe(first);
  expect(Math.max(...second.positions)).toBeGreaterThan(Math.max(...first.positions) * 1.9);
});

test('a file that cannot be read is a failure like any other', async () => {
  await load(box([120, 80, 60]));
  const gone = new Blob(['x']);
  vi.spyOn(gone, 'arrayBuffer').mockRejectedValue(new Error('the file was moved'));
  expect(refused(await engine.load('gone.stl', gone, design.object)).error).toContain('gone.stl');
  good(await engine.pack(design));
});

test('the command line is the library’s, and there is none for a design that cannot be', async () => {
  expect(await engine.commandLine('a.stl', design)).toBe('snug make a.stl -o a-foam');
  const chosen: Design = {...design, workshop: {...design.workshop, for: 'sheets', price_per_litre: 0.8, currency: 'EUR'}};
  chosen.space = {...chosen.space, blocks: 'auto'};
  expect(await engine.commandLine("it's.obj", chosen)).toBe(
    "snug make 'it'\\''s.obj' --for=sheets --preset=paper --blocks=auto --price=0.8EUR -o 'it'\\''s-foam'",
  );
  chosen.space.blocks = [0, 1, 1];
  expect(refused(await engine.commandLine('a.stl', chosen)).error).toContain('from 1 to 4096');
});

test('a wrong design has no project text but its sentence', async () => {
  await load(box([120, 80, 60]));
  design.space.blocks = [0, 1, 1];
  await expect(engine.projectText(design)).rejects.toThrow('from 1 to 4096');
});

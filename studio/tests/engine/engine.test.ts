import {createHash} from 'node:crypto';
import {afterEach, beforeEach, describe, expect, test, vi} from 'vitest';
import type {Design} from '../../src/design/design';
import type {Packing, SearchStep} from '../../src/engine/api';
import type {EngineCore} from '../../src/engine/core';
import type {LayerGap} from '../../src/engine/gap';
import {box, torus} from '../support/shapes';
import {good, refused, startCore} from '../support/snug';

let core: EngineCore;
let design: Design;

beforeEach(async () => {
  core = await startCore();
  design = await core.defaultDesign();
});

afterEach(() => vi.restoreAllMocks());

const load = async (content: Blob, name = 'object.stl') => good(await core.load(name, content, design.object));
const pack = async () => good(await core.pack(design));

async function sample(name: string) {
  const file = good(await core.sampleFile(name));
  return good(await core.load(file.name, new Blob([file.bytes]), design.object));
}

async function outputs() {
  const files = good(await core.outputFiles(design));
  return new Map(files.map(({name, bytes}) => [name, new TextDecoder().decode(bytes)]));
}

describe('an object', () => {
  test('is described as it is', async () => {
    const content = box([120, 80, 60]);
    const info = await load(content, 'folder/box.stl');
    expect(info).toMatchObject({
      file: {name: 'box.stl', bytes: content.size},
      vertices: 8,
      triangles: 12,
      fileSize: [120, 80, 60],
      size_mm: [120, 80, 60],
      statesUnit: false,
      sizeProblem: null,
      watertight: true,
      holes: 0,
      partCount: 1,
      parts: [{triangles: 12, size_mm: [120, 80, 60]}],
    });
    expect(info.volume_mm3).toBeCloseTo(120 * 80 * 60, 3);
    const hash = createHash('sha256').update(new Uint8Array(await content.arrayBuffer())).digest('hex');
    expect(info.file.sha256).toBe(hash);
  });

  test('of implausible size is kept until its unit is chosen', async () => {
    const info = await load(box([0.12, 0.08, 0.06]));
    expect(info.size_mm).toBeNull();
    expect(info.sizeProblem?.[0]).toContain('Which unit');
    expect(info.fileSize[0]).toBeCloseTo(0.12);
    expect(refused(await core.pack(design)).kind).toBe('input');
    design.object.units = 'm';
    expect(good(await core.reprepare(design)).size_mm![0]).toBeCloseTo(120, 3);
    expect((await pack()).fit!.cut_blocks).toBeGreaterThan(0);
  });

  test('that was plausible is asked about again where the blocks become larger than it is', async () => {
    await load(box([120, 80, 60]));
    await pack();
    design.space.block_mm = [300, 300, 300];
    expect(refused(await core.pack(design)).error).toContain('Which unit');
    design.object.units = 'mm';
    await pack();
  });

  test('that cannot be read leaves the last one in place', async () => {
    await load(box([120, 80, 60]), 'good.stl');
    const before = await pack();
    for (const [name, text] of [
      ['bad.obj', 'v 0 0 0\nf 1 2 3\n'],
      ['bad.stl', 'solid nothing\nendsolid nothing\n'],
      ['picture.png', '\x89PNG'],
      ['empty.ply', ''],
    ] as const) {
      const failure = refused(await core.load(name, new Blob([text]), design.object));
      expect(failure.kind).toBe('input');
      expect(failure.error.length).toBeGreaterThan(10);
    }
    expect(columns(await pack())).toEqual(columns(before));
    expect(good(await core.projectText(design)).text).toContain('good.stl');
  });

  test('none at all gets a sentence, not a crash', async () => {
    expect(refused(await core.pack(design)).error).toContain('open one');
    refused(await core.gaps());
    refused(await core.reprepare(design));
    refused(await core.search(design, () => {}));
    refused(await core.outputFiles(design));
  });
});

const columns = ({pieces, exists, fit}: Packing) => ({pieces, exists, fit});

describe('a packing', () => {
  test('has the columns that depths.csv has', async () => {
    await sample('torus');
    design.placement.rotation_deg = [12, 34, 56];
    design.cut.clearance_mm = 1.5;
    const packing = await pack();
    const rows = (await outputs()).get('depths.csv')!.trim().split('\n').slice(1);
    const [, ny, nz] = packing.blocks;
    expect(rows.length).toBe(ny * nz);
    rows.forEach((row, column) => {
      const kept = packing.pieces.map(({first, end}) => end[column]! - first[column]!);
      expect(row).toBe([Math.floor(column / nz), column % nz, ...kept].join(','));
    });
    expect(packing.library_ms).toBeGreaterThan(0);
  });

  test('has the numbers that the report has', async () => {
    await sample('camera');
    design.space.blocks = 'auto';
    const packing = await pack();
    const report = JSON.parse((await outputs()).get('report.json')!);
    expect(packing.blocks).toEqual(report.design_space.blocks);
    expect(packing.fit!.cut_blocks).toBe(report.foam.cut_blocks);
    expect(packing.fit!.fill_ratio).toBe(report.foam.fill_ratio);
    expect(packing.partingLevels).toEqual([report.foam.parting_level]);
    expect(packing.fit!.wall_mm).toEqual(report.wall_mm);
    const gap = good(await core.gaps());
    expect(gap.findings.map(({code}) => code)).toEqual(report.findings.map(({code}: {code: string}) => code));
    gap.bearing.lower_mm2.forEach((area, i) => expect(area).toBeCloseTo(report.bearing.lower_mm2[i], 2));
    expect(gap.widest_mm).toBeCloseTo(report.gap.widest_mm, 3);
    expect(gap.step_mm3).toBeCloseTo(report.gap.step_mm3, 2);
    const [{lower, upper, columns}] = gap.layers as [LayerGap];
    expect(lower.step_mm3 + upper.step_mm3).toBeCloseTo(gap.step_mm3, 2);
    expect(upper.widest_mm).toBeCloseTo(report.gap.upper.widest_mm, 3);
    expect(columns.length).toBe(4 * packing.exists.first.length);
  });

  test('places the drawn object where its bounds are', async () => {
    await load(box([120, 80, 60]));
    design.placement = {rotation_deg: [90, 10, 5], offset_mm: [7, -3, 2]};
    const {placement, bounds} = (await pack()).items[0]!;
    const {positions, deviation} = good(await core.displayMesh(1000));
    expect(deviation).toBe(0);
    const least = [Infinity, Infinity, Infinity];
    const most = [-Infinity, -Infinity, -Infinity];
    for (let v = 0; v < positions.length; v += 3) {
      for (let axis = 0; axis < 3; axis++) {
        let at = placement[12 + axis]!;
        for (let i = 0; i < 3; i++) at += placement[i * 4 + axis]! * positions[v + i]!;
        least[axis] = Math.min(least[axis]!, at);
        most[axis] = Math.max(most[axis]!, at);
      }
    }
    for (let axis = 0; axis < 3; axis++) {
      expect(least[axis]).toBeCloseTo(bounds.min[axis]!, 9);
      expect(most[axis]).toBeCloseTo(bounds.max[axis]!, 9);
    }
    expect(bounds.min[0] + bounds.max[0]).toBeCloseTo(14, 9);
  });

  test('of an object that leaves the space says so and still has its place', async () => {
    await load(box([120, 80, 60]));
    design.space.blocks = [2, 2, 2];
    const packing = await pack();
    expect(packing.fit).toBeNull();
    expect(packing.pieces).toEqual([]);
    expect(packing.findings[0]).toMatchObject({severity: 'danger', code: 'outside'});
    expect(packing.items[0]!.bounds.max[0]).toBe(60);
    expect(refused(await core.outputFiles(design)).kind).toBe('does_not_fit');
    refused(await core.gaps());
  });

  test('of numbers outside their range is refused and changes nothing', async () => {
    await load(box([120, 80, 60]));
    const before = await pack();
    const wrong = structuredClone(design);
    wrong.space.blocks = [0, 5000, 18];
    expect(refused(await core.pack(wrong)).error).toContain('from 1 to 4096');
    wrong.space.blocks = [30, 18, 18];
    wrong.cut.clearance_mm = Number.NaN;
    refused(await core.pack(wrong));
    expect(columns(await pack())).toEqual(columns(before));
  });
});

describe('a drawn copy', () => {
  test('has no more triangles than wanted, keeps the shape and says how far it is off', async () => {
    await load(torus(200, 100));
    const {positions, indices, deviation} = good(await core.displayMesh(2000));
    expect(indices.length / 3).toBeLessThanOrEqual(2200);
    expect(indices.length / 3).toBeGreaterThan(500);
    expect(Math.max(...indices)).toBe(positions.length / 3 - 1);
    expect(deviation).toBeGreaterThan(0);
    expect(deviation).toBeLessThan(5);
    expect(Math.max(...positions.filter((_, i) => i % 3 === 2))).toBeCloseTo(45, 0);
  });

  test('of a soup of loose triangles is thinned as well', async () => {
    const loose = Array.from({length: 5000}, (_, t) => {
      const at = [(t * 37) % 100, (t * 61) % 90, (t * 17) % 80];
      return [0, 1, 2].map((i) => at.map((c, axis) => c + (axis === i ? 3 : 0)));
    });
    const text = loose.flat().map((p) => `v ${p.join(' ')}`);
    const faces = loose.map((_, t) => `f ${t * 3 + 1} ${t * 3 + 2} ${t * 3 + 3}`);
    await load(new Blob([[...text, ...faces].join('\n')]), 'soup.obj');
    const {indices} = good(await core.displayMesh(1000));
    expect(indices.length / 3).toBeLessThanOrEqual(1100);
    expect(indices.length).toBeGreaterThan(0);
  });
});

describe('a project', () => {
  test('comes back as it was saved', async () => {
    await load(box([120, 80, 60]), 'box.stl');
    design.space = {preset: 'slit-10', blocks: 'auto', block_mm: [20, 10, 10], wall_mm: 40, between_mm: null, open: null};
    design.placement.rotation_deg = [1.25, -2.5, 3];
    design.parting.level = 7;
    design.object.units = 'mm';
    const {text} = good(await core.projectText(design));
    const project = good(await core.parseProject(text));
    expect(project.design).toEqual(design);
    expect(project.objects[0]!.name).toBe('box.stl');
    expect(project.objects[0]!.sha256).toMatch(/^[0-9a-f]{64}$/);
    expect((await outputs()).get('project.snug.json')).toBe(text);
  });

  test('may be a design alone', async () => {
    const {design: parsed, objects} = good(await core.parseProject(JSON.stringify(design)));
    expect(parsed).toEqual(design);
    expect(objects.map(({name}) => name)).toEqual(['']);
  });

  test('that is wrong is refused with the place', async () => {
    for (const text of ['', '{}', '[]', 'null', '{"snug": 99, "object": {"name": "a"}, "design": {}}', 'PK\x03\x04'])
      expect(refused(await core.parseProject(text)).kind).toBe('input');
    const text = JSON.stringify({...design, space: {...design.space, blocks: [30, 18]}});
    expect(refused(await core.parseProject(text)).error).toContain('blocks');
  });
});

describe('a search', () => {
  test('raises F step by step and ends where the packing says the same', async () => {
    await load(box([120, 80, 60]));
    design.placement.rotation_deg = [0, 9, 0];
    const start = (await pack()).fit!.fill_ratio;
    const steps: SearchStep[] = [];
    const end = good(await core.search(design, (step) => steps.push(step)));
    expect(steps[0]!.fill_ratio).toBe(start);
    expect(end).toMatchObject(steps.at(-1)!);
    expect(end.distinct[0]).toEqual({rotation_deg: end.rotation_deg, offset_mm: end.offset_mm, cut_blocks: end.cut_blocks});
    expect(end.fill_ratio).toBeGreaterThan(start);
    for (let i = 1; i < steps.length; i++)
      expect(steps[i]!.fill_ratio).toBeGreaterThanOrEqual(steps[i - 1]!.fill_ratio);
    design.placement = {rotation_deg: end.rotation_deg, offset_mm: end.offset_mm};
    expect((await pack()).fit!.cut_blocks).toBe(end.cut_blocks);
  });

  test('that is cancelled gives the best so far, and packings go on meanwhile', async () => {
    await sample('camera');
    design.placement.rotation_deg = [31, 17, -43];
    const steps: SearchStep[] = [];
    const searching = core.search(design, (step) => {
      steps.push(step);
      if (steps.length === 3) void core.cancel();
    });
    const meanwhile = await pack();
    expect(meanwhile.fit!.fill_ratio).toBe(steps[0]!.fill_ratio);
    expect(good(await searching)).toMatchObject(steps[2]!);
    expect(steps.length).toBe(3);
  });

  test('ends where another object comes', async () => {
    await sample('camera');
    design.placement.rotation_deg = [31, 17, -43];
    const steps: SearchStep[] = [];
    const searching = core.search(design, (step) => steps.push(step));
    await load(box([120, 80, 60]));
    expect(good(await searching)).toMatchObject(steps.at(-1)!);
  });
});

describe('a map of directions', () => {
  test('has for each exactly what its placement cuts, and keeps the walls', async () => {
    await sample('camera');
    design.space = {...design.space, blocks: 'auto', wall_mm: 50};
    const seen: number[] = [];
    const map = good(await core.directions(design, ({fraction}) => seen.push(fraction)));
    expect(map.fraction).toBe(1);
    expect(seen).toEqual([...seen].sort((a, b) => a - b));
    const count = map.cut_blocks.length;
    expect(count).toBeGreaterThan(300);
    expect(map.directions.length).toBe(3 * count);
    for (let i = 0; i < count; i += 71) {
      const triple = (list: Float64Array) => [...list.slice(3 * i, 3 * i + 3)] as [number, number, number];
      design.placement = {rotation_deg: triple(map.rotations_deg), offset_mm: triple(map.offsets_mm)};
      const {cut_blocks, wall_mm} = (await pack()).fit!;
      expect(cut_blocks).toBe(map.cut_blocks[i]);
      expect(Math.min(...wall_mm)).toBeGreaterThanOrEqual(50);
    }
  });
});

test('gaps tell how far they are', async () => {
  await sample('vase');
  await pack();
  const told: number[] = [];
  vi.spyOn(performance, 'now').mockImplementation(() => told.length * 1000 + 1000 * Math.random());
  good(await core.gaps((fraction) => told.push(fraction)));
  expect(told.every((fraction) => fraction >= 0 && fraction <= 1)).toBe(true);
  expect(told).toEqual([...told].sort((a, b) => a - b));
});

test('every preset can be packed with', async () => {
  await sample('figurine');
  for (const preset of await core.presets()) {
    design.space = {preset: preset.name, blocks: 'auto', block_mm: preset.block_mm, wall_mm: null, between_mm: null, open: null};
    design.cut.clearance_mm = preset.clearance_mm;
    expect((await pack()).fit!.fill_ratio).toBeGreaterThan(0);
  }
});

test('where memory runs out the answer says so', async () => {
  vi.spyOn(WebAssembly.Memory.prototype, 'grow').mockImplementation(() => {
    throw new RangeError('Maximum memory size exceeded');
  });
  const failure = refused(await core.load('large.stl', torus(700, 500), design.object));
  expect(failure.kind).toBe('memory');
  expect(failure.error).toContain('memory');
});

test('the smallest space holds the object and its walls', async () => {
  await sample('figurine');
  design.space.blocks = 'auto';
  design.space.wall_mm = 30;
  design.placement.rotation_deg = [20, 30, 40];
  const before = await pack();
  const fitted = good(await core.fitCase(design)).design;
  const after = good(await core.pack(fitted));
  const volume = ({blocks}: {blocks: number[]}) => blocks.reduce((a, b) => a * b, 1);
  expect(volume(after)).toBeLessThan(volume(before));
  for (const wall of after.fit!.wall_mm) expect(wall).toBeGreaterThanOrEqual(30);
});

describe('raw scans', () => {
  const cloud = () => {
    const lines: string[] = [];
    for (const x of [0, 60])
      for (let y = 0; y <= 100; y += 4) for (let z = 0; z <= 80; z += 4) lines.push(`${x} ${y} ${z} 10 20 30`);
    return new Blob([lines.join('\n')]);
  };

  test('a cloud of points is packed, and what is not known of it is said', async () => {
    const info = await load(cloud(), 'cloud.xyz');
    expect(info).toMatchObject({cloud: true, vertices: 2 * 26 * 21, triangles: 0, volume_mm3: null, partCount: 0});
    const packing = await pack();
    expect(packing.fit!.cut_blocks).toBeGreaterThan(0);
    expect(packing.findings.map((finding) => finding.code)).toContain('cloud');
    expect(refused(await core.gaps()).error).toContain('cloud');
    design.object.point_radius_mm = 20;
    expect((await pack()).fit!.cut_blocks).toBeGreaterThan(packing.fit!.cut_blocks);
    expect(JSON.parse((await outputs()).get('report.json')!).gap).toBeNull();
  });

  test('a part is dropped and taken back, and that is said', async () => {
    const two = new Uint8Array(await box([120, 80, 60]).arrayBuffer());
    const speck = new Uint8Array(await box([2, 3, 1]).arrayBuffer());
    const both = new Uint8Array(two.length + speck.length - 84);
    both.set(two);
    both.set(speck.subarray(84), two.length);
    const view = new DataView(both.buffer);
    for (let facet = 12; facet < 24; facet++)
      for (let corner = 0; corner < 3; corner++) {
        const at = 84 + 50 * facet + 12 + 12 * corner;
        view.setFloat32(at, view.getFloat32(at, true) + 150, true);
      }
    view.setUint32(80, 24, true);
    const info = await load(new Blob([both]));
    expect(info.partCount).toBe(2);
    design.object.clean.drop_parts = [2];
    const cleaned = good(await core.reprepare(design));
    expect(cleaned.parts.map(({number, dropped}) => ({number, dropped}))).toEqual([
      {number: 1, dropped: false},
      {number: 2, dropped: true},
    ]);
    expect((await pack()).findings.map((finding) => finding.code)).toContain('dropped');
    design.object.clean = {drop_parts: [], drop_below_mm: 0, cut_plane: null};
    expect(good(await core.reprepare(design)).parts.some((part) => part.dropped)).toBe(false);
    design.object.clean.drop_parts = [3];
    expect(refused(await core.pack(design)).error).toContain('there is no part 3');
  });
});

import {zipSync} from 'fflate';
import {describe, expect, it} from 'vitest';
import {sha256} from '../../src/engine/sha256';
import type {Studio} from '../../src/state/studio.svelte';
import {ALL} from '../../src/words/texts';
import type {Pair} from '../../src/words/words';
import {box} from '../support/shapes';
import {startStudio} from '../support/studio';

const bytesOf = async (content: Blob) => new Uint8Array(await content.arrayBuffer());

describe('a file that is too big for a page', () => {
  it('is not read, and gets the command that makes its foams', async () => {
    const {defaults, engine} = await startStudio();
    const refused: string[] = [];
    const {openFiles} = await import('../../src/import/open_files');
    const studio = {defaults, engine, refuse: (_: string, [english]: Pair) => refused.push(english)} as unknown as Studio;
    const file = new File(['x'], 'big scan.stl');
    Object.defineProperty(file, 'size', {value: 4e9});
    await openFiles(studio, [file]);
    expect(refused).toEqual([
      "big scan.stl is too big for the browser. The command line makes its foams: snug make 'big scan.stl' --blocks=auto -o 'big scan-foam'",
    ]);
  });
});

describe('a project that waits for its object', () => {
  const waits = async () => {
    const studio = await startStudio();
    const {openFiles, openSample} = await import('../../src/import/open_files');
    const object = {name: 'box.stl', bytes: 684, sha256: await sha256(await bytesOf(box([120, 80, 60])))};
    const design = {...studio.defaults, cut: {...studio.defaults.cut, clearance_mm: 3}};
    const text = JSON.stringify({...JSON.parse(await studio.engine.projectText(design)), objects: [object]});
    await openFiles(studio, [new File([text], 'work.snug.json')]);
    expect(studio.notice).toEqual(ALL.files.openObjectOf('box.stl'));
    const open = (content: Blob, name: string) => openFiles(studio, [new File([content], name)]);
    return {studio, open, sample: () => openSample(studio, 'torus')};
  };

  it('is used for it, by its name or by its content', async () => {
    for (const [content, name] of [[box([120, 80, 60]), 'renamed.stl'], [box([120, 80, 50]), 'box.stl']] as const) {
      const {studio, open} = await waits();
      await open(content, name);
      expect(studio.design.cut.clearance_mm).toBe(3);
      expect(studio.notice).toEqual(name === 'box.stl' ? ALL.files.otherContent('box.stl') : null);
    }
  });

  it('ends with another object, or a sample, and that is said', async () => {
    for (const how of ['object', 'sample']) {
      const {studio, open, sample} = await waits();
      await (how === 'object' ? open(box([30, 20, 10]), 'other.stl') : sample());
      expect(studio.notice).toEqual(ALL.files.waitsNoMore('box.stl'));
      expect(studio.design.cut.clearance_mm).not.toBe(3);
      await open(box([120, 80, 60]), 'box.stl');
      expect(studio.design.cut.clearance_mm).not.toBe(3);
    }
  });
});

describe('a project of measurements', () => {
  const SHAPE = 'box 60x40x20 + cylinder 25x30 at 0,0,25';

  it('has its object itself, also beside one that it waits for', async () => {
    const {openFiles} = await import('../../src/import/open_files');
    const before = await startStudio();
    await openFiles(before, [new File([SHAPE], 'measured.shape')]);
    before.change((design) => ({...design, cut: {...design.cut, clearance_mm: 3}}), 'clearance');
    const text = await before.engine.projectText(before.design);
    const after = await startStudio();
    await openFiles(after, [new File([text], 'work.snug.json')]);
    expect(after.notice).toBeNull();
    expect(after.object?.size_mm).toEqual(before.object?.size_mm);
    expect(after.design.cut.clearance_mm).toBe(3);

    await openFiles(before, [new File([box([120, 80, 60])], 'box.stl')], {joins: true});
    const both = await before.engine.projectText(before.moment.design, before.moment.objects);
    const last = await startStudio();
    await openFiles(last, [new File([both], 'both.snug.json')]);
    expect(last.notice).toEqual(ALL.files.openObjectOf('box.stl'));
    await openFiles(last, [new File([box([120, 80, 60])], 'box.stl')]);
    expect(last.objects.map(({file}) => file.name)).toEqual(['measured.shape', 'box.stl']);
  });
});

describe('a zipped pack that comes back', () => {
  const PROJECT = 'box-foam/project.snug.json';
  const opened = async (others: Record<string, Uint8Array>, ...files: File[]) => {
    const studio = await startStudio();
    const {openFiles} = await import('../../src/import/open_files');
    const object = {name: 'box.stl', bytes: 684, sha256: await sha256(await bytesOf(box([120, 80, 60])))};
    const design = {...studio.defaults, cut: {...studio.defaults.cut, clearance_mm: 3}};
    const text = JSON.stringify({...JSON.parse(await studio.engine.projectText(design)), objects: [object]});
    const members = {'box-foam/lower.stl': new Uint8Array(84), [PROJECT]: new TextEncoder().encode(text), ...others};
    await openFiles(studio, [new File([zipSync(members)], 'box-foam.zip'), ...files]);
    return {studio, open: (file: File) => openFiles(studio, [file])};
  };
  const object = () => new File([box([120, 80, 60])], 'box.stl');

  it('gives its project, which waits for its object', async () => {
    const {studio, open} = await opened({});
    expect(studio.notice).toEqual(ALL.files.openObjectOf('box.stl'));
    await open(object());
    expect(studio.design.cut.clearance_mm).toBe(3);
    expect(studio.notice).toBeNull();
  });

  it('has its object beside it, or within', async () => {
    const beside = await opened({}, object());
    const within = await opened({'box-foam/box.stl': await bytesOf(object())});
    for (const {studio} of [beside, within]) {
      expect(studio.problem).toBeNull();
      expect(studio.object?.size_mm).toEqual([120, 80, 60]);
      expect(studio.design.cut.clearance_mm).toBe(3);
    }
  });

  it('that is damaged is refused as before', async () => {
    const {studio, open} = await opened({});
    await open(new File([new Uint8Array([80, 75, 3, 4, 1, 2, 3])], 'half.zip'));
    expect(studio.problem).not.toBeNull();
  });
});

describe('a .json beside an object', () => {
  const opened = async (...notes: File[]) => {
    const studio = await startStudio();
    const {openFiles} = await import('../../src/import/open_files');
    await openFiles(studio, [...notes, new File([box([120, 80, 60])], 'box.stl')]);
    return studio;
  };

  it('that is no project is left out, and said', async () => {
    const studio = await opened(new File(['{"camera": 5}'], 'info.json'), new File(['no JSON'], 'a.json'));
    expect(studio.object?.file.name).toBe('box.stl');
    expect(studio.problem).toBeNull();
    expect(studio.notice).toEqual(ALL.files.noProject(['info.json', 'a.json']));
  });

  it('is used where it is the project, whatever else lies there', async () => {
    const {defaults, engine} = await opened();
    const text = await engine.projectText({...defaults, cut: {...defaults.cut, clearance_mm: 3}});
    const studio = await opened(new File(['{"camera": 5}'], 'info.json'), new File([text], 'work.snug.json'));
    expect(studio.design.cut.clearance_mm).toBe(3);
    expect(studio.notice).toEqual(ALL.files.noProject(['info.json']));
  });

  it('that is a project of another version is refused', async () => {
    const studio = await opened(new File(['{"snug": 99, "design": {}}'], 'work.snug.json'));
    expect(studio.object).toBeNull();
    expect(studio.problem?.text[0]).toContain('work.snug.json');
  });
});

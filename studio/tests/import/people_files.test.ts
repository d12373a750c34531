import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {afterAll, beforeAll, describe, expect, it} from 'vitest';
import type {EngineCore} from '../../src/engine/core';
import {bundled} from '../../src/import/bundle';
import {good, startCore} from '../support/snug';

// Files that people have, read as the page reads them: all files of the folder lie beside each other, as if they had been
// dropped together.

const FOLDER = fileURLToPath(new URL('../../../../shared/cases/', import.meta.url));
const there = existsSync(FOLDER);
if (!there) console.warn(`skipped: ${FOLDER} is not there, so no file that people have is read`);

interface Expected {
  file: string;
  triangles: number;
  size: number[] | null;
}

function expected(): Expected[] {
  const [, ...lines] = readFileSync(`${FOLDER}expected.csv`, 'utf8').trim().split('\n');
  return lines
    .map((line) => line.split(','))
    .filter(([, command, status]) => command === 'inspect --json' && status === '0')
    .map(([file, , , triangles, size]) => ({
      file: file!,
      triangles: Number(triangles),
      size: size === '-' ? null : size!.split('x').map(Number),
    }));
}

describe.skipIf(!there)('a file that people have', () => {
  let core: EngineCore;
  let read = 0;
  const all = there ? expected() : [];
  beforeAll(async () => void (core = await startCore()));
  afterAll(() => expect(read).toBeGreaterThan(80));

  it.each(all)('$file is what the command line makes of it', async ({file, triangles, size}) => {
    const {object} = await core.defaultDesign();
    const beside = readdirSync(FOLDER)
      .filter((name) => /\.bin$/.test(name))
      .map((name) => ({name, content: new Blob([readFileSync(FOLDER + name)])}));
    expect(bundled([...beside, {name: file}]).objects.map(({name}) => name)).toEqual([file]);
    const info = good(await core.load(file, new Blob([readFileSync(FOLDER + file)]), object, beside));
    read++;
    expect(info.triangles).toBe(triangles);
    expect(info.statesUnit).toBe(/\.(glb|gltf|3mf)$/.test(file));
    size?.forEach((length, axis) =>
      expect(Math.abs(info.fileSize[axis]! - length), `axis ${axis}`).toBeLessThanOrEqual(2e-5 * Math.max(...size)),
    );
  });
});

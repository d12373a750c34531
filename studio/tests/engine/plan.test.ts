import {execFileSync} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {afterAll, beforeAll, expect, test} from 'vitest';
import type {Design} from '../../src/design/design';
import type {EngineCore} from '../../src/engine/core';
import type {PlanWishes, Proposal} from '../../src/engine/plan';
import {good, startCore} from '../support/snug';

// What the page proposes is what `snug plan` proposes: the same figures, findings and designs.

const SNUG = fileURLToPath(new URL('../../../build/snug', import.meta.url));
const WISHES: PlanWishes = {carrier: 'parcel', ways: [], cases: 'cartons', own_blocks: false};
let core: EngineCore;
let defaults: Design;
let folder: string;

beforeAll(async () => {
  core = await startCore();
  defaults = await core.defaultDesign();
  folder = mkdtempSync(join(tmpdir(), 'snug-plan-'));
});
afterAll(() => rmSync(folder, {recursive: true, force: true}));

async function opened(name: string): Promise<string> {
  const file = good(await core.sampleFile(name));
  const path = join(folder, file.name);
  writeFileSync(path, file.bytes);
  return path;
}

const planned = (...options: string[]) =>
  JSON.parse(execFileSync(SNUG, ['plan', ...options, '--json'], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']})) as Proposal[];

/** Without what only the page has. */
const told = (proposals: readonly Proposal[]) => proposals.map(({design: _, preview: __, ...rest}) => rest);

test.each<[string, Partial<PlanWishes>, string[], (design: Design) => Design]>([
  ['kept in a store', {carrier: 'store', ways: ['sponge']}, ['--carrier', 'store', '--ways', 'sponge'], (design) => design],
  ['in sheets of a foam with data, in Japanese', {carrier: 'hand', ways: ['sheets']}, ['--carrier', 'hand', '--ways', 'sheets', '--mass', '1.5', '--fragility', '115', '--language', 'ja'],
    (design) => ({...design, workshop: {...design.workshop, mass_kg: 1.5}, protection: {...design.protection, fragility_g: 115}})],
  ['in a hard case', {cases: 'hard-cases', ways: ['sponge']}, ['--choose-case', 'hard-cases', '--ways', 'sponge'], (design) => design],
])('%s', async (_, wishes, options, change) => {
  const path = await opened('torus');
  good(await core.load('torus.stl', new Blob([good(await core.sampleFile('torus')).bytes]), defaults.object));
  const design = change({...defaults, space: {...defaults.space, blocks: 'auto'}});
  const language = options.includes('ja') ? 'ja' : 'en';
  const proposals = good(await core.plan(design, {...WISHES, ...wishes}, language));
  expect(told(proposals)).toEqual(planned(path, ...options));
  expect(proposals[0]!.preview).toContain('<svg');
});

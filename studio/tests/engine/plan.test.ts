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

const SHAPE = 'box 30x20x40 r5 + cylinder 20x30 at 0,0,30\n';

/** The file of a sample, or small measurements, and where the program finds it. */
async function file(name: string): Promise<{path: string; bytes: Uint8Array}> {
  const file = name === 'measured.shape' ? {name, bytes: new TextEncoder().encode(SHAPE)} : good(await core.sampleFile(name));
  const path = join(folder, file.name);
  writeFileSync(path, file.bytes);
  return {path, bytes: file.bytes};
}

const planned = (...options: string[]) =>
  JSON.parse(execFileSync(SNUG, ['plan', ...options, '--json'], {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']})) as Proposal[];

/** Without what only the page has. */
const told = (proposals: readonly Proposal[]) => proposals.map(({design: _, preview: __, ...rest}) => rest);

test.each<[string, string, Partial<PlanWishes>, string[], (design: Design) => Design]>([
  ['kept in a store', 'torus', {carrier: 'store', ways: ['sponge']}, ['--carrier', 'store', '--ways', 'sponge'], (design) => design],
  ['in sheets of a foam with data, in Japanese', 'measured.shape', {carrier: 'hand', ways: ['sheets']}, ['--carrier', 'hand', '--ways', 'sheets', '--mass', '1.5', '--fragility', '115', '--language', 'ja'],
    (design) => ({...design, workshop: {...design.workshop, mass_kg: 1.5}, protection: {...design.protection, fragility_g: 115}})],
  ['in a hard case', 'torus', {cases: 'hard-cases', ways: ['sponge']}, ['--choose-case', 'hard-cases', '--ways', 'sponge'], (design) => design],
])('%s', async (_, name, wishes, options, change) => {
  const {path, bytes} = await file(name);
  good(await core.load(path, new Blob([new Uint8Array(bytes)]), defaults.object));
  const design = change({...defaults, space: {...defaults.space, blocks: 'auto'}});
  const language = options.includes('ja') ? 'ja' : 'en';
  const proposals = good(await core.plan(design, {...WISHES, ...wishes}, language));
  expect(told(proposals)).toEqual(planned(path, ...options));
  expect(proposals[0]!.preview).toContain('<svg');
});

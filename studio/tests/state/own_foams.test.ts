import {beforeEach, expect, test, vi} from 'vitest';
import {foamEntry, type TypedFoam} from '../../src/design/foam_entry';
import type {Studio} from '../../src/state/studio.svelte';
import {good, refused} from '../support/snug';
import {memory, startStudio} from '../support/studio';

const TYPED: TypedFoam = {name: 'mine', title: '', source: 'own test', density: '28', kind: 'curve', rows: '0.1 20\n0.3, 35\n\n 0.6;90 '};

let studio: Studio;
const own = () => studio.drops.ownFoams;
const names = () => own().all.map(({design}) => design.name);
beforeEach(async () => void (studio = await startStudio()));

/** Points that a flat weight gives on a foam of this stress at every strain: static kPa, G, thickness, drop. */
function pointsOf(kpa: number): string {
  return [4, 6, 8, 10, 12].map((load) => `${load} ${kpa / load - 1} 50 ${50 * (0.4 * (kpa / load) - 0.4)}`).join('\n');
}

test('a foam that is entered is chosen from, and read as the library reads foams.json', async () => {
  const [foam] = good(await own().add(foamEntry(TYPED)));
  expect(foam!.design).toMatchObject({name: 'mine', density_kg_m3: 28, source: 'own test', curve: [[0.1, 20], [0.3, 35], [0.6, 90]]});
  expect(foam!.curve![0]).toContain('60 %');
  expect(studio.drops.foams.map(({design}) => design.name)).toContain('mine');
  expect(studio.drops.foams.length).toBe(studio.drops.choices.foams.length + 1);
});

test('points of a cushion curve become a curve, or are refused with how badly they agree', async () => {
  const foam = good(await own().add(foamEntry({...TYPED, kind: 'points', rows: pointsOf(70)})))[0]!;
  expect(foam.design.curve.length).toBeGreaterThan(5);
  expect(foam.design.thickness_mm).toEqual([50, 50]);
  expect(foam.design.impacts).toBe(1);
  const odd = pointsOf(70).replace(/^4 \S+/, '4 400');
  expect(refused(await own().add(foamEntry({...TYPED, kind: 'points', rows: odd}))).error).toMatch(/15 %/);
});

test('what the library refuses changes nothing, and its sentence names what is wrong', async () => {
  good(await own().add(foamEntry(TYPED)));
  for (const [wrong, sentence] of [
    [{rows: '0.1 20'}, /curve/],
    [{rows: '0.1 20\n0.3 ten'}, /curve/],
    [{rows: '0.1 20\n0.3 10'}, /curve/],
    [{name: ''}, /name/],
    [{density: '-1'}, /density/],
    [{kind: 'points', rows: '1 2 3 4'}, /at least 5 points/],
  ] as const)
    expect(refused(await own().add(foamEntry({...TYPED, name: 'other', ...wrong}))).error).toMatch(sentence);
  expect(refused(await own().add('{')).kind).toBe('usage');
  expect(refused(await own().add('{}')).kind).toBe('usage');
  expect(names()).toEqual(['mine']);
});

test('they are kept, replaced by their name, saved as a foams.json and taken away', async () => {
  const storage = new Map<string, string>();
  vi.stubGlobal('localStorage', memory(storage));
  good(await own().add(JSON.stringify([JSON.parse(foamEntry(TYPED))[0], JSON.parse(foamEntry({...TYPED, name: 'two'}))[0]])));
  good(await own().add(foamEntry({...TYPED, density: '40'})));
  expect(names()).toEqual(['two', 'mine']);
  expect(own().all[1]!.design.density_kg_m3).toBe(40);
  expect(good(await studio.engine.parseFoams(own().text)).map(({design}) => design)).toEqual(own().all.map(({design}) => design));

  const {OwnFoams} = await import('../../src/state/own_foams.svelte');
  const again = new OwnFoams(studio.engine);
  await vi.waitFor(() => expect(again.all).toEqual(own().all));
  expect(await again.remove('two')).toBeNull();
  expect(again.all.map(({design}) => design.name)).toEqual(['mine']);
  expect(JSON.parse(storage.get('snug-foams')!)).toHaveLength(1);
});

test('one of the name of a foam that Snug knows takes its place', async () => {
  good(await own().add(foamEntry({...TYPED, name: 'ld33'})));
  expect(studio.drops.foams.filter(({design}) => design.name === 'ld33').map(({design}) => design.source)).toEqual(['own test']);
});

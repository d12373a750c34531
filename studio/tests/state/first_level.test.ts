import {beforeAll, expect, test, vi} from 'vitest';
import {withCase} from '../../src/design/edit';
import type {Proposal} from '../../src/engine/plan';
import type {FirstLevel} from '../../src/state/first_level.svelte';
import {columnsOf, costOf, isFine, onWeight, pictureOf, shockOf, titleOf, workOf, worries} from '../../src/state/proposals';
import {calledCase, findCases, kindOfCase, mostWall} from '../../src/state/known_cases';
import type {Measuring} from '../../src/state/measuring.svelte';
import type {Studio} from '../../src/state/studio.svelte';
import {withMass} from '../../src/state/wishes';
import {en} from '../../src/words/texts';
import {startStudio} from '../support/studio';

// A camera from measurements, from its three numbers to a proposal that is taken.

let studio: Studio;
let first: FirstLevel;
let measuring: Measuring;
let proposals: readonly Proposal[];
const t = en.first;

beforeAll(async () => {
  vi.resetModules();
  vi.stubGlobal('matchMedia', () => ({matches: false, addEventListener: () => {}}));
  studio = await startStudio();
  first = new (await import('../../src/state/first_level.svelte')).FirstLevel(studio);
  measuring = new (await import('../../src/state/measuring.svelte')).Measuring(studio);
});

test('an object from measurements is open at once, stands upright, and has room for the error', async () => {
  await measuring.start();
  expect(studio.object?.size_mm).toEqual([150, 100, 60]);
  expect(studio.packing?.items[0]?.bounds.max[0]).toBeCloseTo(30);
  expect(studio.design.cut.clearance_mm).toBe(1);
  measuring.change({error_mm: 2, solids: [{...measuring.shape.solids[0]!, size: [143, 87, 40], radius: 5}]});
  await measuring.done();
  expect(studio.object?.size_mm?.map((mm) => Number(mm.toFixed(3)))).toEqual([143, 87, 40]);
  expect(studio.design.cut.clearance_mm).toBe(2);
  expect(studio.asksForUnit).toBe(false);
});

test('it is edited again, and what was chosen for it stays', async () => {
  studio.becomes({...studio.moment, design: withMass(studio.moment.design, 0, 0.8)}, '');
  expect(measuring.canEdit).toBe(true);
  expect(await measuring.edit()).toBe(true);
  expect(measuring.shape.error_mm).toBe(2);
  measuring.change({error_mm: 1});
  await measuring.done();
  expect([studio.design.workshop.mass_kg, studio.design.cut.clearance_mm]).toEqual([0.8, 1]);
});

test('after an opening it is asked, and the answers become proposals of which one is taken in one step', async () => {
  first.begin();
  expect(first.stage).toBe('ask');
  first.wish({cases: 'hard-cases', ways: ['sheets']});
  await first.show();
  expect(first.failure).toBeNull();
  const columns = columnsOf(first.proposals!);
  expect(columns.flatMap(({kinds}) => kinds).sort()).toEqual(['cheapest', 'most-margin', 'smallest']);
  const {proposal} = columns[0]!;
  expect(proposal.case).not.toBeNull();
  // Of sheets 1 mm, and 1 mm of measuring.
  expect(proposal.design.cut.clearance_mm).toBe(2);
  const {packing, moment: {design: before}} = studio;
  first.take(proposal);
  expect(first.stage).toBeNull();
  await vi.waitFor(() => expect(studio.packing).not.toBe(packing));
  expect(studio.moment.design.case.name).toBe(proposal.case);
  proposals = first.proposals!;
  await studio.undo();
  expect(studio.moment.design).toEqual(before);
});

test('the questions are remembered for the next object, but for what is its own', async () => {
  first.wish({cases: 'named', carrier: 'hand'});
  first.begin();
  expect(first.wishes).toMatchObject({carrier: 'hand', cases: 'cartons', ways: ['sheets'], foam: 'choose'});
});

test('figures say what is known and what is not', () => {
  const [proposal] = proposals;
  const of = (to: Partial<typeof proposal>) => shockOf({...proposal!, ...to}, 'parcel', t);
  expect(of({worst_g: 98, asked_g: 115, meets: 'yes'})).toEqual({look: 'good', text: 'Meets at most 98 G of 115 G'});
  expect(of({worst_g: 140, asked_g: 115, meets: 'no'}).look).toBe('danger');
  expect(of({worst_g: null, asked_g: 115, meets: 'no', why_none: 'thin'})).toEqual({look: 'danger', text: t.shock.untold});
  expect(of({worst_g: null, asked_g: null, meets: 'unknown', why_none: 'unsettled'})).toEqual({look: 'unknown', text: t.shock.untold});
  expect(of({worst_g: null, asked_g: 115, meets: 'no', why_none: 'bottoms'}).text).toBe(t.shock.bottoms);
  expect(of({worst_g: 98, asked_g: null, meets: 'unknown'}).text).toContain('At most 98 G');
  expect(of({worst_g: null, meets: 'unknown'}).text).toBe(t.shock.noData);
  expect(of({worst_g: null, meets: 'unknown', design: withMass(proposal!.design, 0, null)}).text).toBe(t.shock.noMass);
  expect(shockOf(proposal!, 'store', t).text).toBe(t.shock.store);
  expect([workOf(24, 60, t), workOf(360, 30, t)]).toEqual(['about 24 min', 'about 3 h']);
  expect([costOf({...proposal!, cost: 3.5, currency: 'EUR'}, t), costOf({...proposal!, cost: null, billed_kg: 4}, t)]).toEqual(['3.50 EUR', 'no price known; charged by carriers as 4 kg or more']);
  const finding = (code: string, severity: 'danger' | 'note') => ({code, severity, message: code});
  expect(worries({...proposal!, meets: 'no', findings: [finding('shock', 'danger'), finding('open', 'danger'), finding('open', 'danger'), finding('parts', 'note')]})).toEqual([finding('open', 'danger')]);
});

test('nothing is called cheapest where a price is not known', () => {
  const priced = proposals.map((each) => ({...each, cost: 3}));
  expect(titleOf(['smallest', 'cheapest'], priced, t)).toBe('Smallest and Cheapest');
  expect(titleOf(['smallest', 'cheapest'], [...priced, {...proposals[0]!, cost: null}], t)).toBe('Smallest and Cheapest to send');
  expect(onWeight(priced[0]!, ['cheapest'], t)).toEqual([]);
  const unpriced = {...priced[0]!, cost: null};
  expect(onWeight(unpriced, ['cheapest'], t)).toEqual([t.leastBilled, t.billedWhat]);
  expect(onWeight(unpriced, ['smallest'], t)).toEqual([t.billedWhat]);
});

test('a proposal of whose drops nothing good is known is not said to be fine', () => {
  const of = (to: Partial<Proposal>, carrier: 'parcel' | 'store' = 'parcel') => isFine({...proposals[0]!, findings: [], worst_g: 98, asked_g: 115, meets: 'yes', ...to}, carrier, t);
  expect(of({})).toBe(true);
  expect(of({findings: [{code: 'thin_wall', severity: 'warning', message: ''}]})).toBe(false);
  expect(of({worst_g: 140, meets: 'no'})).toBe(false);
  expect(of({worst_g: null, asked_g: null, meets: 'unknown'})).toBe(false);
  expect(of({worst_g: null, asked_g: null, meets: 'unknown'}, 'store')).toBe(true);
});

test('of a preview the drawing stays, without the maps below', () => {
  const picture = pictureOf(proposals[0]!.preview);
  const [, width, height] = /viewBox="0 0 ([\d.]+) ([\d.]+)"/.exec(picture)!.map(Number);
  expect(height! / width!).toBeLessThan(1);
});

test('a case is found by its name, with or without the maker’s, and says for how much foam it has room', async () => {
  const ranking = (await first.holding())!;
  const found = (typed: string) => findCases(ranking.fitting, typed, t.have.kinds).map(({name}) => name);
  expect(found('Peli 1450')).toEqual(['1450']);
  const {casesSeen} = await import('../../src/state/cases_seen.svelte');
  const called = (name: string) => calledCase(casesSeen.find(name)!);
  expect([called('1450'), kindOfCase(casesSeen.find('1450')!, t.have.kinds)]).toEqual(['Peli 1450', 'hard case']);
  for (const {case: name} of proposals) expect(name === null || casesSeen.find(name), name ?? '').toBeTruthy();
  expect(found('1450')).toEqual(['1450']);
  expect(found('peli 9999')).toEqual([]);
  expect(found('carton').length).toBeGreaterThan(2);
  expect(found('').length).toBe(ranking.fitting.length);
  const walls = (name: string) => mostWall(ranking.fitting.find((one) => one.name === name)!, ranking, false);
  const [least = 0] = [...ranking.leastInside].sort((a, b) => a - b);
  expect(walls('1450')).toBe(Math.floor((155 - least) / 2));
});

test('where nothing can be made the reason is told, and the questions are a step back', async () => {
  studio.becomes({...studio.moment, design: withCase(studio.moment.design, {inside_mm: [30, 30, 30]}, studio.defaults.case)}, '');
  first.wish({cases: 'named'});
  await first.show();
  expect(first.proposals).toBeNull();
  expect(first.failure?.[0]).toMatch(/\w+ \w+/);
  first.ask();
  expect(first.stage).toBe('ask');
});

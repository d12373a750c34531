import {describe, expect, it, test} from 'vitest';
import type {Triple} from '../../src/design/design';
import {duplicated, momentOf, withoutItem, withItems, withJoined, type Moment} from '../../src/design/moment';
import type {Zone} from '../../src/design/options';
import {
  erased,
  MOST_BALLS,
  Stroke,
  withLoose,
  withoutZone,
  withPress,
  withZone,
  withZones,
  zonesOf,
  type Ball,
} from '../../src/design/zones';
import {ballsByHeight} from '../../src/design/zones_by_height';
import {startCore} from '../support/snug';

const distance = (a: readonly number[], b: readonly number[]) => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
const pairs = <T>(all: readonly T[]) => all.flatMap((a, i) => all.slice(i + 1).map((b) => [a, b] as const));
const HANDLE: Zone = {balls: [[60, 0, 20, 15]], keep_off_mm: 15};
const SPOUT: Zone = {balls: [[0, 60, 20, 10]], press_kpa: 2};

/** The same numbers for the same seed. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

describe('a stroke', () => {
  it('leaves out what lies nearer than half its radius to a ball that is there, and no place within its radius uncovered', () => {
    const random = numbers(5);
    const places = Array.from({length: 3000}, () => [random() * 60, random() * 60, random() * 20] as Triple);
    const there: Ball[] = [[30, 30, 10, 8]];
    const stroke = new Stroke(there, 8);
    for (const place of places) stroke.add(place);
    for (const [a, b] of pairs([...there, ...stroke.balls])) expect(distance(a, b)).toBeGreaterThan(4 - 0.2);
    for (const place of places) expect(Math.min(...[...there, ...stroke.balls].map((ball) => distance(ball, place)))).toBeLessThan(8);
  });

  it('paints over smaller balls, which cover less than it', () => {
    const stroke = new Stroke([[0, 0, 0, 2]], 8);
    expect(stroke.add([0, 0, 0])).toEqual([0, 0, 0, 8]);
    expect(stroke.add([1, 0, 0])).toBeNull();
  });

  it('ends where a place is full', () => {
    const stroke = new Stroke(Array.from({length: MOST_BALLS - 1}, (_, i) => [i * 10, 0, 0, 5]), 5);
    expect(stroke.add([0, 100, 0])).not.toBeNull();
    expect(stroke.full).toBe(true);
    expect(stroke.add([0, 200, 0])).toBeNull();
  });
});

test('an eraser takes what it touches, and nothing else', () => {
  const balls: Ball[] = [[0, 0, 0, 5], [20, 0, 0, 5], [0, 0, 30, 20]];
  expect(erased(balls, [4, 0, 0], 2)).toEqual(balls.slice(1));
  expect(erased(balls, [10, 0, 0], 12)).toEqual([balls[2]]);
  expect(erased(balls, [0, 300, 0], 12)).toBe(balls);
});

describe('all between two heights', () => {
  // A square tower of 40 x 40 x 200 mm at survey coordinates, of twelve triangles.
  const origin: Triple = [430_000, 5_600_000, 120];
  const positions = [0, 200].flatMap((z) => [[0, 0, z], [40, 0, z], [40, 40, z], [0, 40, z]]).flat();
  const indices = [0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7];
  const {balls, full} = ballsByHeight({positions, indices}, origin, 2, [220, 260], [], 10);

  it('is covered, of triangles of any size, in the coordinates of the file', () => {
    expect(full).toBe(false);
    for (const [x, y] of [[0, 0], [40, 20], [20, 40], [0, 33], [13, 0]] as const)
      for (const z of [220, 231, 240, 252, 260])
        expect(Math.min(...balls.map((ball) => distance(ball, [origin[0] + x, origin[1] + y, z])))).toBeLessThanOrEqual(10);
  });

  it('reaches half a radius beyond, and not more', () => {
    for (const [, , z, r] of balls) expect([z - r >= 214.9, z + r <= 265.1]).toEqual([true, true]);
  });

  it('is spaced', () => {
    for (const [a, b] of pairs(balls)) expect(distance(a, b)).toBeGreaterThan(5.8);
    expect(balls.length).toBeLessThan(250);
  });

  it('is at one height only, too, and nothing where there is no surface', () => {
    expect(ballsByHeight({positions, indices}, origin, 2, [200, 200], [], 10).balls.length).toBeGreaterThan(10);
    expect(ballsByHeight({positions, indices}, origin, 2, [400, 500], [], 10).balls).toEqual([]);
  });
});

describe('whose places they are', async () => {
  const defaults = await (await startCore()).defaultDesign();
  const one = momentOf(defaults, 'vase');
  const joined = (moment: Moment) => withJoined(moment, [{id: 'cup', size_mm: null}], defaults, []);

  it('those of one item alone stand in the design, and become its own when another joins it', () => {
    const painted = withZone(one, 0, 0, HANDLE);
    expect(painted.design.protection.zones).toEqual([HANDLE]);
    const both = joined(painted);
    expect(both.design.protection.zones).toEqual([]);
    expect(both.design.items.map(({zones}) => zones)).toEqual([[HANDLE], []]);
    const left = withoutItem(both, 1);
    expect([left.design.protection.zones, left.design.items[0]!.zones]).toEqual([[HANDLE], []]);
  });

  it('they go with their item', () => {
    const both = withZone(joined(one), 1, 0, SPOUT);
    expect(withoutItem(both, 1).design.protection.zones).toEqual([]);
    expect(withoutItem(both, 0).design.protection.zones).toEqual([SPOUT]);
    expect(duplicated(both, 1, defaults, []).design.items[2]!.zones).toEqual([SPOUT]);
  });

  it('what holds for all stays with the others when one is painted', () => {
    const all = joined(one);
    const shared: Moment = {...all, design: {...all.design, protection: {...all.design.protection, zones: [HANDLE]}}};
    const painted = withZone(shared, 0, 1, SPOUT);
    expect([0, 1].map((item) => zonesOf(painted.design, item))).toEqual([[HANDLE, SPOUT], [HANDLE]]);
    // An item that has none any more does not get those of all back.
    const none = withoutZone(shared, 1, 0);
    expect([0, 1].map((item) => zonesOf(none.design, item))).toEqual([[HANDLE], []]);
  });

  it('one that lies nowhere is none', () => {
    expect(withZone(withZones(one, 0, [HANDLE, SPOUT]), 0, 0, {...HANDLE, balls: []}).design.protection.zones).toEqual([SPOUT]);
    expect(withItems(one, one.design.items)).toEqual(withZone(one, 0, 0, {keep_off_mm: 15}));
  });
});

test('what is loose is kept off and never pressed, and what is not pressed is kept off', () => {
  expect(withLoose(SPOUT, true)).toEqual({balls: SPOUT.balls, keep_off_mm: 15, loose: true});
  expect(withPress(SPOUT, null)).toEqual({balls: SPOUT.balls, keep_off_mm: 15});
  expect(withPress(HANDLE, 3)).toEqual({...HANDLE, press_kpa: 3});
});

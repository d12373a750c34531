import type {Design, Triple} from './design';
import {withItems, type Moment} from './moment';
import type {Zone} from './options';

// Places on items that foam keeps away from, as values: whose they are, and every change of them. Of one item alone they
// stand in the design, several have their own.

/** x, y, z in the coordinates of the object's file, and the radius, mm. */
export type Ball = [number, number, number, number];

/** As in snug/design/zone.h. */
export const MOST_ZONES = 100;
export const MOST_BALLS = 2000;
export const MOST_KEEP_OFF = 1000;

/** What a place begins with. */
export const NEW_ZONE: Zone = {keep_off_mm: 15};

export function ballsOf({balls = []}: Zone): readonly Ball[] {
  return balls;
}

/** With nothing that says what holds anyway, as the library writes it. */
function plain({balls = [], part = 0, keep_off_mm = 0, press_kpa, loose = false}: Zone): Zone {
  return {
    ...(balls.length > 0 && {balls}),
    ...(part > 0 && {part}),
    ...(keep_off_mm > 0 && {keep_off_mm}),
    ...(press_kpa !== undefined && {press_kpa}),
    ...(loose && {loose}),
  };
}

/** Of an item: its own, or those of all that have none. */
export function zonesOf({items, protection}: Design, item: number): readonly Zone[] {
  const own = items[item]?.zones ?? [];
  return own.length > 0 ? own : protection.zones;
}

/** Another item that had those of all keeps them as its own. */
export function withZones(moment: Moment, item: number, zones: readonly Zone[]): Moment {
  const {design} = moment;
  const {items, protection} = design;
  if (items.length < 2) {
    const alone = withItems(moment, items.map((one) => ({...one, zones: []})));
    return {...alone, design: {...alone.design, protection: {...protection, zones: [...zones]}}};
  }
  const own = items.map((one, i) => ({...one, zones: [...(i === item ? zones : zonesOf(design, i))]}));
  const changed = withItems(moment, own);
  return {...changed, design: {...changed.design, protection: {...protection, zones: []}}};
}

/** A zone that lies nowhere is none. `at`: one behind the last is new. */
export function withZone(moment: Moment, item: number, at: number, zone: Zone): Moment {
  const zones = [...zonesOf(moment.design, item)];
  zones[at] = plain(zone);
  return withZones(moment, item, zones.filter(liesSomewhere));
}

export function withoutZone(moment: Moment, item: number, at: number): Moment {
  return withZones(moment, item, zonesOf(moment.design, item).filter((_, i) => i !== at));
}

export function liesSomewhere({balls = [], part = 0}: Zone): boolean {
  return balls.length > 0 || part > 0;
}

/** What may not be touched is not pressed, and is kept off. */
export function withLoose(zone: Zone, loose: boolean): Zone {
  if (!loose) return {...zone, loose};
  const {press_kpa: _, ...others} = zone;
  return {...others, loose, keep_off_mm: zone.keep_off_mm || NEW_ZONE.keep_off_mm!};
}

/** What says neither how far foam keeps off nor what it bears says nothing: it keeps off as a new one does. */
export function withPress(zone: Zone, press_kpa: number | null): Zone {
  const {press_kpa: _, ...others} = zone;
  if (press_kpa !== null) return {...others, press_kpa};
  return {...others, keep_off_mm: zone.keep_off_mm || NEW_ZONE.keep_off_mm!};
}

/** Balls by their places, to be asked which are near one. */
class Near {
  readonly #cell_mm: number;
  readonly #cells = new Map<string, Ball[]>();

  constructor(cell_mm: number) {
    this.#cell_mm = cell_mm;
  }

  add(ball: Ball) {
    const name = this.#at(ball[0], ball[1], ball[2]).join();
    const there = this.#cells.get(name);
    if (there) there.push(ball);
    else this.#cells.set(name, [ball]);
  }

  /** Whether any centre lies within a cell's length. */
  any(x: number, y: number, z: number): boolean {
    const [i, j, k] = this.#at(x, y, z);
    for (let a = i - 1; a <= i + 1; a++)
      for (let b = j - 1; b <= j + 1; b++)
        for (let c = k - 1; c <= k + 1; c++)
          for (const ball of this.#cells.get(`${a},${b},${c}`) ?? [])
            if (Math.hypot(ball[0] - x, ball[1] - y, ball[2] - z) < this.#cell_mm) return true;
    return false;
  }

  #at(x: number, y: number, z: number): Triple {
    return [Math.floor(x / this.#cell_mm), Math.floor(y / this.#cell_mm), Math.floor(z / this.#cell_mm)];
  }
}

/** Balls are so far from each other, of their radius: what lies between two is covered to nearly its full width. */
const SPACING = 0.5;
/** Command lines and files stay short. */
const rounded = (mm: number) => Math.round(mm * 10) / 10;

/** A hand that paints: balls of one radius, none where one as large is near already. */
export class Stroke {
  /** What this stroke added. */
  readonly balls: Ball[] = [];
  readonly radius_mm: number;
  readonly #near: Near;
  #left: number;

  constructor(there: readonly Ball[], radius_mm: number, spacing = SPACING) {
    this.radius_mm = radius_mm;
    this.#near = new Near(radius_mm * spacing);
    for (const ball of there) if (ball[3] >= radius_mm) this.#near.add(ball);
    this.#left = MOST_BALLS - there.length;
  }

  get full(): boolean {
    return this.#left <= 0;
  }

  /** In the file's coordinates. What was added; none where enough is there. */
  add(place: Readonly<Triple>): Ball | null {
    if (this.full || this.#near.any(...place)) return null;
    const ball: Ball = [rounded(place[0]), rounded(place[1]), rounded(place[2]), this.radius_mm];
    this.#near.add(ball);
    this.balls.push(ball);
    this.#left--;
    return ball;
  }
}

/** Without those that the eraser meets: the place lies in them, or their middle within its reach. */
export function erased(balls: readonly Ball[], [x, y, z]: Readonly<Triple>, reach_mm: number): readonly Ball[] {
  const left = balls.filter((ball) => Math.hypot(ball[0] - x, ball[1] - y, ball[2] - z) > Math.max(reach_mm, ball[3]));
  return left.length === balls.length ? balls : left;
}

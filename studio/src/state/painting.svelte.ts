import type {Triple} from '../design/design';
import {ballsOf, erased, liesSomewhere, NEW_ZONE, Stroke, withZone, zonesOf, type Ball} from '../design/zones';
import type {Moment} from '../design/moment';
import type {Zone} from '../design/options';

export type Tool = 'brush' | 'eraser' | 'part' | 'height';

/** Whose places are painted. */
export interface Painted {
  readonly moment: Moment;
  readonly selected: number;
  readonly object: {readonly origin_mm: Triple | null} | null;
  becomes(next: Moment, control: string): void;
}

/** A hand that paints places on an item, which foam keeps away from. */
export class Painting {
  /** None: the hand does not paint. */
  tool: Tool | null = $state(null);
  radius_mm = $state(10);
  /** The place that was chosen, by its number; one behind the last is new and lies nowhere yet. */
  #chosen = $state(0);
  /** What the next new one begins with. */
  #fresh: Zone = $state.raw(NEW_ZONE);
  /** What is under the hand just now: the places as they will be. */
  #under: readonly Zone[] | null = $state.raw(null);
  #stroke: {of: Moment; item: number; at: number; zone: Zone; brush: Stroke | null; before: readonly Ball[]; left: readonly Ball[]} | null = null;
  /** Between which heights of the file's axis all of the surface is to be painted. */
  height: {axis: number; from: number; to: number} = $state.raw({axis: 2, from: 0, to: 0});
  /** There was no room for more balls. */
  full = $state(false);

  /** Of the selected item, with what is under the hand. */
  shown({moment, selected}: Painted): readonly Zone[] {
    return this.#under ?? zonesOf(moment.design, selected);
  }

  /** The number of the chosen one; never beyond a new one. */
  chosen({moment, selected}: Painted): number {
    return Math.min(this.#chosen, zonesOf(moment.design, selected).length);
  }

  /** The chosen one, or what a new one begins with. */
  zone(painted: Painted): Zone {
    return zonesOf(painted.moment.design, painted.selected)[this.chosen(painted)] ?? this.#fresh;
  }

  choose(zone: number) {
    this.#chosen = zone;
    this.full = false;
  }

  /** A new place, which the brush says. */
  begin({moment, selected}: Painted) {
    this.choose(zonesOf(moment.design, selected).length);
    this.#fresh = NEW_ZONE;
    this.tool = 'brush';
  }

  end() {
    this.drop();
    this.tool = null;
    this.full = false;
  }

  /** What is said of the chosen one; of a new one that lies nowhere it waits for the brush. */
  change(painted: Painted, zone: Zone, control: string) {
    if (!liesSomewhere(zone)) this.#fresh = zone;
    else painted.becomes(withZone(painted.moment, painted.selected, this.chosen(painted), zone), control);
  }

  /** The hand comes down; every place that it meets follows in meet(). */
  press(painted: Painted) {
    if (this.tool !== 'brush' && this.tool !== 'eraser') return;
    const zone = this.zone(painted);
    const before = ballsOf(zone);
    const brush = this.tool === 'brush' ? new Stroke(before, this.radius_mm) : null;
    const at = this.chosen(painted);
    this.#stroke = {of: painted.moment, item: painted.selected, at, zone, brush, before, left: before};
  }

  /** `own`: in the object's own coordinates. Whether anything changed. */
  meet({object}: Painted, own: Triple): boolean {
    const stroke = this.#stroke;
    if (!stroke) return false;
    const origin = object?.origin_mm ?? [0, 0, 0];
    const place = own.map((mm, axis) => mm + origin[axis]!) as Triple;
    const left = stroke.left;
    if (stroke.brush) {
      if (!stroke.brush.add(place)) return false;
      stroke.left = [...stroke.before, ...stroke.brush.balls];
    } else stroke.left = erased(left, place, this.radius_mm);
    if (stroke.left === left) return false;
    const zones = [...zonesOf(stroke.of.design, stroke.item)];
    zones[stroke.at] = {...stroke.zone, balls: stroke.left as Ball[]};
    this.#under = zones;
    return true;
  }

  /** The hand goes up: what it did is one step. */
  release(painted: Painted) {
    const stroke = this.#stroke;
    if (!stroke) return;
    this.full = stroke.brush?.full ?? false;
    this.drop();
    if (stroke.left === stroke.before || painted.moment !== stroke.of || painted.selected !== stroke.item) return;
    this.put(painted, stroke.left);
  }

  /** The hand did nothing. */
  drop() {
    this.#stroke = null;
    this.#under = null;
  }

  /** All of a part joins the chosen place, in place of another part; the same once more leaves it. */
  takePart(painted: Painted, part: number) {
    const zone = this.zone(painted);
    if (part > 0) this.put(painted, ballsOf(zone), zone.part === part ? 0 : part);
  }

  /** Where the chosen one lies from now on; one that lies nowhere any more waits for the brush with all that was said of
   *  it. */
  put(painted: Painted, balls: readonly Ball[], part = this.zone(painted).part) {
    const at = this.chosen(painted);
    const zone = {...this.zone(painted), balls: [...balls], ...(part === undefined ? {} : {part})};
    painted.becomes(withZone(painted.moment, painted.selected, at, zone), '');
    if (liesSomewhere(zone)) return this.choose(at);
    this.#fresh = zone;
    this.#chosen = zonesOf(painted.moment.design, painted.selected).length;
  }
}

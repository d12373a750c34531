import type {Triple} from '../design/design';
import type {Painted, Painting} from '../state/painting.svelte';
import type {Picked} from './picked';

/** Of a hand that paints. */
export interface Easel {
  readonly painting: Painting;
  readonly painted: Painted;
  /** Nothing may change just now. */
  readonly locked: boolean;
  /** What lies under a place of the page. */
  pick(at: {clientX: number; clientY: number}): Picked;
  /** Where the brush is, in the object's own mm. */
  hovers(at: Triple | null): void;
}

/** Between two places of a quick hand. */
const MOST_BETWEEN = 12;

type Point = {clientX: number; clientY: number};

/** Lets the first button or one finger paint the selected item. Whatever else a pointer does, and wherever it does not meet
 *  that item, turns the view. `around`: the canvas lies in it, so that this hears of a pointer first. */
export function letPaint(around: HTMLElement, canvas: HTMLElement, easel: Easel): () => void {
  let held: {id: number; first: PointerEvent; last: Point; own: Triple; part: number} | null = null;
  let passing = false;

  const met = (at: Point): {own: Triple; part: number} | null => {
    const {own, item, part} = easel.pick(at);
    return own && item === easel.painted.selected ? {own, part} : null;
  };

  function down(event: PointerEvent) {
    const {painting, painted} = easel;
    if (passing || easel.locked || event.target !== canvas || painting.tool === null || painting.tool === 'height') return;
    if (held) return event.pointerType === 'touch' ? handOver() : event.stopPropagation();
    if (event.button !== 0) return;
    const under = met(event);
    if (!under) return;
    event.stopPropagation();
    event.preventDefault();
    canvas.focus({preventScroll: true});
    canvas.setPointerCapture(event.pointerId);
    held = {id: event.pointerId, first: event, last: event, ...under};
    painting.press(painted);
    meet(under.own);
  }

  /** A second finger comes down: both turn the view, and nothing was painted. */
  function handOver() {
    const {first, last} = held!;
    held = null;
    easel.painting.drop();
    easel.hovers(null);
    passing = true;
    const {pointerId, pointerType, isPrimary} = first;
    canvas.dispatchEvent(new PointerEvent('pointerdown', {pointerId, pointerType, isPrimary, ...where(last), button: 0, buttons: 1, bubbles: true}));
    passing = false;
  }

  function move(event: PointerEvent) {
    if (!held || event.pointerId !== held.id) return;
    const events = event.getCoalescedEvents?.() ?? [];
    for (const each of events.length > 0 ? events : [event]) follow(where(each));
  }

  function follow(to: Point) {
    if (!held) return;
    const under = met(to);
    const {last, own} = held;
    held.last = to;
    if (!under) return easel.hovers(null);
    // What a quick hand leaves out.
    const apart = Math.hypot(...under.own.map((mm, axis) => mm - own[axis]!));
    const between = Math.min(Math.floor(apart / (easel.painting.radius_mm / 2)), MOST_BETWEEN);
    for (let i = 1; i <= between; i++) {
      const share = i / (between + 1);
      const on = met({
        clientX: last.clientX + (to.clientX - last.clientX) * share,
        clientY: last.clientY + (to.clientY - last.clientY) * share,
      });
      if (on) easel.painting.meet(easel.painted, on.own);
    }
    held.own = under.own;
    meet(under.own);
  }

  function meet(own: Triple) {
    easel.painting.meet(easel.painted, own);
    easel.hovers(own);
  }

  function up(event: PointerEvent) {
    if (!held || event.pointerId !== held.id) return;
    const {part} = held;
    held = null;
    const {painting, painted} = easel;
    if (painting.tool === 'part') painting.takePart(painted, part);
    else painting.release(painted);
    if (event.pointerType === 'touch') easel.hovers(null);
  }

  function cancel(event: PointerEvent) {
    if (!held || event.pointerId !== held.id) return;
    held = null;
    easel.painting.drop();
    easel.hovers(null);
  }

  const heard: [string, (event: PointerEvent) => void][] = [['pointerdown', down], ['pointermove', move], ['pointerup', up], ['pointercancel', cancel]];
  for (const [name, hear] of heard) around.addEventListener(name, hear as EventListener, {capture: true});
  return () => {
    for (const [name, hear] of heard) around.removeEventListener(name, hear as EventListener, {capture: true});
  };
}

function where({clientX, clientY}: Point): Point {
  return {clientX, clientY};
}

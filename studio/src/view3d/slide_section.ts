import type {Vector2} from 'three';

/** A plane with a knob, as a hand meets it. */
export interface Slide {
  /** Where the knob is in the picture, and how far it goes there with a mm; px of the page. None: null. */
  knob(): {at: Vector2; perMm: Vector2} | null;
  share(): number;
  /** The share that lies so many mm further. */
  after(share: number, mm: number): number;
  slides(share: number): void;
}

/** Around the knob, px: a finger is wider than a pointer. */
const REACH = {mouse: 16, pen: 20, touch: 28} as Record<string, number>;
/** Looked at from its end, the way would be endless. */
const LEAST_PER_MM = 0.15;

/** Lets a hand drag the plane by its knob. `around`: the canvas lies in it, so that this hears of a pointer first. */
export function letSlide(around: HTMLElement, canvas: HTMLElement, slide: Slide): () => void {
  let held: {id: number; from: {x: number; y: number}; perMm: Vector2; share: number} | null = null;

  const over = ({clientX, clientY, pointerType}: PointerEvent) => {
    const knob = slide.knob();
    if (!knob || Math.hypot(clientX - knob.at.x, clientY - knob.at.y) > (REACH[pointerType] ?? 20)) return null;
    return knob;
  };

  function down(event: PointerEvent) {
    const knob = event.button === 0 && event.target === canvas ? over(event) : null;
    if (!knob) return;
    event.stopPropagation();
    event.preventDefault();
    canvas.setPointerCapture(event.pointerId);
    held = {id: event.pointerId, from: {x: event.clientX, y: event.clientY}, perMm: knob.perMm, share: slide.share()};
  }

  function move(event: PointerEvent) {
    if (!held) {
      if (event.target === canvas && event.buttons === 0) around.classList.toggle('over-knob', over(event) !== null);
      return;
    }
    if (event.pointerId !== held.id) return;
    event.stopPropagation();
    const {from, perMm, share} = held;
    const way = (event.clientX - from.x) * perMm.x + (event.clientY - from.y) * perMm.y;
    slide.slides(slide.after(share, way / Math.max(perMm.lengthSq(), LEAST_PER_MM ** 2)));
  }

  function up(event: PointerEvent) {
    if (!held || event.pointerId !== held.id) return;
    event.stopPropagation();
    held = null;
  }

  const heard: [string, (event: PointerEvent) => void][] = [['pointerdown', down], ['pointermove', move], ['pointerup', up], ['pointercancel', up]];
  for (const [name, hear] of heard) around.addEventListener(name, hear as EventListener, {capture: true});
  return () => {
    for (const [name, hear] of heard) around.removeEventListener(name, hear as EventListener, {capture: true});
  };
}

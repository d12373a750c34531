/** A finger that rests so long asks for what the second button does. */
const LONG_PRESS_MS = 550;
/** And moves no more than this meanwhile, px. */
const RESTS_WITHIN = 8;

export interface Place {
  x: number;
  y: number;
}

/** Hears a person ask for the menu: the second button pressed and let go in one place, a finger that rests, or the keys.
 *  `asked`: where, px of the page. What is returned ends it. */
export function asksForMenu(canvas: HTMLElement, asked: (at: Place) => void): () => void {
  let pressed: (Place & {id: number; button: number}) | null = null;
  let fingers = 0;
  let resting: ReturnType<typeof setTimeout> | undefined;

  function down({clientX: x, clientY: y, pointerId: id, pointerType, button}: PointerEvent) {
    clearTimeout(resting);
    pressed = {x, y, id, button};
    if (pointerType !== 'touch') return;
    fingers++;
    if (fingers > 1) return void (pressed = null);
    resting = setTimeout(() => {
      pressed = null;
      asked({x, y});
    }, LONG_PRESS_MS);
  }

  function move({clientX, clientY, pointerId}: PointerEvent) {
    if (!pressed || pressed.id !== pointerId || Math.hypot(clientX - pressed.x, clientY - pressed.y) <= RESTS_WITHIN) return;
    clearTimeout(resting);
    pressed = null;
  }

  function up({pointerId, pointerType, type}: PointerEvent) {
    clearTimeout(resting);
    if (pointerType === 'touch') fingers = Math.max(fingers - 1, 0);
    const was = pressed;
    pressed = null;
    if (was && was.id === pointerId && was.button === 2 && type === 'pointerup') asked(was);
  }

  function press(event: KeyboardEvent) {
    if (event.key !== 'ContextMenu' && !(event.shiftKey && event.key === 'F10')) return;
    event.preventDefault();
    const {left, top, width, height} = canvas.getBoundingClientRect();
    asked({x: left + width / 2, y: top + height / 2});
  }

  const without = (event: Event) => event.preventDefault();
  const heard: [string, EventListener][] = [
    ['pointerdown', down as EventListener],
    ['pointermove', move as EventListener],
    ['pointerup', up as EventListener],
    ['pointercancel', up as EventListener],
    ['keydown', press as EventListener],
    ['contextmenu', without],
  ];
  for (const [name, hear] of heard) canvas.addEventListener(name, hear);
  return () => {
    clearTimeout(resting);
    for (const [name, hear] of heard) canvas.removeEventListener(name, hear);
  };
}

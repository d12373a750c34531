import {afterEach, beforeEach, expect, test, vi} from 'vitest';
import {asksForMenu} from '../../src/view3d/asks_for_menu';

// When a person asks for the view's menu, and when a hand only turns the view.

const canvas = Object.assign(new EventTarget(), {getBoundingClientRect: () => ({left: 100, top: 50, width: 400, height: 200})});
const asked = vi.fn();
let end: () => void;

beforeEach(() => {
  vi.useFakeTimers();
  asked.mockClear();
  end = asksForMenu(canvas as unknown as HTMLElement, asked);
});
afterEach(() => {
  end();
  vi.useRealTimers();
});

function send(type: string, values: object) {
  canvas.dispatchEvent(Object.assign(new Event(type, {cancelable: true}), {pointerId: 1, pointerType: 'mouse', button: 0, clientX: 10, clientY: 20, ...values}));
}
const finger = (pointerId: number, clientX = 10) => ({pointerType: 'touch', pointerId, clientX});

test('the second button asks where it is let go, unless it dragged', () => {
  send('pointerdown', {button: 2});
  send('pointerup', {button: 2});
  expect(asked).toHaveBeenCalledExactlyOnceWith(expect.objectContaining({x: 10, y: 20}));
  send('pointerdown', {button: 2});
  send('pointermove', {button: -1, clientX: 40});
  send('pointerup', {button: 2, clientX: 40});
  send('pointerdown', {});
  send('pointerup', {});
  expect(asked).toHaveBeenCalledOnce();
});

test('a finger that rests asks; one that moves, taps or is not alone turns the view', () => {
  send('pointerdown', finger(1));
  vi.advanceTimersByTime(300);
  send('pointerup', finger(1));
  send('pointerdown', finger(1));
  send('pointermove', finger(1, 60));
  vi.advanceTimersByTime(2000);
  send('pointerup', finger(1, 60));
  send('pointerdown', finger(1));
  send('pointerdown', finger(2));
  vi.advanceTimersByTime(2000);
  send('pointerup', finger(1));
  send('pointerup', finger(2));
  expect(asked).not.toHaveBeenCalled();
  send('pointerdown', finger(3));
  send('pointermove', finger(3, 13));
  vi.advanceTimersByTime(700);
  expect(asked).toHaveBeenCalledExactlyOnceWith({x: 10, y: 20});
});

test('keys ask in the middle of the view', () => {
  send('keydown', {key: 'F10', shiftKey: true});
  send('keydown', {key: 'ContextMenu'});
  send('keydown', {key: 'F10', shiftKey: false});
  expect(asked.mock.calls).toEqual([[{x: 300, y: 150}], [{x: 300, y: 150}]]);
});

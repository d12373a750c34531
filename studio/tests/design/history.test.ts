import {describe, expect, it} from 'vitest';
import {canRedo, canUndo, Gestures, moved, present, record, startHistory} from '../../src/design/history';

describe('the history', () => {
  it('goes back and forth, and forgets what was undone before a change', () => {
    let history = startHistory(0);
    for (const moment of [1, 2, 3]) history = record(history, moment, '');
    history = moved(moved(history, -1), -1);
    expect(present(history)).toBe(1);
    expect(canRedo(history)).toBe(true);
    history = record(history, 9, 'x');
    expect(history.moments).toEqual([0, 1, 9]);
    expect(canRedo(history)).toBe(false);
    for (let i = 0; i < 9; i++) history = moved(history, -1);
    expect(present(history)).toBe(0);
    expect(canUndo(history)).toBe(false);
  });

  it('takes a drag as one step, and two drags as two', () => {
    let history = startHistory(0);
    const gestures = new Gestures();
    for (let i = 1; i <= 10; i++) history = record(history, i, gestures.step('slider', i * 16));
    history = record(history, 20, gestures.step('slider', 5000));
    history = record(history, 21, gestures.step('other', 5010));
    history = record(history, 22, gestures.step('other', 5020));
    history = record(history, 23, gestures.step('', 5030));
    history = record(history, 24, gestures.step('', 5040));
    expect(history.moments).toEqual([0, 10, 20, 22, 23, 24]);
  });

  it('takes a drag as one step, however few of its changes have foams', () => {
    let history = startHistory(0);
    const gestures = new Gestures();
    for (let i = 1; i <= 500; i++) {
      const step = gestures.step('handles', i * 16);
      if (i % 120 === 0) history = record(history, i, step);
    }
    expect(history.moments).toEqual([0, 480]);
  });

  it('never loses where it started from while one control moves', () => {
    let history = record(startHistory('start'), 'a', 'slider 1');
    history = record(history, 'b', 'slider 1');
    expect(history.moments).toEqual(['start', 'b']);
  });
});

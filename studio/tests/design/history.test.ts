import {describe, expect, it} from 'vitest';
import {canRedo, canUndo, moved, present, record, startHistory} from '../../src/design/history';

describe('the history', () => {
  it('goes back and forth, and forgets what was undone before a change', () => {
    let history = startHistory(0);
    for (const moment of [1, 2, 3]) history = record(history, moment, '', 0);
    history = moved(moved(history, -1), -1);
    expect(present(history)).toBe(1);
    expect(canRedo(history)).toBe(true);
    history = record(history, 9, 'x', 0);
    expect(history.moments).toEqual([0, 1, 9]);
    expect(canRedo(history)).toBe(false);
    for (let i = 0; i < 9; i++) history = moved(history, -1);
    expect(present(history)).toBe(0);
    expect(canUndo(history)).toBe(false);
  });

  it('takes a drag as one step, and two drags as two', () => {
    let history = startHistory(0);
    for (let i = 1; i <= 10; i++) history = record(history, i, 'slider', i * 16);
    history = record(history, 20, 'slider', 5000);
    history = record(history, 21, 'other', 5010);
    expect(history.moments).toEqual([0, 10, 20, 21]);
  });

  it('never loses where it started from while one control moves', () => {
    let history = record(startHistory('start'), 'a', 'slider', 0);
    history = record(history, 'b', 'slider', 1);
    expect(history.moments).toEqual(['start', 'b']);
  });
});

import {expect, test, vi} from 'vitest';
import type {DisplayMesh} from '../../src/engine/api';
import {knownThumbnail} from '../../src/picture/known_thumbnails';
import type {Picture} from '../../src/picture/thumbnail';

/** A flat plate, so that it looks different lying and standing. */
const plate = (): DisplayMesh => ({
  positions: new Float32Array([0, 0, 0, 40, 0, 0, 40, 30, 0, 0, 30, 1]),
  indices: new Uint32Array([0, 1, 2, 0, 2, 3]),
  deviation: 0,
});
const LYING = '0,90,0';

test('a picture is drawn later and kept: the next wish has it at once', async () => {
  const mesh = plate();
  const first = vi.fn<(picture: Picture) => void>();
  knownThumbnail(mesh, LYING, 24, first);
  expect(first).not.toHaveBeenCalled();
  await vi.waitFor(() => expect(first).toHaveBeenCalledOnce());
  const again = vi.fn<(picture: Picture) => void>();
  knownThumbnail(mesh, LYING, 24, again);
  expect(again.mock.calls).toEqual(first.mock.calls);
  expect(again.mock.calls[0]![0]).toBe(first.mock.calls[0]![0]);
});

test('a wish that is taken back is not drawn, and the others are', async () => {
  const mesh = plate();
  const [left, stays] = [vi.fn(), vi.fn()];
  knownThumbnail(mesh, '0,0,90', 24, stays);
  const takeBack = knownThumbnail(mesh, '90,0,0', 24, left);
  takeBack();
  await vi.waitFor(() => expect(stays).toHaveBeenCalledOnce());
  await new Promise((resolve) => setTimeout(resolve, 80));
  expect(left).not.toHaveBeenCalled();
});

import {describe, expect, it} from 'vitest';
import {bundled} from '../src/state/bundle';

const names = (...all: string[]) => all.map((name) => ({name}));

describe('several files at once', () => {
  it('have the object among them found, wherever it stands', () => {
    for (const files of [
      names('bust.mtl', 'bust.obj', 'bust.jpg'),
      names('bust.obj', 'bust.jpg', 'bust.mtl'),
      names('._bust.obj', 'bust.jpg', 'bust.obj'),
    ])
      expect(bundled(files)).toEqual({object: {name: 'bust.obj'}, leftOut: []});
    expect(bundled(names('scene.bin', 'scene.GLTF')).object?.name).toBe('scene.GLTF');
  });

  it('leave every other object out by name', () => {
    expect(bundled(names('a.stl', 'b.jpg', 'c.3mf'))).toEqual({object: {name: 'a.stl'}, leftOut: [{name: 'c.3mf'}]});
  });

  it('are refused by the name of the first where none is an object', () => {
    expect(bundled(names('notes.txt', 'bust.jpg')).object?.name).toBe('notes.txt');
    expect(bundled([]).object).toBeUndefined();
  });
});

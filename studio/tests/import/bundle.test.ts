import {describe, expect, it} from 'vitest';
import {bundled} from '../../src/import/bundle';

const names = (...all: string[]) => all.map((name) => ({name}));

describe('several files at once', () => {
  it('have the object among them found, wherever it stands', () => {
    for (const files of [
      names('bust.mtl', 'bust.obj', 'bust.jpg'),
      names('bust.obj', 'bust.jpg', 'bust.mtl'),
      names('._bust.obj', 'bust.jpg', 'bust.obj'),
    ])
      expect(bundled(files)).toMatchObject({objects: [{name: 'bust.obj'}], leftOut: []});
    expect(bundled(names('scene.bin', 'scene.GLTF')).objects).toEqual(names('scene.GLTF'));
  });

  it('may be several objects', () => {
    expect(bundled(names('a.stl', 'b.jpg', 'c.3mf'))).toEqual({
      objects: names('a.stl', 'c.3mf'),
      beside: names('b.jpg'),
      leftOut: [],
    });
    expect(bundled(names('camera.ply', 'lens.shape')).objects).toHaveLength(2);
  });

  it('give the object what is no object, which it may need', () => {
    expect(bundled(names('a.bin', 'chair.gltf', 'b.bin')).beside).toEqual(names('a.bin', 'b.bin'));
  });

  it('are looked for in an archive only where there is no object beside it', () => {
    expect(bundled(names('notes.txt', 'bust.zip')).objects).toEqual(names('bust.zip'));
    expect(bundled(names('bust.zip', 'bust.obj'))).toMatchObject({objects: names('bust.obj'), leftOut: names('bust.zip')});
  });

  it('are refused by the name of the first where none is an object', () => {
    expect(bundled(names('notes.txt', 'bust.jpg')).objects).toEqual(names('notes.txt'));
    expect(bundled([]).objects).toEqual([]);
  });
});

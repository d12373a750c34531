import {describe, expect, it} from 'vitest';
import type {Design} from '../src/engine/api';
import {openFiles} from '../src/state/open_files';
import type {Studio} from '../src/state/studio.svelte';
import {en} from '../src/i18n/en';
import {startCore} from './support/snug';

describe('a file that is too big for a page', () => {
  it('is not read, and gets the command that makes its foams', async () => {
    const defaults: Design = await (await startCore()).defaultDesign();
    const refused: string[] = [];
    const studio = {defaults, refuse: (_: string, text: string) => refused.push(text)} as unknown as Studio;
    const file = new File(['x'], 'big scan.stl');
    Object.defineProperty(file, 'size', {value: 4e9});
    await openFiles(studio, [file], en.files);
    expect(refused).toEqual([
      "big scan.stl is too big for the browser. The command line makes its foams: snug make 'big scan.stl' --blocks=auto -o 'big scan-foam'",
    ]);
  });
});

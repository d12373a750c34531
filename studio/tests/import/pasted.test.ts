import {expect, test} from 'vitest';
import {pastedFiles} from '../../src/import/pasted';

const clipboard = (text: string, ...files: File[]) => ({files, getData: () => text});

test('files are pasted as they are, a project as its text, and other words not at all', async () => {
  const file = new File(['solid'], 'bust.stl');
  expect(pastedFiles(clipboard('/home/bust.stl', file))).toEqual([file]);
  const [project] = pastedFiles(clipboard(' {"snug": 1}\n'));
  expect(project?.name).toMatch(/\.json$/);
  expect(await project?.text()).toBe('{"snug": 1}');
  expect(pastedFiles(clipboard('bust'))).toEqual([]);
  expect(pastedFiles(clipboard(''))).toEqual([]);
});

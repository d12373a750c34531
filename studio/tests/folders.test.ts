import {readdirSync, readFileSync} from 'node:fs';
import {dirname, join, normalize} from 'node:path';
import {fileURLToPath} from 'node:url';
import {expect, test} from 'vitest';

const SRC = fileURLToPath(new URL('../src', import.meta.url));
const GUIDE = fileURLToPath(new URL('../../docs/architecture.md', import.meta.url));

/** The studio's folders in the order of the guide, with what it says that each uses. */
const guide = readFileSync(GUIDE, 'utf8').split('\n## The studio\n')[1]?.split('\n## ')[0] ?? '';
const rows = [...guide.matchAll(/^\| `(\w+)\/` \|.*\|([^|]*)\|$/gm)].map(([, folder, uses]) => ({
  folder: folder!,
  uses: uses!.match(/\w+/g) ?? [],
}));
const folders = rows.map(({folder}) => folder);

/** Of a file in src/, the files of src/ that it imports, whatever for. */
function imports(file: string): string[] {
  const text = readFileSync(join(SRC, file), 'utf8');
  const named = [...text.matchAll(/(?:^|[^\w.])(?:from|import|import\()\s*'(\.[^']*)'/gm)].map(([, path]) => path!);
  return named.map((path) => normalize(join(dirname(file), path)));
}

const folderOf = (path: string) => (path.includes('/') ? path.split('/')[0]! : '');
const used = readdirSync(SRC, {recursive: true, encoding: 'utf8'})
  .filter((name) => /\.(ts|svelte)$/.test(name))
  .flatMap((file) => imports(file).map((path) => ({file, path, from: folderOf(file), to: folderOf(path)})))
  .filter(({from, to}) => from !== '' && from !== to);

test('the guide lists the folders that there are', () => {
  const there = readdirSync(SRC, {withFileTypes: true}).filter((entry) => entry.isDirectory());
  expect([...folders].sort()).toEqual(there.map(({name}) => name).sort());
});

test('a folder uses only those above it, so that nothing goes round in a circle', () => {
  expect(used.length).toBeGreaterThan(200);
  const above = (from: string, to: string) => folders.includes(to) && folders.indexOf(to) < folders.indexOf(from);
  expect(used.filter(({from, to}) => !above(from, to)).map(({file, path}) => `${file} uses ${path}`)).toEqual([]);
});

test('a folder uses what the guide says, and the widgets know nothing of the work', () => {
  for (const {folder, uses} of rows) {
    const seen = new Set(used.filter(({from}) => from === folder).map(({to}) => to));
    expect([...seen].sort(), folder).toEqual([...uses].sort());
  }
  expect(rows.find(({folder}) => folder === 'ui')?.uses).toEqual(['words']);
});

import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import type {Plugin} from 'vite';

interface Locked {
  packages: Record<string, {version: string; license?: string; dev?: boolean}>;
}

/** What is built with tools, of which the page has a part. */
const IN_THE_PAGE = ['node_modules/svelte'];

/** The licences of all that the built page has of others, whose texts must come with it. */
export function licenses(folder: string): string {
  const {packages} = JSON.parse(readFileSync(join(folder, 'package-lock.json'), 'utf8')) as Locked;
  return Object.entries(packages)
    .filter(([path, {dev}]) => path !== '' && (!dev || IN_THE_PAGE.includes(path)))
    .map(([path, {version, license = ''}]) => {
      const name = path.slice(path.lastIndexOf('node_modules/') + 'node_modules/'.length);
      return `${name} ${version}: ${license}\n\n${textIn(join(folder, path))}`;
    })
    .join('\n\n');
}

function textIn(folder: string): string {
  const name = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
  return name ? readFileSync(join(folder, name), 'utf8').trim() : '';
}

/** Leaves them as a file beside the page. */
export function licenseFile(text: string): Plugin {
  return {
    name: 'snug-licenses',
    apply: 'build',
    generateBundle() {
      this.emitFile({type: 'asset', fileName: 'licenses.txt', source: text});
    },
  };
}

import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';
import type {Plugin, Rollup} from 'vite';

interface Parts {
  /** Of the file that is made. */
  name: string;
  /** An SVG file. */
  icon: string;
  /** A text that comes with it. */
  licenses: string;
}

/** Puts the built page into a single file, which works when it is opened from a disk: browsers load no script, style or worker
 *  from beside such a page. Its policy names what it runs by their hashes, and lets it ask for nothing. */
export function oneFile({name, icon, licenses}: Parts): Plugin {
  return {
    name: 'snug-one-file',
    apply: 'build',
    enforce: 'post',
    generateBundle(_, bundle) {
      const page = bundle['index.html'];
      if (page?.type !== 'asset') throw new Error('there is no index.html');
      delete bundle['index.html'];
      const files = Object.values(bundle);
      const script = embedded(the(files.filter((file) => file.type === 'chunk')).code);
      const style = String(the(files.filter(isStyle)).source);
      for (const file of files) delete bundle[file.fileName];
      const source = whole(String(page.source), script, style, dataAddress(icon)) + comment(licenses);
      this.emitFile({type: 'asset', fileName: name, source});
    },
  };
}

function isStyle(file: Rollup.OutputAsset | Rollup.OutputChunk): file is Rollup.OutputAsset {
  return file.type === 'asset' && file.fileName.endsWith('.css');
}

function the<T extends {fileName: string}>(files: readonly T[]): T {
  const [one, ...others] = files;
  if (!one || others.length > 0) throw new Error(`one is needed, not ${files.map(({fileName}) => fileName).join(', ') || 'none'}`);
  return one;
}

/** What would end the element, or begin a comment in it, as an escape that stands for the same in every literal. */
function embedded(script: string): string {
  return script.replace(/<(?=\/?script|!--)/gi, '\\x3C');
}

function whole(page: string, script: string, style: string, icon: string): string {
  const policy = [
    "default-src 'none'",
    `script-src ${hashOf(script)} 'wasm-unsafe-eval'`,
    `style-src ${hashOf(style)}`,
    'img-src data: blob:',
    'worker-src blob:',
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
  const changes: [RegExp, string][] = [
    [/(http-equiv="Content-Security-Policy"\s+content=")[^"]*/, `$1${policy}`],
    [/(<link rel="icon" href=")[^"]*/, `$1${icon}`],
    [/ *<link rel="manifest"[^>]*>\n/, ''],
    [/ *<script type="module"[^>]*><\/script>\n/, ''],
    [/<link rel="stylesheet"[^>]*>/, '<style></style>'],
    [/(?=<\/body>)/, '<script type="module"></script>\n  '],
  ];
  const changed = changes.reduce((text, [from, to]) => {
    if (!from.test(text)) throw new Error(`index.html has no ${from}`);
    return text.replace(from, to);
  }, page);
  // As functions: what stands in a script is no pattern.
  return changed.replace('<style>', () => `<style>${style}`).replace('<script type="module">', () => `<script type="module">${script}`);
}

function comment(text: string): string {
  return `<!--\n${text.replaceAll('--', '- -')}\n-->\n`;
}

function hashOf(text: string): string {
  return `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
}

function dataAddress(svg: string): string {
  return `data:image/svg+xml;base64,${readFileSync(svg, 'base64')}`;
}

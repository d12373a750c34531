import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';
import type {Plugin} from 'vite';

/** Writes dist/service_worker.js from src/service_worker.js, with the list of all built files and a name for them
 *  that changes when they do. */
export function serviceWorker(source: string, publicFiles: readonly string[]): Plugin {
  return {
    name: 'snug-service-worker',
    apply: 'build',
    generateBundle(_, bundle) {
      const hash = createHash('sha256');
      for (const [name, file] of Object.entries(bundle).sort(([a], [b]) => (a < b ? -1 : 1)))
        hash.update(name).update(file.type === 'chunk' ? file.code : file.source);
      const files = ['./', ...Object.keys(bundle).filter((name) => name !== 'index.html'), ...publicFiles];
      const text = readFileSync(source, 'utf8')
        .replace('__FILES__', JSON.stringify(files))
        .replace('__VERSION__', JSON.stringify(hash.digest('hex').slice(0, 16)));
      this.emitFile({type: 'asset', fileName: 'service_worker.js', source: text});
    },
  };
}

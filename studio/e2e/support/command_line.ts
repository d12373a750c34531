import {execFileSync} from 'node:child_process';
import {mkdtempSync, readdirSync, readFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

export const SNUG = fileURLToPath(new URL('../../../build/snug', import.meta.url));

export function folder(): string {
  return mkdtempSync(join(tmpdir(), 'snug-studio-'));
}

export function snug(...options: string[]): string {
  return execFileSync(SNUG, options, {encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe']});
}

/** A sample as a file in a new folder. */
export function sample(name: string, ending = 'stl'): string {
  const path = join(folder(), `${name}.${ending}`);
  snug('sample', name, '-o', path);
  return path;
}

/** All that `snug make` writes, by name. */
export function made(...options: string[]): Map<string, Buffer> {
  const out = join(folder(), 'out');
  snug('make', ...options, '-o', out, '--quiet');
  return new Map(readdirSync(out).filter((name) => !name.startsWith('.')).map((name) => [name, readFileSync(join(out, name))]));
}

/** A report without what differs from run to run. */
export function untimed(report: Buffer): unknown {
  const {timing_ms: _, ...rest} = JSON.parse(report.toString()) as Record<string, unknown>;
  return rest;
}

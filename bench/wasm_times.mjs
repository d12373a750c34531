// The same packs as method_times makes, by the library as WebAssembly under node.
// Usage: node wasm_times.mjs WASM_FOLDER FOLDER (where method_times left largest.ply and its report)
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

const SIDE_MM = 240 * 1.1;
const LAYERS = 30;

const [wasmFolder, folder] = process.argv.slice(2);
const {default: createSnug} = await import(join(wasmFolder, 'snug.mjs'));
const snug = await createSnug({wasmBinary: readFileSync(join(wasmFolder, 'snug.wasm'))});
const {rotations} = JSON.parse(readFileSync(join(folder, 'method.json'), 'utf8'));
const design = JSON.parse(snug.defaultDesign());
design.object.units = 'mm';
const session = new snug.Session();
const info = session.load(readFileSync(join(folder, 'largest.ply')), 'largest.ply', JSON.stringify(design));
if (info.error) throw new Error(info.error);

const results = [30, 300].map((columns) => {
  design.space.blocks = [LAYERS, columns, columns];
  design.space.block_mm = [SIDE_MM / LAYERS, SIDE_MM / columns, SIDE_MM / columns];
  const times = [];
  // The first calls compile the module and prepare the object.
  for (let pass = 0; pass < 2; pass++)
    for (const rotation of rotations) {
      design.placement.rotation_deg = rotation;
      const packing = session.pack(JSON.stringify(design));
      if (packing.error) throw new Error(packing.error);
      if (pass > 0) times.push(packing.library_ms);
    }
  times.sort((a, b) => a - b);
  const at = (share) => times[Math.min(times.length - 1, Math.floor(share * times.length))];
  return {columns, time: {median: at(0.5), low: at(0.25), high: at(0.75), count: times.length}};
});
console.log(JSON.stringify({node: process.version, pack: results}, null, 1));

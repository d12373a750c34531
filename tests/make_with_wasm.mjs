// Does under node what `snug make PROJECT -o FOLDER` does, with the WebAssembly build.
// Usage: node make_with_wasm.mjs WASM_FOLDER OBJECT PROJECT FOLDER
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

const [wasmFolder, objectPath, projectPath, folder] = process.argv.slice(2);
const {default: createSnug} = await import(join(wasmFolder, 'snug.mjs'));
const snug = await createSnug({wasmBinary: readFileSync(join(wasmFolder, 'snug.wasm'))});

const result = snug.make(readFileSync(objectPath), readFileSync(projectPath, 'utf8'));
if (result.error) {
  console.error(result.error);
  process.exit(1);
}
mkdirSync(folder, {recursive: true});
for (const {name, bytes} of result.files) writeFileSync(join(folder, name), bytes);
writeFileSync(join(folder, 'report.json'), result.report);

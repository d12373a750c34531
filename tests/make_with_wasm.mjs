// Does under node what `snug make PROJECT -o FOLDER` does, with the WebAssembly build; PDF is left out, and a 3MF
// becomes a folder of its members.
// Usage: node make_with_wasm.mjs WASM_FOLDER OBJECT PROJECT FOLDER LANGUAGE
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';
import {dirname, join} from 'node:path';

const [wasmFolder, objectPath, projectPath, folder, language] = process.argv.slice(2);
const {default: createSnug} = await import(join(wasmFolder, 'snug.mjs'));
const snug = await createSnug({wasmBinary: readFileSync(join(wasmFolder, 'snug.wasm'))});

const result = snug.make(readFileSync(objectPath), readFileSync(projectPath, 'utf8'), null, language);
if (result.error) {
  console.error(result.error[0]);
  process.exit(1);
}
const {files = [], containers = []} = result.pack ?? {};
const members = containers.flatMap(({name, members: inside}) =>
  inside.map((member) => ({...member, name: join(name, member.name)})),
);
const report = {name: 'report.json', bytes: result.report};
for (const {name, bytes} of [...result.files, ...files, ...members, report]) {
  mkdirSync(dirname(join(folder, name)), {recursive: true});
  writeFileSync(join(folder, name), bytes);
}

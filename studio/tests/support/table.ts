import type {OptionRow} from '../../src/design/options';

/** The type of what a project has for an option. */
function typeOf(row: OptionRow): string {
  const words = (row.words ?? []).map((word) => `'${word.replaceAll("'", "\\'")}'`).join(' | ');
  const list = row.count === undefined ? 'number[]' : `[${Array(row.count).fill('number').join(', ')}]`;
  const types: Record<OptionRow['kind'], string> = {
    switch: 'boolean',
    integer: 'number',
    number: 'number',
    text: words || 'string',
    word: words,
    levels: 'number | number[]',
    numbers: row.or_one ? 'number | number[]' : list,
    integers: list,
    words: words ? `(${words})[]` : 'string[]',
    pieces: 'Record<string, number>',
    curve: '[number, number][]',
    zones: '{balls?: [number, number, number, number][]; part?: number; keep_off_mm?: number; press_kpa?: number; loose?: boolean}[]',
    edits: '{piece: string; j: number; k: number; blocks: number; under?: boolean}[]',
    weights: 'Record<string, number>',
    group: '',
    list: '',
  };
  const none = row.none === undefined ? 'null' : `'${row.none}'`;
  return types[row.kind] + (row.optional ? ` | ${none}` : '');
}

function comment({help, unit}: OptionRow): string {
  return `/** ${help?.[0]}${unit ? ` (${unit})` : ''}. */`;
}

/** The members below `prefix`, each with what it does. */
function members(schema: Record<string, OptionRow>, prefix: string, indent: string): string {
  const below = Object.keys(schema).filter((path) => path.startsWith(prefix) && !['group', 'list'].includes(schema[path]!.kind));
  const names = [...new Set(below.map((path) => path.slice(prefix.length).split('.')[0]!))];
  return names
    .map((name) => {
      const path = prefix + name;
      const row = schema[path];
      if (row?.kind === 'list') return `${indent}${name}: {\n${members(schema, `${path}.0.`, `${indent}  `)}${indent}}[];\n`;
      if (row && row.kind !== 'group') return `${indent}${comment(row)}\n${indent}${name}: ${typeOf(row)};\n`;
      const inner = members(schema, `${path}.`, `${indent}  `);
      return `${indent}${name}: {\n${inner}${indent}}${row ? ' | null' : ''};\n`;
    })
    .join('');
}

/** The studio's types of a design. */
export function tableFile(schema: Record<string, OptionRow>): string {
  const paths = Object.keys(schema).map((path) => `\n  | '${path}'`);
  return (
    '// Made from the table of options beside the library’s structs: `SNUG_WRITE=1 npx vitest run tests/design/table.test.ts`\n' +
    '// writes it.\n\n' +
    '/** Everything that a person chooses: the `design` of a project file. */\n' +
    `export interface Design {\n${members(schema, '', '  ')}}\n\n` +
    `/** Every option by its path in a design. */\nexport type OptionPath =${paths.join('')};\n`
  );
}

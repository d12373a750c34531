import type {Design, Triple} from './api';

/** The command that makes the same foams from the same file: what differs from the defaults, and nothing else. */
export function makeLine(file: string, design: Design, defaults: Design): string {
  const {object, space, placement, cut, parting, output} = design;
  const options: string[] = [];
  // With "=", since a value may begin with a minus sign.
  const add = (name: string, value: string, usual: string) => {
    if (value !== usual) options.push(`--${name}=${value}`);
  };
  const flag = (name: string, on: boolean) => on && options.push(`--${name}`);

  if (object.units) add('units', object.units, '');
  add('scale', decimal(object.scale), '1');
  if (object.longest_mm !== null) add('longest', decimal(object.longest_mm), '');
  flag('cap', object.cap);
  add('preset', quoted(space.preset), quoted(defaults.space.preset));
  const blocks = (value: Triple | 'auto') => (value === 'auto' ? value : value.join('x'));
  add('blocks', blocks(space.blocks), blocks(defaults.space.blocks));
  // A preset brings its own sizes and clearance, so both are said wherever one is named.
  const own = space.preset !== defaults.space.preset;
  const size = (value: Triple) => value.map(decimal).join('x');
  add('block-size', size(space.block_mm), own ? '' : size(defaults.space.block_mm));
  add('clearance', decimal(cut.clearance_mm), own ? '' : decimal(defaults.cut.clearance_mm));
  if (space.wall_mm !== null) add('wall', [space.wall_mm].flat().map(decimal).join(), '');
  const list = (value: Triple) => value.map(decimal).join(',');
  add('rotate', list(placement.rotation_deg), list(defaults.placement.rotation_deg));
  add('move', list(placement.offset_mm), list(defaults.placement.offset_mm));
  flag('cut-on-touch', cut.cut_on_touch);
  add('parting', String(parting.level), String(defaults.parting.level));
  add('formats', output.formats.join(','), defaults.output.formats.join(','));
  return ['snug make', quoted(file), ...options, '-o', quoted(`${file.replace(/\.[^.]+$/, '')}-foam`)].join(' ');
}

/** Never an exponent, which the command line does not read. */
function decimal(value: number): string {
  const text = value.toFixed(12).replace(/\.?0+$/, '');
  return text === '-0' ? '0' : text;
}

/** For a shell. */
function quoted(text: string): string {
  return /^[\w.][\w./-]*$/.test(text) ? text : `'${(/^-/.test(text) ? `./${text}` : text).replaceAll("'", `'\\''`)}'`;
}

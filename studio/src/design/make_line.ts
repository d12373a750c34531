import type {BrickOptions, CaseOptions, Design, MillOptions, Triple, Work, WorkshopOptions} from './design';

/** The command that makes the same foams from the same file: what differs from the defaults, and nothing else. */
export function makeLine(file: string, design: Design, defaults: Design): string {
  const {object, space, placement, cut, fit, parting, output, workshop} = design;
  const inside = design.case.inside_mm;
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
  add('point-radius', decimal(object.point_radius_mm), '0');
  add('drop', object.clean.drop_parts.join(), '');
  add('drop-below', decimal(object.clean.drop_below_mm), '0');
  add('cut-plane', (object.clean.cut_plane ?? []).map(decimal).join(), '');
  // A way of working implies a foam of its own unless one is named.
  add('preset', quoted(space.preset), workshop.for ? '' : quoted(defaults.space.preset));
  const blocks = (value: Triple | 'auto') => (value === 'auto' ? value : value.join('x'));
  // A case decides how many blocks go in.
  if (!inside) add('blocks', blocks(space.blocks), blocks(defaults.space.blocks));
  // A preset brings its own sizes and clearance, so both are said wherever one is named.
  const own = space.preset !== defaults.space.preset;
  const size = (value: Triple) => value.map(decimal).join('x');
  add('block-size', size(space.block_mm), own ? '' : size(defaults.space.block_mm));
  const clearance = (value: number | number[]) => [value].flat().map(decimal).join();
  add('clearance', clearance(cut.clearance_mm), own ? '' : clearance(defaults.cut.clearance_mm));
  add('liner', decimal(cut.liner_mm), '0');
  add('least-rib', decimal(fit.least_rib_mm), '0');
  if (fit.notches) {
    const {width_mm, depth_mm, room_mm, axis, first_mm, second_mm} = fit.notches;
    add('notches', [width_mm, depth_mm, room_mm].map(decimal).join('x'), '');
    add('notch-axis', axis ?? '', '');
    if (first_mm !== null && second_mm !== null) add('notch-at', [first_mm, second_mm].map(decimal).join(), '');
  }
  if (space.wall_mm !== null) add('wall', [space.wall_mm].flat().map(decimal).join(), '');
  if (inside) addCase(design.case, inside, add);
  const list = (value: Triple) => value.map(decimal).join(',');
  add('rotate', list(placement.rotation_deg), list(defaults.placement.rotation_deg));
  add('move', list(placement.offset_mm), list(defaults.placement.offset_mm));
  flag('cut-on-touch', cut.cut_on_touch);
  add('parting', String(parting.level), String(defaults.parting.level));
  if (workshop.for) addWorkshop(workshop, workshop.for, defaults.workshop, add);
  if (workshop.mass_kg !== null) add('mass', decimal(workshop.mass_kg), '');
  add('formats', output.formats.join(','), defaults.output.formats.join(','));
  return ['snug make', quoted(file), ...options, '-o', quoted(`${file.replace(/\.[^.]+$/, '')}-foam`)].join(' ');
}

/** The command for a file that was never opened here: in a space that fits it, as the page would have begun. */
export function firstMakeLine(file: string, defaults: Design, object = defaults.object): string {
  return makeLine(file, {...defaults, object, space: {...defaults.space, blocks: 'auto'}}, defaults);
}

type Add = (name: string, value: string, usual: string) => void;

function addCase(options: CaseOptions, [height, width, length]: Triple, add: Add) {
  const size = [length, width, height].map(decimal).join('x');
  const sizes = options.lid_mm === null ? size : `${size}:${decimal(options.lid_mm)}`;
  add('case', options.name ? quoted(options.name) : sizes, '');
  add('case-play', decimal(options.play_mm), '3');
  add('case-radius', decimal(options.corner_radius_mm), '0');
  const section = (value: [number, number] | null) => (value ? [value[1], value[0]].map(decimal).join('x') : '');
  add('case-base', section(options.base_mm), '');
  add('case-top', section(options.top_mm), '');
}

function addWorkshop(options: WorkshopOptions, work: Work, usual: WorkshopOptions, add: Add) {
  const {paper, price_per_litre: price} = options;
  add('for', work, '');
  add('paper', paper, usual.paper);
  if (price !== null) add('price', quoted(`${decimal(price)}${options.currency}`), '');
  if (work === 'sheets') addSheets(options.sheets, usual.sheets, add);
  if (work === 'print' || work === 'mould') addPrinter(options.print, usual.print, add);
  if (work === 'bricks') addBricks(options.bricks, usual.bricks, add);
  if (work === 'mill') addMill(options.mill, usual.mill, add);
  if (work === 'mould') addMould(options.mould, usual.mould, add);
}

function addSheets(sheets: WorkshopOptions['sheets'], usual: WorkshopOptions['sheets'], add: Add) {
  if (sheets.thickness_mm !== null) add('sheet', decimal(sheets.thickness_mm), '');
  add('stock', sheets.stock_mm.map(decimal).join('x'), usual.stock_mm.map(decimal).join('x'));
  add('kerf', decimal(sheets.kerf_mm), decimal(usual.kerf_mm));
  add('dowel', sheets.dowels > 0 ? decimal(sheets.dowel_mm) : '0', decimal(usual.dowel_mm));
}

function addPrinter(print: WorkshopOptions['print'], usual: WorkshopOptions['print'], add: Add) {
  add('bed', print.bed_mm.map(decimal).join('x'), usual.bed_mm.map(decimal).join('x'));
  add('dowel', print.dowels ? decimal(print.dowel_diameter_mm) : '0', decimal(usual.dowel_diameter_mm));
}

function addBricks(bricks: BrickOptions, usual: BrickOptions, add: Add) {
  add('brick-unit', bricks.unit, usual.unit);
  add('brick-sizes', bricks.family.join(), '');
  const colors = ({lower_color, lid_color}: BrickOptions) => quoted(`${lower_color},${lid_color}`);
  add('brick-colors', colors(bricks), colors(usual));
  add('brick-stock', Object.entries(bricks.stock).map(([size, pieces]) => `${size}=${pieces}`).join(), '');
  add('brick-rim', bricks.rim, usual.rim);
  add('brick-capacity', decimal(bricks.capacity_n), decimal(usual.capacity_n));
}

function addMill(mill: MillOptions, usual: MillOptions, add: Add) {
  add('cutter', decimal(mill.cutter_mm), decimal(usual.cutter_mm));
  add('flute', decimal(mill.flute_mm), decimal(usual.flute_mm));
  if (mill.step_down_mm !== null) add('step-down', decimal(mill.step_down_mm), '');
  add('stepover', decimal(mill.stepover), decimal(usual.stepover));
  add('feed', decimal(mill.feed_mm_min), decimal(usual.feed_mm_min));
  add('plunge', decimal(mill.plunge_mm_min), decimal(usual.plunge_mm_min));
  add('spindle', decimal(mill.spindle_rpm), decimal(usual.spindle_rpm));
  add('safe-height', decimal(mill.safe_mm), decimal(usual.safe_mm));
  add('pin', decimal(mill.pin_mm), decimal(usual.pin_mm));
  add('origin', mill.origin, usual.origin);
}

function addMould(mould: WorkshopOptions['mould'], usual: WorkshopOptions['mould'], add: Add) {
  add('mould-wall', decimal(mould.wall_mm), decimal(usual.wall_mm));
  add('mould-rim', decimal(mould.rim_mm), decimal(usual.rim_mm));
  add('draft', decimal(mould.draft_deg), decimal(usual.draft_deg));
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

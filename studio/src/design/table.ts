// Made from the table of options beside the library’s structs: `SNUG_WRITE=1 npx vitest run tests/design/table.test.ts`
// writes it.

/** Everything that a person chooses: the `design` of a project file. */
export interface Design {
  object: {
    /** The unit of the file. */
    units: 'mm' | 'cm' | 'm' | 'in' | null;
    /** Multiply every length by this. */
    scale: number;
    /** Scale the object's longest side to this (mm). */
    longest_mm: number | null;
    /** Close the holes of an open object before cutting. */
    cap: boolean;
    /** Point clouds: each point counts as a ball of this radius (mm). */
    point_radius_mm: number;
    clean: {
      /** Leave out separate parts, by their numbers in `snug inspect`. */
      drop_parts: number[];
      /** Leave out separate parts that are shorter than this (mm). */
      drop_below_mm: number;
      /** Cut off what lies behind a plane, such as a table: the direction to keep, and how far the plane lies along it (0,0,1,12 keeps what is above z = 12 mm). */
      cut_plane: [number, number, number, number] | null;
    };
  };
  space: {
    /** A foam that `snug presets` lists: block size and clearance. */
    preset: string;
    /** Blocks along x, y, z, or auto: the object plus walls. */
    blocks: [number, number, number] | 'auto';
    /** Size of a block in mm (mm). */
    block_mm: [number, number, number];
    /** Least foam between object and case: all sides, or X,Y,Z, or floor,roof,back,front,left,right; protect: as thick as --fragility asks (mm). */
    wall_mm: number | number[] | null;
    /** Least foam between two items that are of no common group (mm). */
    between_mm: number | null;
    /** A tray without a lid: items are sunk by this share of their height or, above 1, by so many mm. */
    open: number | null;
  };
  placement: {
    /** Degrees about the fixed axes x, then y, then z (degrees). */
    rotation_deg: [number, number, number];
    /** Shift from the centre of the space in mm (mm). */
    offset_mm: [number, number, number];
  };
  items: {
    /** Which of the project's objects it is, from 0. */
    object: number;
    /** What it is called on pages. */
    name: string;
    /** Items of one group may share a pocket. */
    group: string;
    /** Which layer it lies in; 1 is the lowest. */
    layer: number;
    /** Its own rotation (degrees). */
    rotation_deg: [number, number, number] | null;
    /** Its own shift from the middle of the space (mm). */
    offset_mm: [number, number, number] | null;
    /** Its own clearance (mm). */
    clearance_mm: number | number[] | null;
    /** Its own mass (kg). */
    mass_kg: number | null;
    /** Where its mass is centred, in the coordinates of its file (mm). */
    centre_mm: [number, number, number] | null;
    /** The greatest shock that it bears (G). */
    fragility_g: number | null;
    /** Places on it that foam keeps away from. */
    zones: {balls?: [number, number, number, number][]; part?: number; keep_off_mm?: number; press_kpa?: number; loose?: boolean}[];
    /** An arrangement leaves it where it is. */
    lock: boolean;
  }[];
  cut: {
    /** Grow the object by this on every side: one number, or X,Y,Z, or six: X,Y,Z for the lower foam, then for the upper; negative squeezes it, down to -0.4 of the smallest side of a block (mm). */
    clearance_mm: number | number[];
    /** Thickness of a cloth between object and foam, on top of the clearance (mm). */
    liner_mm: number;
    /** Also cut blocks that the object merely touches. */
    cut_on_touch: boolean;
  };
  fit: {
    /** Lower items until they lie on the foam below, not above a block's step. */
    settle: boolean;
    pads: {
      /** How thick the sheet is that pads are stacked from (mm). */
      sheet_mm: number;
      /** How far pads above an item press on it at most (mm). */
      squeeze_mm: number;
    } | null;
    relief: {
      /** How high the islands stand free that an item lies on (mm). */
      height_mm: number;
      /** How wide and long each island is at least (mm). */
      island_mm: number;
    } | null;
    /** Cut away foam between cavities that is thinner than this (mm). */
    least_rib_mm: number;
    notches: {
      /** How wide a recess is along the object's side (mm). */
      width_mm: number;
      /** How far it goes down below the parting level (mm). */
      depth_mm: number;
      /** How far it reaches outwards from the object (mm). */
      room_mm: number;
      /** The axis along which they lie opposite each other. */
      axis: 'y' | 'z' | null;
      /** The middle of the recess at -y or -z, from the middle of the space (mm). */
      first_mm: number | null;
      /** The middle of the opposite one (mm). */
      second_mm: number | null;
    } | null;
    lift: {
      /** How wide a recess is along the edge of a piece of foam (mm). */
      width_mm: number;
      /** How far it reaches from the edge inwards (mm). */
      depth_mm: number;
    } | null;
    /** Pressure that the foam bears for long (kPa). */
    creep_kpa: number | null;
  };
  parting: {
    /** Blocks below the parting where the object does not touch, for each layer (blocks). */
    level: number | number[] | 'auto';
  };
  /** Blocks that are taken out of a column by hand beside what is computed, or put back where N is negative: lower:12:7:1, upper:12:7:-2, middle-1:12:7:1:under. */
  edits: {piece: string; j: number; k: number; blocks: number; under?: boolean}[];
  output: {
    /** Formats of the foams: stl, ply. */
    formats: ('stl' | 'ply')[];
  };
  case: {
    /** Name of the case in `snug cases`, for people. */
    name: string;
    /** Height, width and length inside the case (mm). */
    inside_mm: [number, number, number] | null;
    /** Air between foam and case on each side (mm). */
    play_mm: number;
    /** How much of the height inside belongs to the lid (mm). */
    lid_mm: number | null;
    /** Radius of the case's upright edges (mm). */
    corner_radius_mm: number;
    /** Length and width inside at the floor, where the walls lean (mm). */
    base_mm: [number, number] | null;
    /** Length and width inside at the roof of the lid, where its walls lean (mm). */
    top_mm: [number, number] | null;
    /** cm3 for one kg of volumetric weight; none: a flat rate (cm3). */
    divisor: number | null;
    /** How the foam may be divided to fill a case. */
    division: 'none' | 'across' | 'all';
  };
  protection: {
    /** From which height the closed case falls on each of its sides (mm). */
    height_mm: number | null;
    /** The height as a rule has it for the packed mass. */
    rule: 'ista-1a' | 'ista-2a' | 'ista-3a' | 'd4169-2' | 'handling' | null;
    /** The greatest shock that the object bears (G). */
    fragility_g: number | null;
    /** How delicate it is, by the low end of a class. */
    fragility: 'museum' | 'extremely-fragile' | 'very-delicate' | 'delicate' | 'moderately-delicate' | 'moderately-rugged' | 'rugged' | null;
    /** Where the object's mass is centred, in the coordinates of its file in mm (mm). */
    centre_mm: [number, number, number] | null;
    /** Places that foam keeps away from, by so many mm: part=3:15, or X,Y,Z,R:15 for what lies within R mm of a point of the file; :press=2kPa tells what they bear, :loose that nothing may touch them. */
    zones: {balls?: [number, number, number, number][]; part?: number; keep_off_mm?: number; press_kpa?: number; loose?: boolean}[];
    foam: {
      /** A foam that `snug foams` lists: how it pushes back in a drop. */
      name: string;
      /** What it is, in one line. */
      title: string;
      /** Strain and the stress at it, straight lines between them (kPa). */
      curve: [number, number][];
      /** Its density (kg/m3). */
      density_kg_m3: number | null;
      /** Least and greatest thickness that the curve was measured at (mm). */
      thickness_mm: [number, number] | null;
      /** Pressure that it bears for long (kPa). */
      creep_kpa: number | null;
      /** How many drops on the same foam the curve is of. */
      impacts: number | null;
      /** Where the figures are from. */
      status: 'measured' | 'maker\'s sheet' | 'model' | 'unverified';
      /** Who published the figures. */
      source: string;
    } | null;
  };
  search: {
    /** What --optimize weighs: cut, gap, depth, bearing, flat, shock. */
    weights: Record<string, number>;
    /** Keep this axis of the object upward. */
    upright: 'x' | 'y' | 'z' | '-x' | '-y' | '-z' | null;
    /** What --fit-case makes small: the volume, or the weight that a carrier bills. */
    case: 'volume' | 'billed-weight';
    /** With --billed-weight: cm3 that are billed as a kilogram (cm3). */
    billed_divisor: number;
    /** Another search; the same seed finds the same. */
    seed: number;
    /** With --arrange or --objective shock: how items may be turned from how they are given. */
    turns: 'none' | 'upright' | 'quarter' | 'any';
    /** With --arrange: over how many layers the items are spread. */
    layers: number | 'auto';
  };
  workshop: {
    /** Also make what the workshop needs; takes the usual foam of that way of working unless --preset names one. */
    for: 'sponge' | 'sheets' | 'print' | 'bricks' | 'mill' | 'mould' | null;
    /** Paper of what is printed. */
    paper: 'a4' | 'letter' | 'a3';
    /** Price of a litre of the material. */
    price_per_litre: number | null;
    /** As it stands behind the price: EUR. */
    currency: string;
    /** Mass of the object, for the packing sheet (kg). */
    mass_kg: number | null;
    /** Density of the material (kg/m3). */
    density_kg_m3: number | null;
    sponge: {
      /** Sponge: maps at true size as tiles of the paper, each on one sheet for a plotter, or none. */
      maps: 'tiles' | 'plotter' | 'none';
    };
    sheets: {
      /** Sheets: their thickness (mm). */
      thickness_mm: number | null;
      /** Sheets: size of a sheet as it is sold (mm). */
      stock_mm: [number, number];
      /** Sheets: margin left uncut along the edges of the stock (mm). */
      margin_mm: number;
      /** Sheets: least distance between cuts of different pieces (mm). */
      spacing_mm: number;
      /** Sheets: width that a cut takes away (mm). */
      kerf_mm: number;
      /** Diameter of the dowels that hold sheets in place (mm). */
      dowel_mm: number;
      /** Sheets: how many dowels a half has; 0: none. */
      dowels: number;
      /** Sheets: least foam between a dowel hole and an edge (mm). */
      dowel_edge_mm: number;
      /** Sheets: so far from each cavity a blind slit that the edges of a liner are tucked into (mm). */
      liner_slit_mm: number;
      /** Sheets: so many times the same foam, cut from common stock. */
      copies: number;
      /** Sheets: the uppermost sheet in another colour than those below it, so that an empty place is seen. */
      second_color: boolean;
      /** Whether sheets are written as SVG. */
      svg: boolean;
      /** Whether sheets are written as DXF. */
      dxf: boolean;
    };
    print: {
      /** Print, mould: the printer's bed, and how high it prints (mm). */
      bed_mm: [number, number, number];
      /** Whether dowels hold the parts of a half that is larger than the bed. */
      dowels: boolean;
      /** Diameter of the dowels of prints and moulds (mm). */
      dowel_diameter_mm: number;
      /** Print, mould: length of the dowels, at least their diameter (mm). */
      dowel_length_mm: number;
      /** Print, mould: room left around a dowel on every side (mm). */
      joint_clearance_mm: number;
    };
    bricks: {
      /** Bricks: layers of bricks or of plates. */
      unit: 'auto' | 'brick' | 'plate';
      /** Bricks: the sizes to build with. */
      family: string[];
      /** Colour of the lower half's bricks. */
      lower_color: string;
      /** Colour of the lid's bricks. */
      lid_color: string;
      /** Bricks: how many pieces of each size there are (pieces). */
      stock: Record<string, number>;
      /** Bricks: whether the halves meet with studs or with tiles. */
      rim: 'studs' | 'tiles';
      /** Bricks: newtons that a contact point of a stud holds (newtons). */
      capacity_n: number;
    };
    mill: {
      /** Mill: the flat cutter's diameter (mm). */
      cutter_mm: number;
      /** Mill: how deep the cutter can go (mm). */
      flute_mm: number;
      /** Mill: the most that a pass goes down (mm). */
      step_down_mm: number | null;
      /** Mill: distance between paths, as a share of the cutter's diameter. */
      stepover: number;
      /** Mill: feed sideways (mm/min). */
      feed_mm_min: number;
      /** Mill: feed downwards (mm/min). */
      plunge_mm_min: number;
      /** Mill: the spindle's speed (rpm). */
      spindle_rpm: number;
      /** Mill: height of rapid moves above the stock (mm). */
      safe_mm: number;
      /** Mill: diameter of the registration pins; 0: none (mm). */
      pin_mm: number;
      /** Mill: where X0 Y0 lies on the stock. */
      origin: 'corner' | 'centre';
    };
    mould: {
      /** Mould: thickness of walls and floor (mm). */
      wall_mm: number;
      /** Mould: height of the walls above what is poured (mm). */
      rim_mm: number;
      /** Mould: lean of upright faces, so that the foam lets go (degrees). */
      draft_deg: number;
    };
  };
}

/** Every option by its path in a design. */
export type OptionPath =
  | 'items'
  | 'fit.pads'
  | 'fit.relief'
  | 'fit.notches'
  | 'fit.lift'
  | 'protection.foam'
  | 'object.units'
  | 'object.scale'
  | 'object.longest_mm'
  | 'object.cap'
  | 'object.point_radius_mm'
  | 'object.clean.drop_parts'
  | 'object.clean.drop_below_mm'
  | 'object.clean.cut_plane'
  | 'space.preset'
  | 'space.blocks'
  | 'space.block_mm'
  | 'space.wall_mm'
  | 'space.between_mm'
  | 'space.open'
  | 'placement.rotation_deg'
  | 'placement.offset_mm'
  | 'items.0.object'
  | 'items.0.name'
  | 'items.0.group'
  | 'items.0.layer'
  | 'items.0.rotation_deg'
  | 'items.0.offset_mm'
  | 'items.0.clearance_mm'
  | 'items.0.mass_kg'
  | 'items.0.centre_mm'
  | 'items.0.fragility_g'
  | 'items.0.zones'
  | 'items.0.lock'
  | 'cut.clearance_mm'
  | 'cut.liner_mm'
  | 'cut.cut_on_touch'
  | 'fit.settle'
  | 'fit.pads.sheet_mm'
  | 'fit.pads.squeeze_mm'
  | 'fit.relief.height_mm'
  | 'fit.relief.island_mm'
  | 'fit.least_rib_mm'
  | 'fit.notches.width_mm'
  | 'fit.notches.depth_mm'
  | 'fit.notches.room_mm'
  | 'fit.notches.axis'
  | 'fit.notches.first_mm'
  | 'fit.notches.second_mm'
  | 'fit.lift.width_mm'
  | 'fit.lift.depth_mm'
  | 'fit.creep_kpa'
  | 'parting.level'
  | 'edits'
  | 'output.formats'
  | 'case.name'
  | 'case.inside_mm'
  | 'case.play_mm'
  | 'case.lid_mm'
  | 'case.corner_radius_mm'
  | 'case.base_mm'
  | 'case.top_mm'
  | 'case.divisor'
  | 'case.division'
  | 'protection.height_mm'
  | 'protection.rule'
  | 'protection.fragility_g'
  | 'protection.fragility'
  | 'protection.centre_mm'
  | 'protection.zones'
  | 'protection.foam.name'
  | 'protection.foam.title'
  | 'protection.foam.curve'
  | 'protection.foam.density_kg_m3'
  | 'protection.foam.thickness_mm'
  | 'protection.foam.creep_kpa'
  | 'protection.foam.impacts'
  | 'protection.foam.status'
  | 'protection.foam.source'
  | 'search.weights'
  | 'search.upright'
  | 'search.case'
  | 'search.billed_divisor'
  | 'search.seed'
  | 'search.turns'
  | 'search.layers'
  | 'workshop.for'
  | 'workshop.paper'
  | 'workshop.price_per_litre'
  | 'workshop.currency'
  | 'workshop.mass_kg'
  | 'workshop.density_kg_m3'
  | 'workshop.sponge.maps'
  | 'workshop.sheets.thickness_mm'
  | 'workshop.sheets.stock_mm'
  | 'workshop.sheets.margin_mm'
  | 'workshop.sheets.spacing_mm'
  | 'workshop.sheets.kerf_mm'
  | 'workshop.sheets.dowel_mm'
  | 'workshop.sheets.dowels'
  | 'workshop.sheets.dowel_edge_mm'
  | 'workshop.sheets.liner_slit_mm'
  | 'workshop.sheets.copies'
  | 'workshop.sheets.second_color'
  | 'workshop.sheets.svg'
  | 'workshop.sheets.dxf'
  | 'workshop.print.bed_mm'
  | 'workshop.print.dowels'
  | 'workshop.print.dowel_diameter_mm'
  | 'workshop.print.dowel_length_mm'
  | 'workshop.print.joint_clearance_mm'
  | 'workshop.bricks.unit'
  | 'workshop.bricks.family'
  | 'workshop.bricks.lower_color'
  | 'workshop.bricks.lid_color'
  | 'workshop.bricks.stock'
  | 'workshop.bricks.rim'
  | 'workshop.bricks.capacity_n'
  | 'workshop.mill.cutter_mm'
  | 'workshop.mill.flute_mm'
  | 'workshop.mill.step_down_mm'
  | 'workshop.mill.stepover'
  | 'workshop.mill.feed_mm_min'
  | 'workshop.mill.plunge_mm_min'
  | 'workshop.mill.spindle_rpm'
  | 'workshop.mill.safe_mm'
  | 'workshop.mill.pin_mm'
  | 'workshop.mill.origin'
  | 'workshop.mould.wall_mm'
  | 'workshop.mould.rim_mm'
  | 'workshop.mould.draft_deg';

import type {Design, Preset} from './design';

// What a pack must protect from, and what is known of its foam.

type Protection = Design['protection'];

/** What is known of the foam; null: nothing. It brings what it bears for long and its density, as the blocks do that it
 *  takes the place of. */
export function withFoamData(design: Design, foam: Protection['foam'], preset: Preset | undefined): Design {
  const density = (foam ?? preset)?.density_kg_m3;
  return {
    ...design,
    protection: {...design.protection, foam},
    fit: {...design.fit, creep_kpa: (foam ?? preset)?.creep_kpa ?? null},
    workshop: {...design.workshop, density_kg_m3: density ?? (foam ? design.workshop.density_kg_m3 : null)},
  };
}

/** By a rule, or of so many mm; null: none is looked at. */
export function withDrop(design: Design, height: NonNullable<Protection['rule']> | number | null): Design {
  const [height_mm, rule] = typeof height === 'number' ? [height, null] : [null, height];
  return {...design, protection: {...design.protection, height_mm, rule}};
}

/** By a class, or so many G; null: shocks are told, not judged. */
export function withFragility(design: Design, bears: NonNullable<Protection['fragility']> | number | null): Design {
  const [fragility_g, fragility] = typeof bears === 'number' ? [bears, null] : [null, bears];
  return {...design, protection: {...design.protection, fragility_g, fragility}};
}

export type Lacking = 'foam' | 'curve' | 'mass' | 'height' | 'fragility' | 'fitted';

/** What drops cannot be estimated without. */
export function lackingForDrops({protection, items, workshop}: Design): Lacking[] {
  const lacking: Lacking[] = [];
  if (!protection.foam) lacking.push('foam');
  else if (protection.foam.curve.length === 0) lacking.push('curve');
  if (items.some(({mass_kg}) => (mass_kg ?? workshop.mass_kg) === null)) lacking.push('mass');
  if (protection.height_mm === null && protection.rule === null) lacking.push('height');
  return lacking;
}

/** What walls cannot be chosen without. */
export function lackingForWalls(design: Design): Lacking[] {
  const {protection, items, space} = design;
  const lacking = lackingForDrops(design);
  const asked = protection.fragility_g !== null || protection.fragility !== null;
  if (!asked && items.some(({fragility_g}) => fragility_g === null)) lacking.push('fragility');
  if (space.blocks !== 'auto' || design.case.inside_mm !== null) lacking.push('fitted');
  return lacking;
}

import type {FieldName} from '../design/panel_fields';
import {isOption} from '../design/panel_fields';
import {fieldName, type Schema} from '../design/options';
import type {Texts} from '../words/texts';

interface FieldWords {
  name: string;
  tip: string;
}

/** What a field is called on the page, and what is said of it. */
export function fieldWords(field: FieldName, text: Texts, rows: Schema): FieldWords {
  const own = ownWords(text)[field];
  if (own) return {name: own[0], tip: own[1] ?? ''};
  const given = text.fields[field];
  if (given) return {name: given.name, tip: given.tip};
  if (!isOption(field)) return {name: field, tip: ''};
  const place = text.code === 'ja' ? 1 : 0;
  return {name: fieldName(rows[field])[place], tip: rows[field].help?.[place] ?? ''};
}

/** Of those that are more than an option by itself. */
function ownWords({bricks, cases, check, drops, fieldsOf, fit, foam, items, make, object, pieces, placement, search, workshop, zones}: Texts): Partial<
  Record<FieldName, readonly [name: string, tip?: string]>
> {
  return {
    'object.units': [object.unit, object.unitTip],
    length: [object.length, object.lengthTip],
    parts: [object.parts, object.partsTip],
    zones: [zones.heading, zones.lead],
    'space.preset': [foam.preset, foam.presetTip],
    'space.wall_mm': [foam.wall, foam.wallTip],
    'case.inside_mm': [cases.fill, cases.fillTip],
    'cut.clearance_mm': [foam.clearance, foam.clearanceTip],
    'walls-apart': [cases.wallsApart, cases.wallsApartTip],
    'space.blocks': [foam.blocks, foam.fittedTip],
    'space.block_mm': [foam.blockSize, foam.blockSizeTip(Object.values(foam.axes).join(', '))],
    'space.open': [pieces.tray, pieces.trayTip],
    'fit.pads': [fit.pads, fit.padsTip],
    'fit.relief': [fit.relief, fit.reliefTip],
    'fit.notches': [fit.notches, fit.notchesTip],
    'fit.lift': [fit.lift, fit.liftTip],
    'parting.level': [pieces.parting, pieces.partingTip],
    sides: [placement.down],
    'fine-turn': [placement.fine, fieldsOf.fineTurn],
    'search.weights': [placement.objective, placement.objectiveTip],
    'search.upright': [placement.upright, placement.uprightTip],
    optimize: [placement.optimize, placement.optimizeTip],
    arrange: [items.arrange, items.arrangeTip],
    smallest: [placement.smallest, placement.smallestTip],
    map: [search.map, search.mapTip],
    quarters: [placement.quarter],
    'placement.offset_mm': [placement.offset],
    'protection.foam': [drops.foam, drops.foamTip],
    'protection.rule': [drops.height, drops.heightTip],
    'protection.fragility': [drops.fragility, drops.fragilityTip],
    'own-foams': [drops.own.heading],
    'protection.centre_mm': [drops.centre.label],
    walls: [check.walls],
    gaps: [check.gap, check.gapColours],
    'workshop.for': [workshop.how],
    'workshop.bricks.lower_color': [bricks.halves.lower_color, bricks.colorTip],
    'workshop.bricks.lid_color': [bricks.halves.lid_color, bricks.colorTip],
    'workshop.bricks.family': [bricks.sizes, bricks.sizesTip],
    'workshop.bricks.stock': [bricks.stock, bricks.stockTip],
    kind: [make.what],
    command: [make.command],
  };
}

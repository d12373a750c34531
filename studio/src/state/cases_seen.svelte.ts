import type {Design} from '../design/design';
import type {ObjectUse} from '../design/moment';
import type {CaseRanking, Engine, RankedCase} from '../engine/api';
import {isFailure} from '../engine/failure';

/** What is asked about cases. */
interface Pack {
  readonly engine: Engine;
  readonly defaults: Design;
  readonly moment: {readonly design: Design; readonly objects: readonly ObjectUse[]};
}

/** Known cases by their names: a design has no more of one. They come with the lists of those that hold something. */
class CasesSeen {
  #byName: ReadonlyMap<string, RankedCase> = $state.raw(new Map());
  readonly #asked = new Set<string>();

  learn({fitting, nearest}: CaseRanking): void {
    this.#byName = new Map([...this.#byName, ...[...fitting, ...(nearest ? [nearest] : [])].map((one) => [one.name, one] as const)]);
  }

  find(name: string): RankedCase | undefined {
    return this.#byName.get(name);
  }

  /** Looks for a case that holds what is there; once for each name, since a person may have it of their own. */
  async look(name: string, {engine, defaults, moment: {design, objects}}: Pack): Promise<void> {
    if (this.#byName.has(name) || this.#asked.has(name)) return;
    this.#asked.add(name);
    const ranking = await engine.rankCases(withoutFoam(design, defaults), objects);
    if (!isFailure(ranking)) this.learn(ranking);
  }
}

/** For the list of all cases that hold it, be the foam as thin as it may. */
export function withoutFoam(design: Design, defaults: Design): Design {
  return {...design, case: defaults.case, space: {...design.space, blocks: 'auto', wall_mm: 0, open: null}};
}

export const casesSeen = new CasesSeen();

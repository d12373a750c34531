import {errorIn, isShape} from '../design/shape';
import type {CaseRanking} from '../engine/api';
import {isFailure} from '../engine/failure';
import type {Proposal} from '../engine/plan';
import {language} from '../words/language.svelte';
import type {Pair} from '../words/words';
import {casesSeen, withoutFoam} from './cases_seen.svelte';
import {notedStage} from './last_stage';
import {level} from './level';
import {preferences} from './preferences.svelte';
import type {Studio} from './studio.svelte';
import {planned, planWishes, rememberedWishes, rememberWishes, type Wishes} from './wishes';

/** What stands in place of the steps: an object is made from measurements, a few questions, whole proposals. */
export type Stage = 'measure' | 'ask' | 'show';

/** Everything is open to whoever wants it so. */
const asksNothing = () => level === 'all' || preferences.showsAll;

/** The first level: a few questions, and proposals to choose from. */
export class FirstLevel {
  readonly #studio: Studio;
  stage: Stage | null = $state(null);
  wishes: Wishes = $state.raw(rememberedWishes());
  proposals: readonly Proposal[] | null = $state.raw(null);
  /** Why there are none. */
  failure: Pair | null = $state.raw(null);
  /** In which language the proposals speak. */
  spoken = $state('');
  /** Of work for a piece, by the way of working, where a person knows better. */
  seconds: Record<string, number> = $state({});

  /** Before the page was loaded anew, its object was being made from measurements. */
  measuredBefore = false;

  constructor(studio: Studio) {
    this.#studio = studio;
    const last = notedStage();
    if (!last || asksNothing()) return;
    this.wishes = last.wishes;
    this.measuredBefore = last.stage === 'measure';
    // Proposals are asked for again.
    this.stage = last.stage && 'ask';
  }

  /** Something was opened that nobody has chosen anything for. */
  begin(): void {
    this.proposals = null;
    this.wishes = rememberedWishes();
    this.stage = asksNothing() ? null : 'ask';
  }

  ask = (): void => {
    this.stage = 'ask';
  };

  skip = (): void => {
    this.stage = null;
  };

  wish(to: Partial<Wishes>): void {
    this.wishes = {...this.wishes, ...to};
    rememberWishes(this.wishes);
  }

  async show(): Promise<void> {
    const {engine, defaults, presets, moment} = this.#studio;
    this.stage = 'show';
    this.proposals = null;
    this.failure = null;
    const spoken = language.code;
    const design = planned(moment.design, this.wishes, defaults, presets, await this.#error());
    const answer = await this.#studio.long('plan', (onProgress) =>
      engine.plan(design, planWishes(this.wishes), spoken, onProgress, moment.objects),
    );
    if (!isFailure(answer)) {
      [this.proposals, this.spoken] = [answer, spoken];
      void this.holding();
    } else if (answer.kind !== 'cancelled') this.failure = answer.error;
    else if (this.stage === 'show') this.stage = 'ask';
  }

  /** The known cases that hold what is there, be the foam as thin as it may. */
  async holding(): Promise<CaseRanking | null> {
    const {engine, defaults, presets, moment} = this.#studio;
    const bare = planned(moment.design, {...this.wishes, cases: 'none'}, defaults, presets);
    const answer = await engine.rankCases(withoutFoam(bare, defaults), moment.objects);
    if (isFailure(answer)) return null;
    casesSeen.learn(answer);
    return answer;
  }

  /** How far what was measured may be off; 0 for a scan. */
  async #error(): Promise<number> {
    const measured = this.#studio.files.filter(({name}) => isShape(name));
    return Math.max(0, ...(await Promise.all(measured.map(async ({content}) => errorIn(await content.text())))));
  }

  take({design}: Proposal): void {
    this.#studio.becomes({...this.#studio.moment, design}, '');
    this.stage = null;
  }
}

import type {Design, Triple} from '../design/design';
import type {Failure} from './api';
import {isFailure} from './failure';

// Whole proposals, as the library makes them of a few answers.

/** Who carries it, and what may be used: the words of `snug plan`. */
export interface PlanWishes {
  carrier: 'store' | 'hand' | 'courier' | 'parcel';
  /** Of working; empty: what is usual. */
  ways: string[];
  cases: 'cartons' | 'hard-cases' | 'none';
  /** The design's blocks are the foam that is there. */
  own_blocks: boolean;
}

/** A whole design, and what is told of it (snug/plan.h). */
export interface Proposal {
  kind: 'smallest' | 'most-margin' | 'cheapest';
  for: string;
  preset: string | null;
  foam: string | null;
  case: string | null;
  /** Height, width, length. */
  size_mm: Triple;
  litres: number;
  gross_kg: number | null;
  billed_kg: number;
  cost: number | null;
  currency: string | null;
  worst_g: number | null;
  asked_g: number | null;
  /** Why there is no worst_g where drops are looked at. */
  why_none: string | null;
  meets: 'yes' | 'no' | 'unknown';
  pieces: number;
  seconds_each: number;
  work_hours: number;
  /** By side. */
  wall_mm: number[];
  findings: {code: string; severity: 'danger' | 'warning' | 'note'; message: string}[];
  design: Design;
  /** An SVG. */
  preview: string;
}

/** As the library gives them. */
export interface ProposalTexts {
  plan: string;
  designs: string[];
  previews: string[];
}

export function readProposals(answer: ProposalTexts | Failure): Proposal[] | Failure {
  if (isFailure(answer)) return answer;
  const told = JSON.parse(answer.plan) as Omit<Proposal, 'design' | 'preview'>[];
  return told.map((each, i) => ({
    ...each,
    design: JSON.parse(answer.designs[i]!) as Design,
    preview: answer.previews[i]!,
  }));
}

import type {Design} from '../design/design';
import type {Arranged, ArrangedText, Arrangement, ArrangeStep, Failure, OnProgress} from './api';
import {isFailure} from './failure';
import type {ArrangementText} from './module';

// Who hears of long work of the library while it goes on, and what it ends with.

// Often enough for a progress bar.
const PROGRESS_EVERY_MS = 50;

export function throttled(onProgress?: OnProgress): ((fraction: number) => boolean) | null {
  if (!onProgress) return null;
  let told = performance.now();
  return (fraction) => {
    const now = performance.now();
    if (now - told >= PROGRESS_EVERY_MS) {
      told = now;
      onProgress(fraction);
    }
    return true;
  };
}

export function listeners(onStep: (step: ArrangeStep) => void) {
  let fraction = 0;
  const progress = throttled((share) => onStep({fraction: (fraction = share), better: null}));
  return {progress, better: (design: string) => onStep({fraction, better: JSON.parse(design) as Design})};
}

export function designOf(found: {design: string} | Failure): {design: Design} | Failure {
  return isFailure(found) ? found : {design: JSON.parse(found.design) as Design};
}

export function arranged(answer: ArrangementText | Failure): Arrangement | Failure {
  if (isFailure(answer)) return answer;
  const read = (choice: ArrangedText): Arranged => ({...choice, design: JSON.parse(choice.design) as Design});
  const choices = answer.choices.map(read);
  return {design: choices[0]!.design, choices};
}

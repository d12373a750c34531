import type {Ink} from './draw';

/** The colours of the page's theme. */
export function ink(): Ink {
  const style = getComputedStyle(document.documentElement);
  const colour = (name: string) => style.getPropertyValue(name).trim();
  return {
    paper: colour('--paper'),
    text: colour('--text'),
    line: colour('--grid'),
    cut: colour('--cut'),
    lower: colour('--lower'),
    middle: colour('--middle'),
    upper: colour('--upper'),
    object: colour('--outline'),
    mark: colour('--mark'),
    back: colour('--text-soft'),
    selected: colour('--accent'),
    near: colour('--danger'),
  };
}

/** For paper, whatever the screen looks like. */
export const PRINT_INK: Ink = {
  paper: '#ffffff',
  text: '#111820',
  line: '#8a94a3',
  cut: '#ffffff',
  lower: '#3f7fc4',
  middle: '#4c9a6b',
  upper: '#e58a2b',
  object: '#101418',
  mark: '#d6336c',
  back: '#111820',
  selected: '#1f66c1',
  near: '#cf2f2f',
};

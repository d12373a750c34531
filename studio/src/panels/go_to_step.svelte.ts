import {tick} from 'svelte';
import type {Step} from '../design/panel_fields';
import {preferences} from '../state/preferences.svelte';
import type {Place} from './find_fields';

class Steps {
  /** The step that is on the page, or that is read where all are. */
  current: Step = $state('object');
}
export const steps = new Steps();

/** Shows a step, or a part of it by its id: in its panel, which scrolls by itself on wide pages and with the window on narrow ones. */
export async function goToStep(step: Step, event?: Event, part?: string): Promise<void> {
  event?.preventDefault();
  steps.current = step;
  await tick();
  const section = document.getElementById(`step-${step}`);
  const place = (part && document.getElementById(part)) || section;
  if (!section || !place) return;
  scrollTo(section, place);
  section.focus({preventScroll: true});
}

function scrollTo(section: HTMLElement, place: HTMLElement) {
  const panel = section.parentElement!;
  if (panel.scrollHeight > panel.clientHeight) panel.scrollTop += place.getBoundingClientRect().top - panel.getBoundingClientRect().top;
  // Alone, a step begins with the way to the others.
  else (place === section && !preferences.showsAll ? panel.closest('[data-column]')! : place).scrollIntoView();
}

const FOCUSABLE = ':is(input, select, textarea, button, summary):not(:disabled, .reset)';

/** Shows a field and puts the keyboard there; where it is not there, what it comes with. Whether it is there. */
export async function goToField({field, within, panel, step, ways}: Place): Promise<boolean> {
  const find = (name: string) => document.querySelector<HTMLElement>(`[data-field="${name}"]`);
  steps.current = step;
  await tick();
  // A field that is in force is there already; More stays as it is where it has none of it.
  const opens = !find(field) && !preferences.opens(panel);
  if (opens) preferences.openMore(panel, true);
  await tick();
  if (opens && !find(field) && !find(within)) preferences.openMore(panel, false);
  const place = find(field) ?? find(within) ?? (ways && find('workshop.for'));
  const section = document.getElementById(`step-${step}`);
  if (!section) return false;
  for (let at = place; at && at !== section; at = at.parentElement) if (at instanceof HTMLDetailsElement) at.open = true;
  for (const closed of place?.querySelectorAll('details') ?? []) closed.open = true;
  await tick();
  scrollTo(section, place ?? section);
  const [first] = place?.querySelectorAll<HTMLElement>(FOCUSABLE) ?? [];
  (first ?? section).focus({preventScroll: true});
  // What is typed next takes the place of what is there.
  if (first instanceof HTMLInputElement && /^(number|text)$/.test(first.type)) first.select();
  return find(field) !== null;
}

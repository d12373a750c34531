import {tick} from 'svelte';
import type {Step} from '../design/panel_fields';

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
  else place.scrollIntoView();
}

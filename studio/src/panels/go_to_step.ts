export const STEPS = ['object', 'foam', 'placement', 'check', 'make'] as const;
export type Step = (typeof STEPS)[number];

/** Shows a step, or a part of it by its id: in its panel, which scrolls by itself on wide pages and with the window on narrow ones. */
export function goToStep(step: Step, event?: Event, part?: string) {
  event?.preventDefault();
  const section = document.getElementById(`step-${step}`);
  const panel = section?.parentElement;
  const place = (part && document.getElementById(part)) || section;
  if (!section || !place || !panel) return;
  if (panel.scrollHeight > panel.clientHeight) panel.scrollTop += place.getBoundingClientRect().top - panel.getBoundingClientRect().top;
  else place.scrollIntoView();
  section.focus({preventScroll: true});
}

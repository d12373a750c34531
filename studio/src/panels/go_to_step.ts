export const STEPS = ['object', 'foam', 'placement', 'check', 'make'] as const;
export type Step = (typeof STEPS)[number];

/** Shows a step: in its panel, which scrolls by itself on wide pages and with the window on narrow ones. */
export function goToStep(step: Step, event?: Event) {
  event?.preventDefault();
  const section = document.getElementById(`step-${step}`);
  const panel = section?.parentElement;
  if (!section || !panel) return;
  if (panel.scrollHeight > panel.clientHeight) panel.scrollTop += section.getBoundingClientRect().top - panel.getBoundingClientRect().top;
  else section.scrollIntoView();
  section.focus({preventScroll: true});
}

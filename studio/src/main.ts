import {mount} from 'svelte';
import App from './app/App.svelte';
import './app/app.css';
import {createEngine} from './engine/engine';
import {language} from './i18n/language.svelte';
import {openServed} from './state/open_served';
import {Studio} from './state/studio.svelte';
import {Works} from './state/works.svelte';

const page = document.getElementById('app') as HTMLElement;

async function start() {
  const starting = document.createElement('p');
  starting.textContent = language.text.busy.start;
  page.replaceChildren(starting);
  let studio: Studio | null = null;
  const engine = await createEngine({onRestart: (reason) => studio?.restarted(reason)});
  studio = await Studio.start(engine);
  page.replaceChildren();
  // The page first: what comes back to it may be large.
  mount(App, {target: page, props: {studio}});
  await bringBack(studio);
}

async function bringBack(studio: Studio) {
  const works = openWorks(studio);
  if (await openServed(studio, language.text.files)) {
    const kept = await works;
    if (kept) await studio.keepIn(kept);
    return;
  }
  const kept = await works;
  if (kept) await studio.restore(kept);
}

/** Private windows may have no database; then nothing is kept, and all else works. */
function openWorks(studio: Studio): Promise<Works | null> {
  return Works.open({onBlocked: () => (studio.notice = language.text.works.blocked)}).catch(() => null);
}

start().catch((reason: unknown) => {
  const sentence = document.createElement('p');
  sentence.setAttribute('role', 'alert');
  sentence.textContent = `${language.text.broken}: ${reason instanceof Error ? reason.message : String(reason)}`;
  page.replaceChildren(sentence);
});

// From any static host: what was loaded once works without a network.
if (import.meta.env.PROD && 'serviceWorker' in navigator) void navigator.serviceWorker.register('./service_worker.js');

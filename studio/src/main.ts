import {mount} from 'svelte';
import App from './app/App.svelte';
import './app/app.css';
import {createEngine} from './engine/engine';
import {language} from './i18n/language.svelte';
import {openAutosave} from './state/autosave';
import {openServed} from './state/open_served';
import {Studio} from './state/studio.svelte';

const page = document.getElementById('app') as HTMLElement;

async function start() {
  let studio: Studio | null = null;
  const engine = await createEngine({onRestart: (reason) => studio?.restarted(reason)});
  // Private windows may have no database; then nothing is kept, and all else works.
  const autosave = await openAutosave().catch(() => null);
  studio = await Studio.start(engine, autosave);
  if (!(await openServed(studio, language.text.files))) await studio.restore();
  mount(App, {target: page, props: {studio}});
}

start().catch((reason: unknown) => {
  const sentence = document.createElement('p');
  sentence.setAttribute('role', 'alert');
  sentence.textContent = `${language.text.broken}: ${reason instanceof Error ? reason.message : String(reason)}`;
  page.replaceChildren(sentence);
});

// From any static host: what was loaded once works without a network.
if (import.meta.env.PROD && 'serviceWorker' in navigator) void navigator.serviceWorker.register('./service_worker.js');

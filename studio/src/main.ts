import {mount} from 'svelte';
import {createEngine} from './engine/engine';
import {coreIn} from './engine/worker_link';
import {openServed} from './import/open_served';
import App from './panels/App.svelte';
import './panels/app.css';
import {startWorker} from './start_worker';
import {Studio} from './state/studio.svelte';
import {Works} from './state/works.svelte';
import {typing} from './ui/typing.svelte';
import {files} from './words/files';
import {language} from './words/language.svelte';
import type {Pair} from './words/words';

const page = document.getElementById('app') as HTMLElement;

async function start() {
  const starting = document.createElement('p');
  starting.textContent = language.text.busy.start;
  page.replaceChildren(starting);
  let studio: Studio | null = null;
  const startCore = () => coreIn(startWorker());
  const engine = await createEngine({startCore, onRestart: (reason) => studio?.restarted(reason)});
  studio = await Studio.start(engine, () => typing.designChanged());
  typing.onrefusal = refusing(studio);
  page.replaceChildren();
  // The page first: what comes back to it may be large.
  mount(App, {target: page, props: {studio}});
  await bringBack(studio);
}

/** Says why a field does not take a number, until it takes one. */
function refusing(studio: Studio) {
  return (why: Pair | null) => {
    if (why) studio.refuse('number', why);
    else if (studio.problem?.control === 'number') studio.problem = null;
  };
}

async function bringBack(studio: Studio) {
  const works = openWorks(studio);
  const served = await openServed(studio);
  const kept = await works;
  if (!kept) studio.notice ??= files.works.notKept;
  else if (served) await studio.keepIn(kept);
  else await studio.restore(kept);
}

/** Private windows may have no database; then nothing is kept, and all else works. */
function openWorks(studio: Studio): Promise<Works | null> {
  return Works.open({onBlocked: () => (studio.notice = files.works.blocked)}).catch(() => null);
}

start().catch((reason: unknown) => {
  const sentence = document.createElement('p');
  sentence.setAttribute('role', 'alert');
  sentence.textContent = `${language.text.broken}: ${reason instanceof Error ? reason.message : String(reason)}`;
  page.replaceChildren(sentence);
});

// From any static host: what was loaded once works without a network. The one file has all with it.
if (import.meta.env.PROD && import.meta.env.MODE !== 'one-file' && 'serviceWorker' in navigator) void navigator.serviceWorker.register('./service_worker.js');

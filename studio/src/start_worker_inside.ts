import Inside from './worker?worker&inline';

/** A worker from the page's own text. */
export function startWorker(): Worker {
  return new Inside();
}

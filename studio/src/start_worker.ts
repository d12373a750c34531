/** A worker from its file beside the page. In the one file, start_worker_inside.ts stands for this. */
export function startWorker(): Worker {
  return new Worker(new URL('./worker.ts', import.meta.url), {type: 'module'});
}

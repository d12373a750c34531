/** `run`, one call at a time: while one runs only the newest waiting call survives; the others get dropped(). */
export function latest<A extends unknown[], R>(
  run: (...args: A) => Promise<R>,
  dropped: () => R,
): (...args: A) => Promise<R> {
  type Call = {args: A; resolve: (value: R) => void; reject: (reason: unknown) => void};
  let running = false;
  let waiting: Call | null = null;

  async function work() {
    running = true;
    while (waiting) {
      const call: Call = waiting;
      waiting = null;
      const settle = await run(...call.args).then(
        (value) => () => call.resolve(value),
        (reason: unknown) => () => call.reject(reason),
      );
      // Before the caller hears of it: its next request shall find the place free.
      running = waiting !== null;
      settle();
      if (!running) return;
    }
  }

  return (...args) =>
    new Promise((resolve, reject) => {
      waiting?.resolve(dropped());
      waiting = {args, resolve, reject};
      if (!running) void work();
    });
}

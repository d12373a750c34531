const REST_MS = 900;

/** What happens by itself when nobody changes anything. */
export class Rest {
  /** It comes, or is under way. */
  comes = $state(false);
  #timer: ReturnType<typeof setTimeout> | undefined;

  begin(run: () => Promise<void>): void {
    this.stop();
    this.comes = true;
    const timer = setTimeout(async () => {
      await run();
      if (this.#timer === timer) this.comes = false;
    }, REST_MS);
    this.#timer = timer;
  }

  stop(): void {
    clearTimeout(this.#timer);
    this.#timer = undefined;
    this.comes = false;
  }
}

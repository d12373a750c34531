const REST_MS = 900;
/** Above this a gap report takes long enough that it is made only when asked for. */
const BY_ITSELF = 200_000;

/** What happens by itself when nobody changes anything. */
export class Rest {
  /** It comes, or is under way. */
  comes = $state(false);
  #timer: ReturnType<typeof setTimeout> | undefined;

  begin(objects: readonly {triangles: number}[], run: () => Promise<void>): void {
    this.stop();
    const triangles = objects.reduce((sum, object) => sum + object.triangles, 0);
    if (objects.length === 0 || triangles > BY_ITSELF) return;
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

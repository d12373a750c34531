/** What was saved last, so that nobody does it again to be sure; until something is changed. */
class SavedFiles {
  names: readonly string[] = $state.raw([]);

  clear(): void {
    this.names = [];
  }
}

export const savedFiles = new SavedFiles();

import type {BesideFile} from '../engine/api';
import type {FileTools} from '../engine/file_tools';
import type {SceneTools} from '../engine/module';

// What the library asks for while it reads a scene (glTF, 3MF) or a zip: decoders, and files that were opened with it.
// It asks in the middle of its own work, where nothing can be waited for. So what is not at hand is noted and refused,
// fetched when the library has given up, and the file is read again: nothing is loaded that no file asks for.

type Decoders = Required<Omit<SceneTools, 'beside'>>;

const LOADERS: {[Name in keyof Decoders]: () => Promise<Decoders[Name]>} = {
  inflate: async () => (await import('./inflate')).inflate,
  meshopt: async () => (await import('./meshopt')).meshoptDecoder(),
  draco: async () => (await import('./draco')).dracoDecoder(),
};

/** The tools for one file and those that came with it. */
export class SceneToolbox implements FileTools {
  readonly tools: SceneTools = {
    beside: (name) => this.#file(name),
    inflate: (...asked) => this.#decoder('inflate')?.(...asked) ?? null,
    meshopt: (...asked) => this.#decoder('meshopt')?.(...asked) ?? null,
    draco: (...asked) => this.#decoder('draco')?.(...asked) ?? null,
  };
  readonly #beside: readonly BesideFile[];
  readonly #decoders: Partial<Decoders> = {};
  readonly #contents = new Map<BesideFile, Uint8Array>();
  #missing: (() => Promise<void>) | null = null;

  constructor(beside: readonly BesideFile[]) {
    this.#beside = beside;
  }

  get used(): string[] {
    return [...this.#contents.keys()].map(({name}) => name);
  }

  async fetchMissing(): Promise<boolean> {
    const missing = this.#missing;
    this.#missing = null;
    await missing?.();
    return missing !== null;
  }

  #decoder<Name extends keyof Decoders>(name: Name): Partial<Decoders>[Name] {
    if (!this.#decoders[name])
      this.#missing ??= async () => {
        this.#decoders[name] = await LOADERS[name]();
      };
    return this.#decoders[name];
  }

  #file(name: string): Uint8Array | null {
    const file = this.#beside.find((one) => one.name.normalize() === name.normalize());
    if (!file) return null;
    const content = this.#contents.get(file);
    if (!content)
      this.#missing ??= async () => {
        this.#contents.set(file, new Uint8Array(await file.content.arrayBuffer()));
      };
    return content ?? null;
  }
}

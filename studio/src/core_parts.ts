import type {CoreParts} from './engine/core';
import {SceneToolbox} from './import/scene_tools';

/** The studio's readers and writers, for the library's core. */
export const CORE_PARTS: CoreParts = {
  toolsFor: (beside) => new SceneToolbox(beside),
  // A large part of the page that only makers need.
  packFiles: async (pack) => (await import('./export/pack')).packFiles(pack),
};

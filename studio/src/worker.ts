import createSnug from 'snug-wasm/snug.mjs';
import wasmUrl from 'snug-wasm/snug.wasm?url';
import {CORE_PARTS} from './core_parts';
import {bytesIn} from './engine/bytes_in';
import {EngineCore} from './engine/core';
import {serve} from './engine/worker_link';

serve(createSnug({locateFile: () => wasmUrl, ...bytesIn(wasmUrl)}).then((snug) => new EngineCore(snug, CORE_PARTS)));

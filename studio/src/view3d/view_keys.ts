import type {Stage} from './stage';

const TURN = Math.PI / 24;
/** Of the picture's height. */
const STEP = 0.05;
const ZOOM = 1.15;

const MOVES: Record<string, (stage: Stage) => void> = {
  ArrowLeft: (stage) => stage.orbit(-TURN, 0),
  ArrowRight: (stage) => stage.orbit(TURN, 0),
  ArrowUp: (stage) => stage.orbit(0, -TURN),
  ArrowDown: (stage) => stage.orbit(0, TURN),
  'Shift ArrowLeft': (stage) => stage.truck(-STEP, 0),
  'Shift ArrowRight': (stage) => stage.truck(STEP, 0),
  'Shift ArrowUp': (stage) => stage.truck(0, STEP),
  'Shift ArrowDown': (stage) => stage.truck(0, -STEP),
  '+': (stage) => stage.zoom(1 / ZOOM),
  '=': (stage) => stage.zoom(1 / ZOOM),
  '-': (stage) => stage.zoom(ZOOM),
  Home: (stage) => stage.view('corner'),
  f: (stage) => stage.showAll(),
};

/** What a key does in the view. */
export function moveOf({key, ctrlKey, metaKey, altKey, shiftKey}: KeyboardEvent): ((stage: Stage) => void) | undefined {
  if (ctrlKey || metaKey || altKey) return undefined;
  const name = key.length === 1 ? key.toLowerCase() : key;
  return MOVES[shiftKey && name.startsWith('Arrow') ? `Shift ${name}` : name];
}

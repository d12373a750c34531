import {words} from './words';

// Several things in one case.

export const items = words({
  items: {
    label: ['In the case', 'ケースに入れるもの'],
    add: ['Add objects', '対象物を追加'],
    addTip: [
      'Put more things into the same case: choose their files, or drop them onto the page. “Open” replaces what is there.',
      '同じケースに入れるものを追加します。ファイルを選ぶか、ページにドロップしてください。「開く」は今あるものと入れ替えます。',
    ],
    drop: ['Drop to add to the case', 'ドロップしてケースに追加'],
    tooNear: ['too near another item', 'ほかのものに近すぎます'],
    lock: (name: string) => [`Lock ${name}: no hand moves it`, `${name} を固定（手で動かない）`],
    unlock: (name: string) => [`Unlock ${name}`, `${name} の固定を解除`],
    duplicate: ['Duplicate', '複製'],
    duplicateNamed: (name: string) => [`Duplicate ${name}`, `${name} を複製`],
    remove: (name: string) => [`Take ${name} out`, `${name} を取り出す`],
    fields: (name: string) => [`Of ${name}`, `${name} について`],
    asForAll: ['Clearance as for all', 'すきまを全体と同じに'],
    placing: (name: string) => [`Turns and shifts ${name}.`, `${name} を回して動かします。`],
    locked: (name: string) => [`${name} is locked.`, `${name} は固定されています。`],
    oneOnly: [
      'Searches look at one thing alone: take the others out, or place them by hand here, in the view or in the plan.',
      '探索は一つのものだけが対象です。ほかのものを取り出すか、ここ、立体の表示、平面図で手で置いてください。',
    ],
    closedOnly: [
      'Searches look for foams that close: place what lies in a tray by hand, here or in the view.',
      '探索は閉じるフォームが対象です。トレイのものは、ここか立体の表示で手で置いてください。',
    ],
    plan: ['Drag an item in the plan to move it.', '平面図でものをドラッグすると動かせます。'],
  },
});

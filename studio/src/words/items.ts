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
    placing: (name: string) => [`Turns and shifts ${name}.`, `${name} を回して動かします。`],
    locked: (name: string) => [`${name} is locked.`, `${name} は固定されています。`],
    arrange: ['Arrange', '並べる'],
    arrangeTip: [
      'Put everything that is not locked where it takes the least room: in the case or the blocks that are chosen, or in as few as go. Cancel keeps the best so far.',
      '固定されていないものを、場所をいちばん取らないように並べます。ケースやブロック数を選んであればその中に、なければできるだけ小さく並べます。中止すると、それまでの最良が残ります。',
    ],
    choices: ['Arrangements to choose from', '並べ方の候補'],
    choice: (n: number, litres: string, size: string, layers: number) => [
      `Arrangement ${n}: ${litres}, ${size}, ${layers === 1 ? '1 layer' : `${layers} layers`}`,
      `並べ方 ${n}：${litres}、${size}、${layers} 段`,
    ],
    leastLitres: (litres: string) => [`No arrangement needs less than ${litres}.`, `どう並べても ${litres} は必要です。`],
    layers: (layers: number) => [layers === 1 ? '1 layer' : `${layers} layers`, `${layers} 段`],
    fill: (name: string) => [`As many of ${name} as fit`, `${name} を入るだけ`],
    fillTip: [
      'Adds copies until no more go into the case or the blocks that are chosen, and arranges everything that is not locked.',
      '選んだケースやブロックに入らなくなるまで複製し、固定されていないものを並べます。',
    ],
    fillNeeds: ['Choose a case or the number of blocks first: then there is something to fill.', '先にケースかブロック数を選んでください。'],
    closedOnly: [
      'Searches look for foams that close: place what lies in a tray by hand, here or in the view.',
      '探索は閉じる緩衝材が対象です。トレイのものは、ここか立体の表示で手で置いてください。',
    ],
    plan: ['Drag an item in the plan to move it.', '平面図でものをドラッグすると動かせます。'],
  },
});

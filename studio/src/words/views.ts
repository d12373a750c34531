import {words} from './words';

// The views in three dimensions and in two.

export const views = words({
  view3d: {
    label: [
      '3D view of the object in its foams. Drag to orbit; arrow keys orbit, with Shift they shift the view, plus and minus zoom, F or a double click shows all, the right button or a long press opens a menu.',
      '緩衝材に収まった対象物の3D表示。ドラッグか矢印キーで回転、Shiftと矢印キーで移動、プラスとマイナスで拡大・縮小、Fかダブルクリックで全体を表示、右ボタンか長押しでメニュー。',
    ],
    opening: ['Open foams', '緩衝材を開く'],
    openingTip: [
      'Moves the pieces of foam away from each other, as things go in and out',
      '緩衝材を互いに離します（出し入れの動き）',
    ],
    openingValue: ['Opening in percent', '開き（パーセント）'],
    openedLike: ['How they open', '開き方'],
    opened: {above: ['Lid above', 'ふたを上に'], book: ['Like a book', '本のように開く']},
    openedTips: {
      above: ['Opened, the pieces of foam stand above each other', '開いたとき、緩衝材を上下に並べます'],
      book: [
        'Opened, the pieces of foam lie side by side, the lid turned over',
        '開いたとき、緩衝材を横に並べ、ふたは裏返します',
      ],
    },
    play: ['Open or close, animated', '開閉のアニメーション'],
    views: ['View from', '視点'],
    viewFrom: (name: string) => [`View from: ${name}`, `視点：${name}`],
    names: {
      corner: ['Corner', '斜め'],
      front: ['Front', '前'],
      back: ['Back', '後ろ'],
      left: ['Left', '左'],
      right: ['Right', '右'],
      top: ['Top', '上'],
      bottom: ['Below', '下'],
    },
    all: ['Show all', '全体を表示'],
    allTip: ['Show all: F in the view, or a double click on it', '全体を表示：表示の中で F、またはダブルクリック'],
    parts: {
      object: ['Object', '対象物'],
      lower: ['Lower foam', '下の緩衝材'],
      middle: ['Middle foam', '中間の緩衝材'],
      upper: ['Lid', 'ふた'],
      space: ['Space', '空間'],
    },
    looks: {shown: ['shown', '表示'], glass: ['see-through', '半透明'], hidden: ['hidden', '非表示']},
    look: (part: string, look: string) => [`${part}: ${look}`, `${part}：${look}`],
    seen: ['Shown', '表示するもの'],
    more: ['What the view can do', '表示のメニュー'],
    lookTip: ['Shown, see-through, hidden: click for the next', '表示・半透明・非表示をクリックで切り替え'],
    handles: ['Handles', 'ハンドル'],
    handleKinds: {none: ['Look', '見る'], turn: ['Turn', '回す'], shift: ['Shift', '動かす']},
    handleTips: {
      none: ['Dragging orbits the view', 'ドラッグで視点を回します'],
      turn: ['Rings to turn the object in the view', '輪をつかんで対象物を回します'],
      shift: ['Arrows to shift the object in the view', '矢印をつかんで対象物を動かします'],
    },
    section: {
      name: ['Section', '断面で切る'],
      start: ['Cut open by a plane', '平面で切って見る'],
      axis: ['Cut', '切る向き'],
      axes: {x: ['from above', '上から'], y: ['from the front', '前から'], z: ['from the side', '横から']},
      axisTip: ['Which way the plane lies that takes away what is before it', '手前を取り除く平面の向き'],
      share: ['Cut at', '切る位置'],
      shareValue: ['Cut at, in percent', '切る位置（パーセント）'],
      shareTip: ['Also by the knob at the corner of the plane', '平面の角のつまみでも動かせます'],
      flip: ['Take away the other side', '反対側を取り除く'],
      end: ['End the cut', '断面を終わる'],
    },
    tape: {
      start: ['Measure', '長さを測る'],
      end: ['End measuring', '測るのを終わる'],
      help: {
        first: ['Click where to measure from; Enter: at the middle. Escape ends.', '測り始める所をクリック（Enter：中央の点）。Escで終わります。'],
        second: ['Now click where to. Escape ends.', '次に測り終わる所をクリック。Escで終わります。'],
      },
      closed: (length: string) => [`${length} when closed`, `閉じた状態で ${length}`],
    },
    picture: {
      save: ['Save as a picture', '画像として保存'],
      tip: ['Saves what is seen as a picture on white, with name, size and date below', '見えているものを白地の画像（名前・寸法・日付つき）として保存します'],
      object: (size: string) => [`Object ${size}`, `対象物 ${size}`],
      foam: (size: string) => [`Foam ${size}`, `緩衝材 ${size}`],
      between: [' · ', '・'],
    },
    up: ['UP', '上'],
    lost: [
      'The graphics of this browser stopped. They come back by themselves; nothing is lost.',
      'ブラウザーのグラフィックスが止まりました。自動で戻ります。データは失われません。',
    ],
    none: [
      'This browser has no WebGL 2, so there is no 3D view. Everything else works.',
      'このブラウザーにはWebGL 2がないため3D表示はできません。ほかの機能は使えます。',
    ],
    gapNear: ['touching', '接している'],
    gapFar: (mm: string) => [`${mm} and more`, `${mm} 以上`],
  },
  view2d: {
    label: ['Drawings', '図面'],
    tabs: {
      upright: ['Upright', '縦断面'],
      slice: ['Section', '横断面'],
      lower: ['Lower', '下'],
      middle: {
        above: (number: number) => [`Middle ${number}, above`, `中間 ${number} の上`],
        below: (number: number) => [`Middle ${number}, below`, `中間 ${number} の下`],
      },
      upper: ['Lid', 'ふた'],
    },
    /** Where there is little room for them. */
    shortTabs: {
      above: (number: number) => [`Middle ${number} ↑`, `中間 ${number} ↑`],
      below: (number: number) => [`Middle ${number} ↓`, `中間 ${number} ↓`],
    },
    slice: ['Slice', '断面'],
    sliceTip: [
      'One layer of blocks, counted from below. Page Up and Page Down move five.',
      '下から数えた1層のブロック。PageUp／PageDownで5層ずつ動きます。',
    ],
    sliceValue: ['Layer from below', '下からの層'],
    upright: ['Depth', '奥行き'],
    uprightTip: ['One row of columns, counted from the back. Page Up and Page Down move five.', '奥から数えた1列。PageUp／PageDownで5列ずつ動きます。'],
    uprightValue: ['Row from the back', '奥からの列'],
    uprightAt: (mm: string) => [`seen from the front, at ${mm}`, `前から見た図、奥行き ${mm}`],
    sliceAt: (mm: string) => [`seen from above, at ${mm}`, `上から見た図、高さ ${mm}`],
    notes: {
      lower: [
        'LOWER · cavity facing you · numbers: blocks to remove',
        '下の緩衝材（LOWER）・くぼみが手前・数字は取り除くブロック数',
      ],
      middle: {
        above: (number: number) => [
          `MIDDLE ${number} from above · cavity facing you · numbers: blocks to remove`,
          `中間 ${number}（MIDDLE ${number}）上から・くぼみが手前・数字は取り除くブロック数`,
        ],
        below: (number: number) => [
          `MIDDLE ${number} from below · cavity facing you · numbers: blocks to remove`,
          `中間 ${number}（MIDDLE ${number}）下から・くぼみが手前・数字は取り除くブロック数`,
        ],
      },
      upper: [
        'LID · cavity facing you · numbers: blocks to remove',
        'ふた（LID）・くぼみが手前・数字は取り除くブロック数',
      ],
    },
    back: ['BACK', '奥（BACK）'],
    print: ['Print', '印刷'],
    printTip: [
      'Prints the maps of all pieces of foam, one page for each side with cavities, which faces you',
      '図を印刷します：緩衝材のくぼみのある面を1ページずつ、くぼみを手前にして',
    ],
    column: (j: number, k: number) => [`Row ${j}, column ${k}`, `${j} 行 ${k} 列`],
    remove: (parts: readonly string[]) => [`remove ${parts.join(', ')}`, `${parts.join('、')} 取り除く`],
    removeFrom: {
      lower: (blocks: number) => [`${blocks} below`, `下で ${blocks}`],
      middle: (blocks: number, number: number) => [`${blocks} in middle ${number}`, `中間 ${number} で ${blocks}`],
      upper: (blocks: number) => [`${blocks} in the lid`, `ふたで ${blocks}`],
    },
    hover: ['Point at a column to see it in both windows.', '列を指すと両方の窓に表示されます。'],
    legend: {
      lower: ['lower foam', '下の緩衝材'],
      middle: ['middle foam', '中間の緩衝材'],
      upper: ['lid', 'ふた'],
      cut: ['cut away', '切り取り'],
      object: ['object', '対象物'],
    },
    canvas: {
      upright: (n: number) => [`Upright section through row ${n}`, `奥から ${n} 列目の縦断面`],
      section: (n: number) => [`Section through layer ${n}`, `${n} 層目の断面`],
      lower: ['Map of the lower foam: blocks to remove in each column', '下の緩衝材の図：各列で取り除くブロック数'],
      middle: {
        above: (number: number) => [
          `Map of middle foam ${number} from above: blocks to remove in each column`,
          `中間の緩衝材 ${number} の上からの図：各列で取り除くブロック数`,
        ],
        below: (number: number) => [
          `Map of middle foam ${number} from below: blocks to remove in each column`,
          `中間の緩衝材 ${number} の下からの図：各列で取り除くブロック数`,
        ],
      },
      upper: ['Map of the lid: blocks to remove in each column', 'ふたの図：各列で取り除くブロック数'],
    },
  },
});

import {byName, words} from './words';

// The foam: its blocks, the case around it, and how tightly it holds.

export const foam = words({
  foam: {
    preset: ['Foam', '緩衝材'],
    presetTip: [
      'Real foams with the blocks that they have. Everything below can still be changed.',
      '実際に手に入る緩衝材とそのブロックの大きさ。下の値はあとから変えられます。',
    ],
    presets: byName({
      paper: ['Block sponge 15 × 15 × 22', 'ブロックスポンジ 15 × 15 × 22'],
      'slit-10': ['Slit sponge 10 mm', 'スリットスポンジ 10 mm'],
      'slit-12.7': ['Slit sponge ½ inch', 'スリットスポンジ ½ インチ'],
      'slit-15': ['Slit sponge 15 mm', 'スリットスポンジ 15 mm'],
      'cube-25': ['Cubes 25 mm', 'キューブ 25 mm'],
      'sheet-5': ['Sheets 5 mm', 'シート 5 mm'],
      'sheet-10': ['Sheets 10 mm', 'シート 10 mm'],
      print: ['Printed, steps of 2 mm', '3Dプリント 2 mm 刻み'],
      'lego-brick': ['Toy bricks, 8 mm', 'ブロック玩具 8 mm'],
      'lego-plate': ['Toy plates, 8 mm', 'ブロック玩具（薄）8 mm'],
      mill: ['Milled, columns of 2 mm', '切削 2 mm 刻み'],
      cast: ['Cast in moulds, 5 mm', '注型 5 mm 刻み'],
    }),
    rigid: ['Rigid: it holds, but does not cushion.', '硬い材料：支えますが、衝撃は吸収しません。'],
    fitted: ['Fit the space to the object', '対象物に合わせて空間を決める'],
    fittedTip: [
      'As many blocks as the object and its walls need. Off: you choose the number of blocks.',
      '対象物と壁に必要なだけのブロック数にします。オフにすると自分で数を決められます。',
    ],
    wall: ['Wall', '壁の厚さ'],
    wallTip: [
      'Foam between the object and the case on every side. 50 mm is the usual least for parcels.',
      '対象物とケースの間の、各面の緩衝材の厚さ。宅配便では 50 mm 以上が目安です。',
    ],
    blocks: ['Blocks', 'ブロック数'],
    blocksTip: (axis: string) => [`How many blocks of foam along ${axis}`, `${axis}のブロックの数`],
    blockSize: ['Block size', 'ブロックの大きさ'],
    blockSizeTip: (axis: string) => [`How large one block is along ${axis}`, `${axis}のブロック1個の大きさ`],
    space: ['Outside', '外寸'],
    clearance: ['Clearance', 'クリアランス'],
    clearanceTip: [
      'Play around the object before blocks are cut. Negative squeezes it.',
      'ブロックを切る前に対象物のまわりに取る余裕。負の値は締めつけます。',
    ],
    axes: {x: ['up', '上下'], y: ['front to back', '前後'], z: ['left to right', '左右']},
  },
  cases: {
    wallsApart: ['Walls of their own on each side', '壁の厚さを面ごとに決める'],
    wallsApartTip: ['A floor may be thicker than the sides.', '底だけを厚くすることもできます。'],
    wall: ['Wall', '壁の厚さ'],
    sides: [['Floor', '底'], ['Roof', '上'], ['Back', '奥'], ['Front', '手前'], ['Left', '左'], ['Right', '右']],
    fill: ['Fill a case', 'ケースに合わせる'],
    fillTip: [
      'The foam fills the inside of a case; the halves part where its lid does.',
      '緩衝材はケースの内側を満たし、ふたの線で分かれます。',
    ],
    look: ['Which cases hold it?', '入るケースを探す'],
    nothing: (least: string) => [
      `None of the known cases holds it. One would from ${least} inside.`,
      `登録済みのケースには入りません。内寸 ${least} 以上が必要です。`,
    ],
    nearest: (name: string, inside: string) => [
      `The nearest is ${name}, ${inside}.`,
      `最も近いのは ${name}（${inside}）です。`,
    ],
    filled: (percent: string) => [`${percent} filled`, `充填 ${percent}`],
  },
  fit: {
    apart: ['Lower foam and lid each with their own', '下の緩衝材とふたで別々に決める'],
    apartTip: [
      'Along each axis, too. A lid may be loose around an object that the lower foam holds tight.',
      '軸ごとにも決められます。下の緩衝材でしっかり支え、ふたはゆるくできます。',
    ],
    halves: {
      lower: ['Clearance of the lower foam', '下の緩衝材のクリアランス'],
      upper: ['Clearance of the lid', 'ふたのクリアランス'],
    },
    halfTip: (axis: string) => [`Play around the object along ${axis}`, `${axis}方向のクリアランス`],
    pads: ['Pads in what block steps leave', '段のすきまに詰め板を入れる'],
    padsTip: [
      'Rectangles of sheet foam below and above the object; step 4 and the packing sheet list them with numbers and sizes',
      '対象物の上下に入れる板状の緩衝材。番号と寸法の一覧は手順4と梱包指示書に出ます',
    ],
    relief: ['Islands under the object', '対象物を島で支える'],
    reliefTip: [
      'Much foam under little weight stops it too hard: all but three or four islands below it is taken away. For one object, in sheets or a milled block',
      '軽いものを広い緩衝材で受けると衝撃が大きくなります。下の緩衝材を三、四か所の島だけ残してくり抜きます。対象物が一つで、シートか切削した塊の場合に使えます',
    ],
    lift: ['Slots to lift the foam by', '持ち上げ口'],
    liftTip: [
      'Two recesses at the edges of every piece above the lowest, for the hands that lift it out of the case',
      '一番下を除く各緩衝材の縁に設ける、ケースから持ち上げるための2つのくぼみ',
    ],
    notches: ['Finger notches', '指かけ'],
    notchesTip: [
      'Two recesses in the lower foam, opposite each other, for the fingers that lift the object',
      '対象物を持ち上げる指のための、下の緩衝材の向かい合う2つのくぼみ',
    ],
    notchMoved: ['Choose their places', '位置を決める'],
    notchPlaceTip: [
      'The middle of the notch along the object’s side, from the middle of the space',
      '側面に沿った指かけの中心（空間の中心から）',
    ],
  },
  pads: {
    lowered: ['Lowered onto its foam', '緩衝材に載せるために下げた量'],
    stays: ['stays as it lies', 'そのまま'],
    heading: ['Pads', '詰め板'],
    how: [
      'Numbered as in the 3D view. Width × depth × thickness.',
      '番号は3D表示と同じです。寸法は 幅 × 奥行き × 厚さ。',
    ],
    of: (item: string, pad: string) => [`${item}: ${pad}`, `${item}：${pad}`],
  },
});

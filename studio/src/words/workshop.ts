import {byName, words} from './words';

// How the foam is made, and the machines for it.

export const workshop = words({
  workshop: {
    how: ['How you work', '作り方'],
    works: {
      none: ['The foams’ own files', '緩衝材のファイルのみ'],
      sponge: ['Slit sponge and cubes', 'スリットスポンジ・キューブ'],
      sheets: ['Sheets, cut and glued', 'シートを切って貼る'],
      print: ['3D print', '3Dプリント'],
      bricks: ['Toy bricks', 'ブロック玩具'],
      mill: ['Mill', 'CNC切削'],
      mould: ['Moulds to pour into', '型に流し込む'],
    },
    workTips: {
      none: ['Solids, depth table, drawing', '立体・深さの表・図'],
      sponge: ['Maps at true size of which blocks to pluck', '抜き取るブロックの原寸の図'],
      sheets: [
        'Outlines for a cutter, nested on stock, as SVG and DXF',
        'カッター用の輪郭（SVG・DXF、材料に割り付け済み）',
      ],
      print: [
        '3MF and STL for your bed, with dowels where it is too small',
        'プリンターに合わせた 3MF と STL（大きいときはダボでつなぐ）',
      ],
      bricks: ['Building steps, parts list and wanted list, LDraw', '組み立て手順・部品表・購入リスト・LDraw'],
      mill: ['G-code for a flat cutter, each half cavity up', 'フラットエンドミル用の Gコード（くぼみを上に）'],
      mould: ['Boxes to print, for foam or silicone', '発泡樹脂やシリコーンを流し込む型の3Dプリント'],
    },
    takeUsual: (preset: string) => [`Take its usual foam: ${preset}`, `通常の材料にする：${preset}`],
    counting: ['Counting what it takes …', '必要なものを数えています …'],
  },
  bricks: {
    halves: {lower_color: ['Lower half', '下の色'], lid_color: ['Lid', 'ふたの色']},
    colorTip: ['Of all bricks of this half', 'この半分のすべてのブロックの色'],
    colors: byName({
      black: ['black', '黒'],
      blue: ['blue', '青'],
      green: ['green', '緑'],
      red: ['red', '赤'],
      yellow: ['yellow', '黄'],
      white: ['white', '白'],
      tan: ['tan', 'タン'],
      orange: ['orange', 'オレンジ'],
      'reddish brown': ['reddish brown', '赤茶'],
      'light bluish gray': ['light bluish gray', '青みの薄い灰'],
      'dark bluish gray': ['dark bluish gray', '青みの濃い灰'],
      'dark blue': ['dark blue', '紺'],
      'dark brown': ['dark brown', '焦げ茶'],
      'dark red': ['dark red', '暗い赤'],
    }),
    sizes: ['Sizes to build with', '使う大きさ'],
    sizesTip: ['In studs. None chosen: all of them', 'ポッチの数。選ばなければすべて使います。'],
    stock: ['Pieces that you have', '手持ちの数'],
    stockTip: [
      'By size, for both halves together. Sizes that are not named do not run out.',
      '大きさごとに、両方の半分を合わせた数。書かない大きさはいくらでもあるとみなします。',
    ],
    stockWrong: ['Write sizes and pieces: 2x4=100, 1x1=40', '大きさと数を書いてください：2x4=100, 1x1=40'],
    studs: [
      'Studs stand 1.8 mm into the cavity, so the clearance along x is larger by that.',
      'ポッチがくぼみの中へ 1.8 mm 出るので、x 方向のクリアランスはその分大きくなります。',
    ],
  },
});

import {words} from './words';

// The object and its unit.

export const object = words({
  object: {
    none: ['Nothing is open yet.', 'まだ何も開いていません。'],
    size: ['Size', '大きさ'],
    triangles: ['Triangles', '三角形'],
    points: ['Points', '点の数'],
    partsTip: [
      'Untick what does not belong to the object; it is left out and cuts no foam.',
      '対象物に属さないもののチェックを外すと、除かれて緩衝材を削りません。',
    ],
    part: (number: number, size: string, share: string) => [
      `Part ${number}: ${size}, ${share} of the surface`,
      `部品${number}：${size}、表面の${share}`,
    ],
    closed: ['Surface', '表面'],
    watertight: ['closed', '閉じている'],
    holes: (n: number) => [n === 1 ? 'open: 1 hole' : `open: ${n} holes`, `開いている：穴 ${n} 個`],
    volume: ['Volume', '体積'],
    parts: ['Parts', '部品'],
    drawn: (n: string, mm: string) => [
      `The view draws a copy of ${n} triangles, at most about ${mm} off. The foam is cut from the original.`,
      `表示は三角形 ${n} 個のコピーです（ずれは最大で約 ${mm}）。緩衝材は元のデータから切り出します。`,
    ],
    thinned: (mm: string) => [
      `This is a thinned copy, nowhere more than ${mm} off the original. Use it to choose the placement; it is not exported. Make the foams from the original with:`,
      `これは間引いたコピーで、元からのずれは最大 ${mm} です。配置を決めるために使い、書き出しはできません。元のデータからは次のコマンドで作ります：`,
    ],
    unit: ['Unit of the file', 'ファイルの単位'],
    unitTip: [
      'Meshes carry no unit. If the size above looks wrong, choose what the numbers in the file mean.',
      'メッシュには単位がありません。上の大きさがおかしければ、数値の意味を選んでください。',
    ],
    unitAuto: ['not said (mm)', '指定なし（mm）'],
    unitByLength: ['by a known length', '既知の長さによる'],
    unitStated: ['stated by the file', 'ファイルに記載あり'],
    length: ['Set a length', '長さを指定する'],
    lengthTip: [
      'You know how long something is? Say it, and the whole object is scaled to match.',
      '実際の長さがわかるなら入力してください。全体がそれに合わせて拡大・縮小されます。',
    ],
    lengthOf: ['Which length', 'どの長さか'],
    lengthKinds: {
      longest: ['Longest side', '一番長い辺'],
      x: ['Along its x', 'x 方向'],
      y: ['Along its y', 'y 方向'],
      z: ['Along its z', 'z 方向'],
      clicks: ['Two clicks on the object', '対象物の上で2点をクリック'],
    },
    lengthValue: ['This length is', 'この長さは'],
    lengthApply: ['Set', '決定'],
    lengthFirst: ['Click the first point on the object.', '対象物の上の1点目をクリックしてください。'],
    lengthSecond: ['Click the second point.', '2点目をクリックしてください。'],
    lengthBoth: (mm: string) => [`Between the two points: ${mm} now.`, `2点の間は今 ${mm} です。`],
  },
  units: {
    heading: ['Which unit does this file use?', 'このファイルの単位は？'],
    lead: (size: string) => [
      `A mesh does not say its unit, and in millimetres this one would be ${size}.`,
      `メッシュには単位がありません。ミリメートルだとすると ${size} になります。`,
    ],
    beside: ['The object beside a sheet of A4 (210 × 297 mm)', 'A4用紙（210 × 297 mm）と並べた対象物'],
    longest: ['Or: its longest side is', 'または、最も長い辺の長さ'],
    set: ['Set', '決定'],
    open: [
      'There are no foams yet: the unit of this file is not chosen.',
      'まだ緩衝材がありません。このファイルの単位が選ばれていません。',
    ],
    reopen: ['Choose the unit', '単位を選ぶ'],
    names: {
      mm: ['Millimetres', 'ミリメートル'],
      cm: ['Centimetres', 'センチメートル'],
      m: ['Metres', 'メートル'],
      in: ['Inches', 'インチ'],
    },
  },
});

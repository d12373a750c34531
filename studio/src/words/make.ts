import {words} from './words';

// What is made and saved.

export const make = words({
  make: {
    what: ['What to export', '書き出すもの'],
    kinds: {
      zip: ['Everything in one zip', 'すべてを一つのzipに'],
      stl: ['The foams as STL', '緩衝材をSTLで'],
      ply: ['The foams as PLY', '緩衝材をPLYで'],
    },
    kindTips: {
      zip: [
        'Foams, drawing, depth table, report and project: what the command line writes',
        '緩衝材、図、深さの表、レポート、プロジェクト：コマンドラインと同じ内容',
      ],
      stl: ['lower.stl, upper.stl and what lies between, in millimetres', 'lower.stl、upper.stl と中間のもの（ミリメートル）'],
      ply: ['lower.ply, upper.ply and what lies between, in millimetres', 'lower.ply、upper.ply と中間のもの（ミリメートル）'],
    },
    export: ['Export', '書き出す'],
    exportTip: [
      'Makes the files on this computer and saves them to your downloads',
      'このコンピューターの中でファイルを作り、ダウンロードに保存します',
    ],
    summary: ['What you will make', '作るもの'],
    blocks: (n: string) => [`${n} blocks`, `${n} ブロック`],
    remove: ['Blocks to take out', '取り除くブロック'],
    weight: ['Weight of the foam', '緩衝材の重さ'],
    command: ['The same on the command line', '同じことをコマンドラインで'],
    copy: ['Copy', 'コピー'],
    copied: ['Copied', 'コピーしました'],
    named: ['Know before you make it:', '作る前に知っておくこと：'],
    readThem: ['Read them in Check', '「確認」で読む'],
    dangers: ['This foam is not safe yet', 'この緩衝材はまだ安全ではありません'],
    dangersLead: ['Before you make it, read this:', '作る前にお読みください：'],
    anyway: ['Make the files anyway', 'それでも作る'],
    back: ['Go back', '戻る'],
    thinned: [
      'This is a thinned copy of a large scan. Use the command above to make the foams from the original.',
      'これは大きなスキャンを間引いたコピーです。元のデータからは上のコマンドで作ってください。',
    ],
  },
});

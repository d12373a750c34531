import {words} from './words';

// What stops the library from working in a browser. All else that it refuses has its own words.

export const failures = words({
  failures: {
    cancelled: ['cancelled', '中止しました。'],
    superseded: ['a newer request took its place', '新しい依頼に置き換わりました。'],
    noMemory: [
      'the browser has no memory left for this: choose larger blocks, close other tabs, or use the command line',
      'ブラウザーのメモリーが足りません。ブロックを大きくするか、ほかのタブを閉じるか、コマンドラインを使ってください。',
    ],
    stopped: (why: string) => [
      `the library stopped unexpectedly (${why})`,
      `ライブラリーが予期せず止まりました（${why}）。`,
    ],
    worker: ['its worker failed', 'ワーカーの異常'],
    unreadable: (name: string, why: string) => [`${name}: cannot be read (${why})`, `${name}：読み込めません（${why}）。`],
    tooLarge: (name: string, line: string) => [
      `${name} needs more memory than the browser gives; the command line has no such limit: ${line}`,
      `${name} にはブラウザーで使える以上のメモリーが必要です。コマンドラインならこの制限はありません：${line}`,
    ],
  },
});

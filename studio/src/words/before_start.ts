import type {Pair} from './words';

// What index.html says before the program runs.

export const waiting: Pair = [
  'Snug Studio is starting. If nothing follows, this page was opened from a disk, where it cannot run: open snug-studio.html instead, or serve this folder.',
  'Snug Studioを起動しています。この文が消えないときは、ページがディスクから開かれているため動きません。代わりに snug-studio.html を開くか、このフォルダーをサーバーで公開してください。',
];

export const noScript: Pair = [
  'Snug Studio computes in this page and needs JavaScript.',
  'Snug Studioはこのページの中で計算するため、JavaScriptが必要です。',
];

import {words} from './words';

// The pieces of foam, and the layers of things between them.

export const pieces = words({
  pieces: {
    lower: ['Lower foam', '下の緩衝材'],
    middle: (number: number) => [`Middle foam ${number}`, `中間の緩衝材 ${number}`],
    upper: ['Lid', 'ふた'],
    layer: (number: number) => [`Layer ${number}`, `${number} 段目`],
    tray: ['Tray without a lid', 'ふたのないトレイ'],
    trayTip: [
      'For drawers and shadow boards: items stand open at the top, and one level surface sinks each at least this deep.',
      '引き出しや工具の収納用：上が開き、平らな面が一つで、どれも少なくともこの深さまで沈みます。',
    ],
    parting: ['Parting level', '分割の高さ'],
    partingOf: (layer: number) => [`Parting, layer ${layer}`, `${layer} 段目の分割`],
    partingTip: [
      'Where lower foam and lid meet beside the object, in blocks from below.',
      '対象物のない所で下の緩衝材とふたが合わさる高さ（下からのブロック数）。',
    ],
    partingOfTip: (layer: number) => [
      `Where the pieces around layer ${layer} meet beside its items, in blocks from below.`,
      `${layer} 段目のもののない所で、その上下の緩衝材が合わさる高さ（下からのブロック数）。`,
    ],
    surface: ['Surface', '上面の高さ'],
    surfaceTip: [
      'Where the foam of the tray ends, in blocks from below. Chosen here, it no longer follows how deep items are sunk.',
      'トレイの緩衝材の上面（下からのブロック数）。ここで決めると、沈める深さには従いません。',
    ],
    automatic: ['Choose it for me', '自動で決める'],
  },
});

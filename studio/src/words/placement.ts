import {byName, words} from './words';

// How the object lies, and where to put it.

export const placement = words({
  placement: {
    rotation: ['Rotation', '回転'],
    rotationTips: {
      ψ: ['Turn about the upright axis (x)', '上下の軸（x）まわりの回転'],
      θ: ['Turn about the axis from back to front (y)', '前後の軸（y）まわりの回転'],
      φ: ['Turn about the axis from left to right (z)', '左右の軸（z）まわりの回転'],
    },
    inDegrees: (angle: string) => [`${angle} in degrees`, `${angle}（度）`],
    quarter: ['Quarter turns', '90度回転'],
    quarterTip: (axis: string, way: string) => [
      `Quarter turn about ${axis}, ${way}`,
      `${axis}の軸まわりに90度、${way}`,
    ],
    ways: {left: ['counterclockwise', '左回り'], right: ['clockwise', '右回り']},
    fine: ['Fine turn', '細かく回す'],
    down: ['This side down', 'この面を下に'],
    downTip: (side: string) => [`Lays it like this: ${side} of its file down`, `このように置きます（ファイルの ${side} 側が下）`],
    offset: ['Shift', '移動'],
    offsetTip: (axis: string) => [
      `Shift the object from the middle of the space, ${axis}`,
      `空間の中心からの移動：${axis}`,
    ],
    offsetAxes: {x: ['up', '上へ'], y: ['to the front', '前へ'], z: ['to the right', '右へ']},
    objective: ['Look for', '重視するもの'],
    objectiveTip: ['What Optimize makes small or large', '最適化で小さく、または大きくするもの'],
    objectives: byName({
      cut: ['least foam cut away', '削る緩衝材を最少に'],
      gap: ['least gap at the surface', '表面のすきまを最小に'],
      depth: ['least insertion depth', '差し込む深さを最小に'],
      bearing: ['most bearing area', '支える面を最大に'],
      flat: ['lying flat and steady', '低く安定して置く'],
      shock: ['least shock in a drop', '落下の衝撃を最小に'],
    }),
    upright: ['Keep upright', '上に保つ軸'],
    uprightTip: [
      'This axis of the object stays upward while it is optimized',
      '最適化の間、対象物のこの軸を上に保ちます',
    ],
    anyWay: ['any way', '指定なし'],
    smallest: ['Smallest space', '最小の空間'],
    smallestTip: [
      'The fewest blocks that hold the object and its walls, however it is turned',
      '向きを変えて、対象物と壁が入る最少のブロック数にします',
    ],
    optimize: ['Optimize', '最適化'],
    optimizeTip: [
      'Look at every way to turn the object, and shift it by up to half a block, for the placement that cuts the least foam away. Cancel keeps the best so far.',
      'あらゆる向きと半ブロック以内の移動を調べ、削る緩衝材が最も少ない配置を探します。中止すると、それまでの最良が残ります。',
    ],
    searching: (f: string) => [`Searching … F ${f}`, `探索中 … F ${f}`],
  },
  search: {
    alternatives: ['The best placements that differ', '異なる配置の上位'],
    alternativesTip: [
      'The best number may be a silly way to hold a camera: choose the one that suits your object.',
      '数値が最良でも、置き方として自然とは限りません。対象物に合うものを選んでください。',
    ],
    alternative: (n: number, litres: string) => [
      `Placement ${n}: cuts ${litres}`,
      `配置 ${n}：切り取り ${litres}`,
    ],
    map: ['Map of directions', '挿入方向の地図'],
    mapTip: [
      'Colours every direction in which the object could be put in by the foam that would be cut away.',
      '対象物を入れられるすべての方向を、切り取られる緩衝材の量で色分けします。',
    ],
    mapLabel: [
      'Map of directions: arrow keys move, Enter turns the object',
      '挿入方向の地図：矢印キーで移動、Enter で対象物を回転',
    ],
    mapHint: [
      'Dark cuts the least. The ring is where you are; pick any place to turn the object there.',
      '濃い色ほど切り取りが少ない方向です。輪が現在の方向。好きな場所を選ぶとその向きに回ります。',
    ],
    cutHere: (litres: string) => [`Cuts ${litres}`, `切り取り ${litres}`],
    fitsNot: ['In this direction it does not fit with its walls.', 'この方向では、壁を保って入れることができません。'],
  },
});

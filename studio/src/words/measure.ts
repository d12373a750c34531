import {words} from './words';

// An object from measurements.

export const measure = words({
  measure: {
    heading: ['From measurements', '測った寸法から'],
    lead: [
      'Begin with the box that it would just go into. Add more where that is too coarse: the foam then follows it more closely.',
      'まず、ちょうど入る直方体の寸法を入れてください。大まかすぎるところは、形を足して近づけます。',
    ],
    solids: ['Made of', '組み合わせる形'],
    kinds: {box: ['Box', '直方体'], cylinder: ['Cylinder', '円柱'], cone: ['Cone', '円すい'], ball: ['Ball', '球']},
    numbered: (n: number, kind: string) => [`${n}. ${kind}`, `${kind}（${n}）`],
    of: (solid: string, what: string) => [`${solid}: ${what}`, `${solid}：${what}`],
    lengths: {
      box: [['Length', '長さ'], ['Width', '幅'], ['Height', '高さ']],
      cylinder: [['Diameter', '直径'], ['Length', '長さ']],
      cone: [['Diameter', '直径'], ['At the other end', '反対側の直径'], ['Length', '長さ']],
      ball: [['Diameter', '直径']],
    },
    radius: ['Edges rounded by', '角の丸み（半径）'],
    along: ['Points along', '軸の向き'],
    axes: {x: ['the length', '長さの方向'], y: ['the width', '幅の方向'], z: ['the height', '高さの方向']},
    alongTip: ['Where its axis points to', '円柱や円すいの軸の向き'],
    places: [['Middle along length', '中心（長さ方向）'], ['along width', '幅方向'], ['along height', '高さ方向']],
    remove: (solid: string) => [`Remove ${solid}`, `${solid} を削除`],
    removeShort: ['Remove', '削除'],
    add: ['Add', '追加'],
    addKind: (kind: string) => [`Add: ${kind}`, `追加：${kind}`],
    error: ['Measured to within', '測定の誤差'],
    errorTip: ['Added to the clearance on every side', 'クリアランスに加えます'],
    done: ['Go on', '次へ'],
    change: ['Change the measurements', '寸法を変更'],
    foreign: [
      'This file has something that cannot be changed here: open it in a text editor.',
      'このファイルには、ここでは変更できない記述があります。テキストエディターで開いてください。',
    ],
  },
});

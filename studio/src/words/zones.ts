import {words} from './words';

// Places on an item that foam keeps away from.

export const zones = words({
  zones: {
    heading: ['Places to keep off', '触れない場所'],
    lead: [
      'Handles, spouts, flaking paint: show them on the object, and the foam keeps its distance. What lies free is not protected by that.',
      '取っ手、注ぎ口、剝がれかけた彩色など。対象物の上で塗って示すと、緩衝材がそこから離れます。離すだけで守られるわけではありません。',
    ],
    of: (name: string) => [`Of ${name}`, `${name} について`],
    list: ['Places to keep off, one by one', '触れない場所の一覧'],
    add: ['Add a place', '場所を追加'],
    addTip: ['Then paint it on the object in the view', '続けて、表示の中の対象物に塗ります'],
    most: (n: number) => [`There may be ${n} places at most.`, `場所は ${n} か所までです。`],
    place: (n: number) => [`Place ${n}`, `場所 ${n}`],
    fresh: ['New place: paint it on the object', '新しい場所：対象物に塗ってください'],
    remove: (n: number) => [`Remove place ${n}`, `場所 ${n} を削除`],
    keepOff: ['Distance', '離す距離'],
    keepOffTip: ['How far foam stays away, all round. 0: no farther than elsewhere', 'まわりの緩衝材をこれだけ離します。0 ならほかと同じです'],
    press: ['May be pressed with at most', '押してよい圧力の上限'],
    pressTip: [
      'What the surface bears, as a mean over 1 cm². Tick it only where that is known: the estimate of drops then tells when it is more.',
      '表面が耐える圧力（1 cm² の平均）。わかっているときだけ入力してください。落下の見積りで超えるときに知らせます。',
    ],
    loose: ['Loose surface: flaking, powdery, gilded', '傷みやすい表面：剝がれ・粉状・金箔'],
    looseShort: ['loose', '傷みやすい'],
    looseTip: ['Nothing may touch it, so it is never pressed.', '何も触れてはならないので、押すことはありません。'],
    waits: ['What becomes of it is being looked at…', '結果を調べています…'],
    reached: ['Foam or case comes too near in a drop', '落下で近づきすぎます'],
    pressed: ['Pressed more than it bears', '耐える以上に押されます'],
    tools: ['Paint on the object', '対象物に塗る'],
    toolNames: {
      brush: ['Brush', 'ブラシ'],
      eraser: ['Eraser', '消しゴム'],
      part: ['Whole part', '部品ごと'],
      height: ['By height', '高さで'],
    },
    toolTips: {
      brush: ['Drag over the object', '対象物の上をドラッグします'],
      eraser: ['Drag over what was painted', '塗ったところをドラッグします'],
      part: ['Click a separate part of the object', '対象物の独立した部品をクリックします'],
      height: ['All around, between two heights', '二つの高さの間をぐるりと塗ります'],
    },
    help: {
      brush: ['Drag over the object to paint.', '対象物の上をドラッグして塗ります。'],
      eraser: ['Drag over the paint to take it off.', '塗ったところをドラッグして消します。'],
      part: ['Click a part; once more to leave it out.', '部品をクリックします。もう一度で外れます。'],
      height: ['Choose the heights, then paint.', '高さを決めて塗ります。'],
    },
    turn: [
      'Beside it, or with the right button or two fingers: turn.',
      '外側のドラッグ、右ボタン、二本指で回転します。',
    ],
    radius: ['Brush', 'ブラシ'],
    radiusValue: ['Radius of the brush in mm', 'ブラシの半径（ミリ）'],
    radiusTip: ['How far the paint reaches around the pointer', 'ポインターのまわりを塗る広さ'],
    axis: ['Along its', '方向'],
    axes: {x: ['x axis', 'x 軸'], y: ['y axis', 'y 軸'], z: ['z axis', 'z 軸']},
    from: ['From', 'ここから'],
    to: ['To', 'ここまで'],
    fill: ['Paint between', 'この間を塗る'],
    done: ['Done', '終わる'],
    full: [
      'A place has room for 2,000 dabs. Paint the rest with a larger brush or as another place.',
      '一つの場所に塗れるのは 2,000 回までです。残りは大きいブラシか別の場所で塗ってください。',
    ],
  },
});

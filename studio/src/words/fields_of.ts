import {words} from './words';

// What all fields have: More, the mark of what differs, the search, and the step after this one.

export const fieldsOf = words({
  fieldsOf: {
    more: (n: number) => [`More (${n})`, `その他の項目（${n}）`],
    between: [', ', '、'],
    fewer: ['Fewer', '項目を減らす'],
    all: ['All', 'すべて'],
    allTip: ['Always show every field of every step, one below the other', '各手順のすべての項目を、いつも続けて表示します'],
    reset: (field: string, value: string) => [`Reset ${field} to ${value}`, `${field}を「${value}」に戻す`],
    on: ['on', 'オン'],
    off: ['off', 'オフ'],
    none: ['not given', '指定なし'],
    quoted: (field: string) => [`“${field}”`, `「${field}」`],
    chosen: (field: string, way: string) => [`${field}: ${way}`, `${field}：${way}`],
    automatic: ['automatic', '自動'],
    range: (field: string, value: number, [least, most]: readonly (number | undefined)[], unit: string) => [
      `${field}: must be from ${least} to ${most}${unit && ` ${unit}`}, not ${value}`,
      `${field}：${value} は使えません。使える範囲は ${least} から ${most}${unit && ` ${unit}`} までです。`,
    ],
    whole: (field: string, value: number) => [
      `${field}: must be a whole number, not ${value}`,
      `${field}：${value} は使えません。整数で入力してください。`,
    ],
    search: ['Find a field', '項目を探す'],
    searchHint: ['Find: rib, liner, kerf …', '検索：リブ、内張り …'],
    found: (n: number) => [n === 1 ? '1 field' : `${n} fields`, `${n} 件`],
    foundNone: ['No field has this word', 'この語を含む項目はありません'],
    with: (way: string) => [`with “${way}”`, `「${way}」のとき`],
    comesWith: (field: string, way: string) => [`“${field}” comes with “${way}”: choose that first.`, `「${field}」は「${way}」を選ぶと表示されます。`],
    notNow: (field: string) => [
      `“${field}” is not there now: it comes with another choice, or another object.`,
      `「${field}」は今はありません。ほかの設定や対象物のときに表示されます。`,
    ],
    next: (step: string) => [`Next: ${step}`, `次へ：${step}`],
    past: ['Past the controls, to the picture', '操作欄を飛ばして図へ'],
    fineTurn: ['Rotation ψ, θ, φ in degrees', '回転角 ψ、θ、φ（度）'],
  },
});

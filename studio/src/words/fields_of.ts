import {words} from './words';

// What all fields have: More, the mark of what differs, and the step after this one.

export const fieldsOf = words({
  fieldsOf: {
    more: (n: number) => [`More (${n})`, `その他の項目（${n}）`],
    between: [', ', '、'],
    fewer: ['Fewer', '項目を減らす'],
    reset: (field: string, value: string) => [`Reset ${field} to ${value}`, `${field}を「${value}」に戻す`],
    on: ['on', 'オン'],
    off: ['off', 'オフ'],
    none: ['not given', '指定なし'],
    automatic: ['automatic', '自動'],
    next: (step: string) => [`Next: ${step}`, `次へ：${step}`],
    past: ['Past the controls, to the picture', '操作欄を飛ばして図へ'],
    fineTurn: ['Rotation ψ, θ, φ in degrees', '回転角 ψ、θ、φ（度）'],
  },
});

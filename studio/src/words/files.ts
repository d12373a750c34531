import {words, type Pair} from './words';

// Files that are opened, and works that the browser keeps.

export const files = words({
  files: {
    tooBig: (name: string, line: string) => [
      `${name} is too big for the browser. The command line makes its foams: ${line}`,
      `${name} はブラウザーには大きすぎます。コマンドラインで作れます：${line}`,
    ],
    openObjectOf: (name: string) => [
      `The project is read. Now open its object: ${name}`,
      `プロジェクトを読み込みました。次に対象物を開いてください：${name}`,
    ],
    otherContent: (name: string) => [
      `This file has another content than the ${name} that the project was made for: check the fit.`,
      `このファイルの内容は、プロジェクトの ${name} と違います。合うか確かめてください。`,
    ],
    waitsNoMore: (name: string) => [
      `The project was for ${name} and is not used for this object.`,
      `プロジェクトは ${name} のためのものなので、この対象物には使いませんでした。`,
    ],
    noProject: (names: string[]) => [
      `Left out, since it is no project of Snug: ${names.join(', ')}`,
      `Snugのプロジェクトではないので、次のファイルは使いませんでした：${names.join('、')}`,
    ],
    leftOut: (names: string[]) => [
      `Left out, since the objects beside it were opened: ${names.join(', ')}`,
      `一緒にある対象物を開いたので、次のファイルは使いませんでした：${names.join('、')}`,
    ],
  },
  works: {
    heading: ['Go on where you left off', '前回の続きから'],
    resume: ['Continue', '続ける'],
    resumeNamed: (name: string, when: string) => [`Continue ${name}, ${when}`, `${name} を続ける、${when}`],
    discard: ['Discard', '破棄'],
    discardNamed: (name: string, when: string) => [`Discard ${name}, ${when}`, `${name} を破棄、${when}`],
    discardYes: ['Discard it for good', '完全に破棄する'],
    unnamed: ['No object yet', '対象物なし'],
    elsewhere: [
      'This work is open in another tab now: go on with it there.',
      'この作業は別のタブで開かれています。そちらで続けてください。',
    ],
    broken: ([en, ja]: Pair) => [
      `What was saved cannot be brought back by this version of Snug, and stays where it is: ${en}`,
      `保存された作業は、この版のSnugでは元に戻せません。データはそのまま残します：${ja}`,
    ],
    objectGone: [
      'The object of this step is no longer in this browser’s memory: open its file again.',
      'この手順の対象物は、このブラウザーの記憶に残っていません。ファイルをもう一度開いてください。',
    ],
    cannotKeep: (why: string) => [
      `This browser cannot keep the work (${why}): save the project.`,
      `このブラウザーは作業を保存できません（${why}）。プロジェクトを保存してください。`,
    ],
    notKept: [
      'This browser does not keep the work on this page: save the project before you close it.',
      'このブラウザーは、このページの作業を保存しません。閉じる前にプロジェクトを保存してください。',
    ],
    blocked: [
      'Another tab has an earlier version of this page open. Until it is closed, the work here is not kept: close it, or save the project.',
      '以前の版のこのページが別のタブで開いています。それを閉じるまで、ここでの作業は保存されません。そのタブを閉じるか、プロジェクトを保存してください。',
    ],
  },
});

import {byName, words} from './words';

// The frame of the page, and what it says of itself.

export const page = words({
  code: ['en', 'ja'],
  name: ['English', '日本語'],
  title: ['Snug Studio: protective foam by looking at it', 'Snug Studio：見ながら設計する緩衝フォーム'],
  header: {
    open: ['Open object', '対象物を開く'],
    openShort: ['Open', '開く'],
    openTip: [
      'A scan or 3D model (STL, OBJ, PLY, OFF, glTF, 3MF), a point cloud (PLY, XYZ, PTS), a zip with one of them, or a Snug project; several at once lie in one case. It stays on this computer.',
      'スキャンや3Dモデル（STL、OBJ、PLY、OFF、glTF、3MF）、点群（PLY、XYZ、PTS）、そのどれかが入ったzip、またはSnugのプロジェクト。複数を選ぶと一つのケースに入ります。このコンピューターの外には出ません。',
    ],
    undo: ['Undo', '元に戻す'],
    undoTip: ['Take the last change back (Ctrl+Z)', '最後の変更を取り消します（Ctrl+Z）'],
    redo: ['Redo', 'やり直す'],
    redoTip: ['Make it again (Ctrl+Shift+Z)', '取り消した変更をもう一度行います（Ctrl+Shift+Z）'],
    save: ['Save project', 'プロジェクトを保存'],
    saveTip: [
      'Every choice in one small file, which the command line reads too (Ctrl+S). The object is not in it.',
      'すべての設定を一つの小さなファイルに。コマンドラインでも読めます（Ctrl+S）。対象物は含みません。',
    ],
    language: ['Language', '言語'],
    theme: ['Colours', '配色'],
    themes: {system: ['As the system', 'システムに合わせる'], light: ['Light', 'ライト'], dark: ['Dark', 'ダーク']},
    clear: ['Start over', '最初から'],
    clearTip: [
      'Forget the object and every change, here and in this browser’s memory',
      '対象物とすべての変更を、このブラウザーの記憶からも消します',
    ],
    clearAsk: [
      'Forget the object and every change? A saved project stays where you saved it.',
      '対象物とすべての変更を消しますか？保存したプロジェクトは残ります。',
    ],
    clearYes: ['Forget everything', 'すべて消す'],
  },
  steps: {
    label: ['Steps', '手順'],
    object: ['Object', '対象物'],
    foam: ['Foam', 'フォーム'],
    placement: ['Placement', '配置'],
    check: ['Check', '確認'],
    make: ['Make', '製作'],
  },
  empty: {
    heading: ['What are you packing?', '何を梱包しますか？'],
    lead: [
      'Drop a scan or a 3D model here. Snug designs the foam around it, and nothing leaves this computer.',
      'スキャンや3Dモデルをここにドロップすると、まわりのフォームを設計します。データはこのコンピューターの外に出ません。',
    ],
    choose: ['Choose a file', 'ファイルを選ぶ'],
    or: ['or try one of these', 'または、見本で試す'],
    samples: byName({
      torus: ['Ring', 'リング'],
      vase: ['Vase', '花瓶'],
      figurine: ['Figurine', '人形'],
      camera: ['Camera', 'カメラ'],
    }),
    formats: [
      'STL, OBJ, PLY, OFF, glTF, 3MF, XYZ, PTS, a zip with one of them, or a Snug project',
      'STL、OBJ、PLY、OFF、glTF、3MF、XYZ、PTS、そのどれかが入ったzip、またはSnugのプロジェクト',
    ],
    drop: ['Drop it anywhere', 'どこにでもドロップできます'],
  },
  status: {
    waiting: ['Ready', '準備完了'],
    wall: ['Thinnest wall', '最も薄い壁'],
    gap: ['Widest gap', '最大のすきま'],
    gapUnmeasured: ['not measured', '未測定'],
    litres: ['Foam', 'フォーム'],
    noFoam: ['It does not fit: no foam yet', '入りきらないため、まだフォームがありません'],
    noUnit: ['No foam yet: its unit is not chosen', '単位が選ばれていないため、まだフォームがありません'],
    timeTip: ['From your last change to its new foams', '最後の変更から新しいフォームまで'],
  },
  busy: {
    start: ['Starting …', '起動中 …'],
    read: ['Reading the object …', '対象物を読み込み中 …'],
    reading: (name: string) => [`Reading ${name} …`, `${name} を読み込み中 …`],
    gaps: ['Measuring the gaps …', 'すきまを測定中 …'],
    search: ['Looking for the best placement …', '最良の配置を探索中 …'],
    arrange: ['Arranging …', '並べ方を探索中 …'],
    map: ['Looking in every direction …', 'すべての方向を調査中 …'],
    walls: ['Choosing the walls …', '壁の厚さを決めています …'],
    make: ['Making the files …', 'ファイルを作成中 …'],
    cancel: ['Cancel', '中止'],
  },
  panel: {
    move: ['Move this question', 'この質問を動かす'],
    moveTip: ['Drag it, or use the arrow keys', 'ドラッグするか、矢印キーで動かします'],
  },
  broken: ['Snug cannot start here', 'ここではSnugを起動できません'],
  close: ['Close', '閉じる'],
});

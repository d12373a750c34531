import {byPath} from './words';

// The fields that are one option of the design each, by its path in a project. `parts`: of several numbers, `words`: of
// what can be chosen, where "none" is to leave it open.

export const fields = {
  fields: byPath({
    'object.cap': {
      name: ['Close the holes before cutting', '切る前に穴をふさぐ'],
      tip: [
        'For scans that are open at the base: the missing surface is spanned, so that no foam grows inside.',
        '底が開いたスキャン用：欠けた面を補い、内側に緩衝材が残らないようにします。',
      ],
    },
    'object.point_radius_mm': {
      name: ['Radius of a point', '点の半径'],
      tip: [
        'Each point of the cloud counts as a ball of this radius; 0 takes it from the spacing of the points.',
        '点群の各点をこの半径の球とみなします。0なら点の間隔から決めます。',
      ],
    },
    'object.clean.drop_below_mm': {
      name: ['Leave out parts below', 'これより小さい部品を除く'],
      tip: [
        'Separate parts that are shorter than this are left out: specks that the scanner saw beside the object.',
        'これより短い離れた部品（スキャンに写り込んだごみなど）を除きます。',
      ],
    },
    'cut.cut_on_touch': {
      name: ['Also cut blocks that are only touched', '触れるだけのブロックも切る'],
      tip: [
        'Stricter: a block whose face the object merely touches is cut away, too.',
        'より厳しく：面が触れるだけのブロックも切り取ります。',
      ],
    },
    'search.turns': {
      name: ['Turned', '回し方'],
      tip: ['How things may be turned when they are arranged', '並べるとき、どのように回してよいか'],
      words: {
        none: ['not at all', '回さない'],
        upright: ['about the upright axis', '上下の軸まわり'],
        quarter: ['onto any side', 'どの面を下にしても'],
        any: ['any way', 'どの向きでも'],
      },
    },
    'search.layers': {
      name: ['Layers', '段の数'],
      tip: [
        'Over how many layers they are spread: 1 leaves each in its own, 0 takes as many as are best.',
        'いくつの段に分けて並べるか。1 なら今の段のまま、0 ならいちばんよい段数にします。',
      ],
    },
    'space.open': {
      name: ['Sunk by', '沈める深さ'],
      tip: [
        'Each item at least: up to 1 as a share of its height, above 1 in mm.',
        'それぞれ少なくとも：1 までは高さに対する割合、1 より大きい値は mm。',
      ],
    },
    'cut.liner_mm': {
      name: ['Liner', '内張り'],
      tip: [
        'Thickness of a cloth or film between object and foam, on top of the clearance',
        '対象物と緩衝材の間の布やフィルムの厚さ（クリアランスに加わります）',
      ],
    },
    'fit.least_rib_mm': {
      name: ['Least rib', 'リブの最小厚さ'],
      tip: [
        'Foam between two cavities that is thinner than this is cut away. 0: nothing is.',
        'くぼみの間に残る緩衝材（リブ）がこれより薄いときは切り取ります。0 なら切りません。',
      ],
    },
    'fit.settle': {
      name: ['Lower it until it lies on foam', '緩衝材に載るまで下げる'],
      tip: [
        'Foam ends in whole blocks, so things may float above it by almost a block, and fall through that first.',
        '緩衝材はブロック単位で終わるため、対象物が最大でほぼブロック一つ分浮き、落下でまずそこを通ります。',
      ],
    },
    'fit.pads.sheet_mm': {
      name: ['Their sheet', '板の厚さ'],
      tip: ['Thickness of the sheet that pads are stacked from', '重ねて詰め板にする板の厚さ'],
    },
    'fit.pads.squeeze_mm': {
      name: ['They press', '押し込み'],
      tip: [
        'How far pads above press on the object at most. 0: they leave it up to 2 mm',
        '上の詰め板が対象物を押す最大の量。0 なら最大 2 mm のすきまを残します。',
      ],
    },
    'fit.relief.height_mm': {
      name: ['Free height', '島の高さ'],
      tip: ['How high the islands stand free: 70 % of the foam below, or more', '島の周りを空ける高さ。下の緩衝材の 70 % 以上'],
    },
    'fit.relief.island_mm': {
      name: ['Island’s side', '島の幅'],
      tip: ['How wide and long each is at least: 1.33 times its free height', 'それぞれの島の幅と長さの最小。島の高さの 1.33 倍以上'],
    },
    'fit.lift.width_mm': {
      name: ['Width', '幅'],
      tip: ['Along the edge of the piece', '緩衝材の縁に沿った長さ'],
    },
    'fit.lift.depth_mm': {
      name: ['Depth', '奥行き'],
      tip: ['From the edge inwards', '縁から内側へ'],
    },
    'fit.notches.width_mm': {
      name: ['Width', '幅'],
      tip: ['Along the side of the object', '対象物の側面に沿った長さ'],
    },
    'fit.notches.depth_mm': {
      name: ['Depth', '深さ'],
      tip: ['Down from the parting level', '分割の高さから下へ'],
    },
    'fit.notches.room_mm': {
      name: ['Room', '奥行き'],
      tip: ['From the object outwards, for the fingers', '対象物から外へ、指の入る広さ'],
    },
    'fit.notches.axis': {
      name: ['Across', '向き'],
      tip: ['The axis along which the two lie opposite each other', '2つが向かい合う方向'],
      words: {none: ['as it suits', '自動'], y: ['back and front', '奥と手前'], z: ['left and right', '左と右']},
    },
    'fit.notches.first_mm': {
      name: ['Back or left', '奥・左'],
      tip: [
        'The middle of the notch along the object’s side, from the middle of the space',
        '側面に沿った指かけの中心（空間の中心から）',
      ],
    },
    'fit.notches.second_mm': {
      name: ['Front or right', '手前・右'],
      tip: [
        'The middle of the notch along the object’s side, from the middle of the space',
        '側面に沿った指かけの中心（空間の中心から）',
      ],
    },
    'case.inside_mm': {
      name: ['Inside', '内寸'],
      tip: ['Measure your case: sizes differ between makers by some mm', '実際に測ってください。製品によって数 mm 違います。'],
      parts: [['Height inside', '内寸 高さ'], ['Width inside', '内寸 幅'], ['Length inside', '内寸 長さ']],
    },
    'case.lid_mm': {
      name: ['Lid', 'ふた'],
      tip: ['What of the inside height belongs to the lid. 0: not known.', '内寸の高さのうちふたの分。0 なら不明。'],
    },
    'case.play_mm': {
      name: ['Play', '遊び'],
      tip: ['Air between foam and case on each side', '緩衝材とケースの間の余裕（各面）'],
    },
    'case.corner_radius_mm': {
      name: ['Corner radius', '角の半径'],
      tip: ['Of the case’s four upright edges', 'ケースの縦の角の丸み'],
    },
    'workshop.paper': {
      name: ['Paper', '用紙'],
      tip: ['Of the pages that come with the files', 'ファイルに付く印刷物の用紙'],
      words: {a4: ['A4', 'A4'], letter: ['Letter', 'レター'], a3: ['A3', 'A3']},
    },
    'workshop.sponge.maps': {
      name: ['Maps at true size', '原寸図'],
      tip: ['On tiles of the paper, each on one large sheet, or none: the plan alone says all', '用紙に分けて、大きな 1 枚に、または作らない。計画図だけでも作れます。'],
      words: {tiles: ['Tiles', '分割'], plotter: ['One sheet', '1 枚'], none: ['None', 'なし']},
    },
    'workshop.price_per_litre': {
      name: ['Price a litre', 'リットル単価'],
      tip: ['Of the foam as you buy it; 0: the cost is not reckoned', '購入する緩衝材の価格。0 なら費用は計算しません。'],
    },
    'workshop.currency': {
      name: ['Currency', '通貨'],
      tip: ['As it stands behind the price', '価格の後に書く文字'],
    },
    'workshop.mass_kg': {
      name: ['Object weighs', '対象物の重さ'],
      tip: ['For the packing sheet and the pressure on the foam; 0: not known', '梱包票と緩衝材にかかる圧力のため。0 なら不明。'],
    },
    'items.0.fragility_g': {
      name: ['Bears', '耐える衝撃'],
      tip: [
        'The greatest shock in a drop that this one bears, in G. 0: as is chosen for all in step 4.',
        'これだけの、落下で耐えられる最大の衝撃（G）。0 なら手順4で選んだ値。',
      ],
    },
    'workshop.sheets.thickness_mm': {
      name: ['Sheet', 'シート'],
      tip: ['Thickness: a block’s depth, a whole part of it, or a multiple', '厚さ：ブロックの深さ、その整数分の一、または倍数'],
    },
    'workshop.sheets.stock_mm': {
      name: ['Stock', '材料'],
      tip: ['A sheet as it is sold', '販売されているシートの大きさ'],
      parts: [['Stock, long', '材料 長さ'], ['Stock, wide', '材料 幅']],
    },
    'workshop.sheets.kerf_mm': {
      name: ['Kerf', '切り幅'],
      tip: ['Width that a cut takes away; 0 where the cutter makes up for it', '切断で失われる幅。カッターが補正するなら 0。'],
    },
    'workshop.sheets.liner_slit_mm': {
      name: ['Liner’s slit', '内張りの切れ目'],
      tip: [
        'So far from each cavity a slit, not cut through, for the edges of a liner; 10 or more, 0: none',
        '内張りの端を差し込む切れ目（貫通しない）の、くぼみからの距離。10 以上、0 ならなし。',
      ],
    },
    'workshop.sheets.copies': {
      name: ['Copies', '組数'],
      tip: ['So many times the same foam, cut from common stock', '同じ緩衝材を何組作るか。材料はまとめて切り出します'],
    },
    'workshop.sheets.second_color': {
      name: ['Second colour below the uppermost sheet', 'いちばん上のシートの下を二色目にする'],
      tip: ['An empty place is seen at once', '空いている場所がひと目でわかります'],
    },
    'workshop.print.bed_mm': {
      name: ['Bed', 'ベッド'],
      tip: ['What your printer can print at once', 'プリンターが一度に作れる大きさ'],
      parts: [['Bed, right', 'ベッド 横'], ['Bed, back', 'ベッド 奥'], ['Bed, up', 'ベッド 高さ']],
    },
    'workshop.print.dowels': {
      name: ['Dowels where a half is cut apart', '分割した部品をダボでつなぐ'],
      tip: ['Holes in the parts, and loose dowels to print', '部品の穴と、別に作るダボ'],
    },
    'workshop.bricks.unit': {
      name: ['Layers of', '段の高さ'],
      tip: [
        'Bricks are 9.6 mm high, plates a third of that. Bricks where the blocks allow it, if you do not choose.',
        'ブロックは高さ 9.6 mm、プレートはその三分の一。自動なら、できるところはブロックにします。',
      ],
      words: {auto: ['what suits', '自動'], brick: ['bricks', 'ブロック'], plate: ['plates', 'プレート']},
    },
    'workshop.bricks.rim': {
      name: ['Rims meet', '合わせ面'],
      tip: [
        'Studs against studs hold the lid 3.6 mm off; tiles, which have none, close the gap.',
        'ポッチ同士だとふたが 3.6 mm 浮きます。ポッチのないタイルならすきまができません。',
      ],
      words: {studs: ['on studs', 'ポッチ'], tiles: ['on tiles', 'タイル']},
    },
    'workshop.bricks.capacity_n': {
      name: ['A contact holds', '接点の保持力'],
      tip: [
        'Newtons that one contact point of a stud holds, for the check of strength',
        'ポッチの接点ひとつが支える力（強度の確認用、ニュートン）',
      ],
    },
    'workshop.mill.cutter_mm': {
      name: ['Cutter', '刃の直径'],
      tip: ['Diameter of the flat cutter', 'フラットエンドミルの直径'],
    },
    'workshop.mill.flute_mm': {
      name: ['Flute', '刃長'],
      tip: ['How deep the cutter can go', '刃が届く深さ'],
    },
    'workshop.mill.step_down_mm': {
      name: ['Step down', '切込み'],
      tip: ['The most that one pass goes down. 0: half the cutter', '一回に下がる最大の深さ。0 なら直径の半分。'],
    },
    'workshop.mill.stepover': {
      name: ['Stepover', '経路の間隔'],
      tip: ['Between neighbouring paths, of the cutter’s diameter', '隣の経路との間隔（直径に対する割合）'],
    },
    'workshop.mill.feed_mm_min': {
      name: ['Feed', '送り'],
      tip: ['To the side. A cautious start: no table covers soft foams', '横方向。控えめな値から始めています（柔らかい緩衝材の表はありません）。'],
    },
    'workshop.mill.plunge_mm_min': {
      name: ['Plunge', '下向きの送り'],
      tip: ['Downwards', '下方向'],
    },
    'workshop.mill.spindle_rpm': {
      name: ['Spindle', '回転数'],
      tip: ['Turns a minute', '一分間の回転数'],
    },
    'workshop.mill.safe_mm': {
      name: ['Safe height', '安全高さ'],
      tip: ['Of rapid moves above the stock', '早送りで材料の上を通る高さ'],
    },
    'workshop.mill.pin_mm': {
      name: ['Pins', '位置決めピン'],
      tip: ['Diameter of the registration pins. 0: none', '位置決めピンの直径。0 ならなし。'],
    },
    'workshop.mill.origin': {
      name: ['X0 Y0 at', '原点 X0 Y0'],
      tip: ['Where the program starts to count on the stock; Z0 is its top', 'プログラムの原点の材料上の位置。Z0 は材料の上面。'],
      words: {corner: ['corner', '角'], centre: ['centre', '中心']},
    },
    'workshop.mould.wall_mm': {
      name: ['Mould wall', '型の壁'],
      tip: ['Thickness of the box’s walls and floor', '型の壁と底の厚さ'],
    },
    'workshop.mould.rim_mm': {
      name: ['Rim', '縁'],
      tip: ['By which the walls stand above what is poured', '流し込む面より上に立つ壁の高さ'],
    },
    'workshop.mould.draft_deg': {
      name: ['Draft', '抜き勾配'],
      tip: ['Lean of upright faces, so that the foam lets go', '緩衝材が抜けるように立ち面を傾けます'],
    },
  }),
};

// Where the explanation of a control stands: where no eye goes next.

export interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}
interface Size {
  width: number;
  height: number;
}

const GAP = 6;

/** Beside the column that the control is in, or else above the control, below it only at the page's top: fields are
 *  filled from top to bottom. All in px of the page that is seen. */
export function placeTip(control: Box, column: Box | null, tip: Size, page: Size): {left: number; top: number} {
  const within = (value: number, most: number) => Math.max(GAP, Math.min(value, most - GAP));
  const beside = column && [column.right + GAP, column.left - GAP - tip.width].find((left) => left >= GAP && left + tip.width + GAP <= page.width);
  if (beside != null) return {left: beside, top: within(control.top, page.height - tip.height)};
  const above = control.top - GAP - tip.height;
  return {left: within(control.left, page.width - tip.width), top: above >= GAP ? above : control.bottom + GAP};
}

// The time axis below the plots, which all of them share.
import { clear } from "../canvas";
import type { Store } from "../store";
import { colour } from "../theme";
import { timeTicks } from "../ticks";
import { formatNumber } from "../values";
import { axisWidth } from "./body";
import { spaceOnRight } from "./time_plot";

export const timeAxisHeight = 20;

export function drawTimeAxis(store: Store, canvas: HTMLCanvasElement): void {
  const context = canvas.getContext("2d");
  const { clientWidth: width } = canvas;
  if (!context || width === 0) return;
  clear(context, width, timeAxisHeight);
  const [from, to] = store.range;
  const across = width - axisWidth - spaceOnRight(store);
  context.font = "11px system-ui, sans-serif";
  context.fillStyle = colour("dim");
  context.textAlign = "center";
  for (const at of timeTicks(from, to, across)) {
    const x = axisWidth + ((at - from) / (to - from)) * across;
    const text = `${formatNumber(at)} s`;
    const half = context.measureText(text).width / 2;
    context.fillText(text, Math.min(x, width - half - 2), 13);
  }
}

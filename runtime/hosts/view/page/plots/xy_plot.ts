// A plot of signals against another signal.
import { clear } from "../canvas";
import type { Store } from "../store";
import { colour, lineColour } from "../theme";
import { formatNumber } from "../values";
import { axisWidth, type Body } from "./body";
import type { Plot } from "./model";
import { around, splitsOf } from "./scales";
import { Trace } from "./trace";

/** Number of columns to request. Runs with at most this many instants are drawn completely. */
const columns = 4000;
const bottom = 20,
  top = 8,
  right = 18;

interface Axis {
  readonly low: number;
  readonly high: number;
  readonly from: number;
  readonly to: number;
}

/** Time and coordinates. */
type Points = (readonly [number, number, number])[];

const place = ({ low, high, from, to }: Axis, x: number) =>
  from + ((x - low) / (high - low)) * (to - from);

export class XyPlot implements Body {
  readonly element = document.createElement("div");
  readonly traces: readonly Trace[];
  readonly pointed = null;
  private readonly canvas = document.createElement("canvas");
  private readonly still = document.createElement("canvas").getContext("2d");
  private height = 100;
  /** For each signal on the vertical axis, its points with their times, in this run and in the
   * other recording. */
  private points: Points[] = [];
  private others: Points[] = [];

  constructor(
    private readonly store: Store,
    private readonly model: Plot,
    private readonly readOut: () => void,
  ) {
    this.element.className = "plot xy";
    this.element.append(this.canvas);
    this.traces = model.signals.map(
      (number) => new Trace(store, number, `plot ${model.id}`, () => this.show()),
    );
    this.canvas.onclick = (event) => this.goTo(event.offsetX, event.offsetY);
  }

  get picture(): HTMLCanvasElement {
    return this.canvas;
  }

  load(): void {
    for (const trace of this.traces) trace.load(columns);
  }

  grow(): void {
    for (const trace of this.traces) trace.grow(columns);
  }

  private show(): void {
    const [across, ...up] = this.traces;
    if (!across) return;
    const join = (xs: (number | null)[], trace: Trace, ys: (number | null)[]): Points => {
      const times = [...new Set([...across.times, ...trace.times])].sort((a, b) => a - b);
      let i = 0,
        j = 0;
      return times.flatMap((time) => {
        // Both signals keep their values until the next instant.
        while ((across.times[i + 1] ?? Infinity) <= time) i++;
        while ((trace.times[j + 1] ?? Infinity) <= time) j++;
        const x = xs[i],
          y = ys[j];
        return typeof x === "number" && typeof y === "number" ? [[time, x, y] as const] : [];
      });
    };
    this.points = up.map((trace) => join(across.values, trace, trace.values));
    this.others = up.map((trace) => join(across.others, trace, trace.others));
    this.drawStill();
    this.moved();
  }

  private axes(): [Axis, Axis] {
    const { fixed } = this.model;
    const all = [...this.points, ...this.others].flat();
    const [left, most] = around(all.map(([, x]) => x));
    const [low, high] = fixed ?? around(all.map(([, , y]) => y));
    const width = this.element.clientWidth;
    return [
      { low: left, high: most, from: axisWidth, to: width - right },
      { low, high, from: this.height - bottom, to: top },
    ];
  }

  private drawAxes(context: CanvasRenderingContext2D, [x, y]: readonly [Axis, Axis]): void {
    const line = (a: number, b: number, c: number, d: number) => {
      context.beginPath();
      context.moveTo(a, b);
      context.lineTo(c, d);
      context.stroke();
    };
    context.font = "11px system-ui, sans-serif";
    context.strokeStyle = colour("grid");
    context.fillStyle = colour("dim");
    context.lineWidth = 1;
    context.textAlign = "center";
    for (const at of splitsOf(undefined, [x.low, x.high], (x.to - x.from) / 2.7)) {
      const px = Math.round(place(x, at)) + 0.5;
      line(px, y.from, px, y.to);
      context.fillText(formatNumber(at), px, this.height - 5);
    }
    context.textAlign = "right";
    for (const at of splitsOf(undefined, [y.low, y.high], y.from - y.to)) {
      const py = Math.round(place(y, at)) + 0.5;
      line(x.from, py, x.to, py);
      context.fillText(formatNumber(at), x.from - 5, py + 4);
    }
    context.textAlign = "left";
  }

  /** Names the signal on the horizontal axis; the header names the other signals. */
  private drawName(context: CanvasRenderingContext2D, x: Axis): void {
    const [across] = this.traces;
    const { name = "", unit = "" } = across?.signal ?? {};
    const title = name.replace(/^probe\./, "") + (unit === "" ? "" : ` [${unit}]`);
    context.textAlign = "right";
    context.fillStyle = colour("text");
    context.lineWidth = 3;
    context.strokeStyle = colour("panel");
    context.strokeText(`${title} →`, x.to, this.height - bottom - 5);
    context.fillText(`${title} →`, x.to, this.height - bottom - 5);
    context.textAlign = "left";
  }

  private drawStill(): void {
    const { still: context, element, height } = this;
    if (!context || element.clientWidth === 0) return;
    clear(context, element.clientWidth, height);
    const axes = this.axes();
    const [x, y] = axes;
    this.drawAxes(context, axes);
    context.save();
    context.beginPath();
    context.rect(x.from, y.to, x.to - x.from, y.from - y.to);
    context.clip();
    context.lineWidth = 1.5;
    for (const [all, dash] of [
      [this.others, [5, 4]],
      [this.points, []],
    ] as const) {
      context.setLineDash(dash);
      all.forEach((points, i) => {
        context.strokeStyle = lineColour(this.store.colourOf(this.traces[i + 1]?.number ?? 0));
        context.beginPath();
        for (const [, px, py] of points) context.lineTo(place(x, px), place(y, py));
        context.stroke();
      });
    }
    context.restore();
    this.drawName(context, x);
  }

  build(height: number): void {
    this.height = height;
    this.canvas.style.height = `${height}px`;
    this.drawStill();
    this.moved();
  }

  moved(): void {
    const context = this.canvas.getContext("2d");
    const width = this.element.clientWidth;
    this.readOut();
    if (!context || !this.still || width === 0) return;
    clear(context, width, this.height);
    context.drawImage(this.still.canvas, 0, 0, width, this.height);
    const [x, y] = this.axes();
    const { instant, mark } = this.store;
    for (const [at, fill] of [
      [mark, "mark"],
      [instant, "cursor"],
    ] as const) {
      const across = at && this.number(at.cells, 0);
      this.traces.slice(1).forEach((_, i) => {
        const up = at && this.number(at.cells, i + 1);
        if (typeof across !== "number" || typeof up !== "number") return;
        context.beginPath();
        context.arc(place(x, across), place(y, up), 4.5, 0, 2 * Math.PI);
        context.fillStyle = colour(fill);
        context.fill();
      });
    }
  }

  private number(cells: readonly string[], trace: number): number | null {
    const cell = cells[this.traces[trace]?.number ?? -1] ?? "";
    return cell === "" ? null : Number(cell);
  }

  private goTo(px: number, py: number): void {
    const [x, y] = this.axes();
    let best = Infinity,
      to: number | undefined;
    for (const [time, u, v] of this.points.flat()) {
      const apart = Math.hypot(place(x, u) - px, place(y, v) - py);
      if (apart < best) [best, to] = [apart, time];
    }
    if (to !== undefined) this.store.goToTime(to);
  }

  end(): void {
    this.element.remove();
  }
}

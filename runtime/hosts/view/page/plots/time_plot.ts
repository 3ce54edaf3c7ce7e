// A plot of signals over time.
import uPlot from "uplot";
import type { Store } from "../store";
import { colour, lineColour } from "../theme";
import { timeTicks } from "../ticks";
import { axisWidth, rightSpace, type Body, type Pointed } from "./body";
import { Lines } from "./lines";
import { axisOf, type Plot } from "./model";
import { around, isNamed, labels, splitsOf, topOf } from "./scales";
import { startTouch } from "./touch";
import { Trace } from "./trace";

/** Maximum distance, in pixels, from the pointer to an event whose value is shown. */
const close = 5;
const font = "11px system-ui, sans-serif";

/** Returns the space to the right of a plot. It is the same for all plots, so that their time axes
 * are aligned. */
export function spaceOnRight(store: Store): number {
  const hasSecond = store.plots.some(
    ({ signals, isXy }) =>
      !isXy && new Set(signals.map((n) => axisOf(store.program.signals[n]))).size > 1,
  );
  return hasSecond ? axisWidth : rightSpace;
}

export class TimePlot implements Body {
  readonly element = document.createElement("div");
  readonly traces: readonly Trace[];
  private plot: uPlot | null = null;
  private height = 100;
  private data: uPlot.AlignedData = [[], []];
  private readonly lines: Lines;
  /** The keys of the plot's axes, left and right (see `axisOf`). */
  private readonly axes: readonly string[];

  constructor(
    private readonly store: Store,
    private readonly model: Plot,
    private readonly readOut: () => void,
  ) {
    this.element.className = "plot";
    this.element.role = "img";
    this.element.ariaLabel = `Plot of ${model.signals
      .map((number) => store.program.signals[number]?.name ?? "")
      .join(", ")}`;
    this.lines = new Lines(store);
    this.traces = model.signals.map(
      (number) => new Trace(store, number, `plot ${model.id}`, () => this.show()),
    );
    this.axes = [...new Set(this.traces.map(({ signal }) => axisOf(signal)))];
  }

  private get width(): number {
    return Math.max(100, this.element.clientWidth);
  }

  get picture(): HTMLCanvasElement | null {
    return this.plot?.ctx.canvas ?? null;
  }

  load(): void {
    const [min, max] = this.times();
    this.plot?.setScale("x", { min, max });
    for (const trace of this.traces) trace.load(this.width - axisWidth);
  }

  grow(): void {
    for (const trace of this.traces) trace.grow(this.width);
  }

  private join(): uPlot.AlignedData {
    const tables = this.traces.map(
      ({ times, values, others }): uPlot.AlignedData =>
        others.length > 0 ? [times, values, others] : [times, values],
    );
    return tables.length === 1 ? (tables[0] ?? [[], []]) : uPlot.join(tables);
  }

  private show(): void {
    const before = this.data.length;
    this.data = this.join();
    if (!this.plot || before !== this.data.length) this.build(this.height);
    else {
      const [min, max] = this.times();
      this.plot.batch(() => {
        this.plot?.setData(this.data, false);
        this.plot?.setScale("x", { min, max });
      });
    }
    this.moved();
  }

  build(height: number): void {
    const { height: before, width } = this.plot ?? { height: 0, width: 0 };
    this.height = height;
    if (this.plot && this.plot.series.length === this.data.length && !this.isOld) {
      if (before !== height || width !== this.width)
        this.plot.setSize({ width: this.width, height });
    } else {
      this.plot?.destroy();
      this.plot = new uPlot(this.options(), this.data, this.element);
      this.isOld = false;
    }
    this.moved();
  }

  private isOld = false;

  /** Rebuilds the plot the next time it is drawn. */
  forget(): void {
    this.isOld = true;
  }

  /** Returns the visible time range, which is never empty. */
  private times(): [number, number] {
    const [from, to] = this.store.range;
    return [from, Math.max(to, from + 1e-9)];
  }

  private rangeOf(axis: string): [number, number] {
    const traces = this.traces.filter((_, i) => this.axisAt(i) === axis);
    const [first] = traces;
    if (this.model.fixed && axis === this.axes[0]) return [...this.model.fixed];
    if (first && (isNamed(first.signal) || traces.every(({ isEmpty }) => isEmpty)))
      return [-0.15, topOf(first.signal) + 0.15];
    return around(traces.flatMap(({ values, others }) => [...values, ...others]));
  }

  private axisAt(trace: number): string {
    return axisOf(this.traces[trace]?.signal);
  }

  private axis(name: string, side: number): uPlot.Axis {
    const of = this.traces.filter((_, i) => this.axisAt(i) === name);
    const named = of[0] && isNamed(of[0].signal) ? of[0].signal : undefined;
    return {
      scale: side === 3 ? "y" : "y2",
      side,
      stroke: colour("dim"),
      font,
      grid: { show: side === 3, stroke: colour("grid"), width: 1 },
      ticks: { show: false },
      size: axisWidth,
      gap: 4,
      space: 24,
      splits: (plot) =>
        !named && of.every(({ isEmpty }) => isEmpty)
          ? []
          : splitsOf(named, this.rangeOf(name), plot.over.clientHeight || this.height),
      values: (_plot, splits) => labels(named, splits),
    };
  }

  private lineOf(trace: Trace, stroke: string): uPlot.Series {
    const isEvent = trace.signal.kind === "event";
    return {
      scale: axisOf(trace.signal) === this.axes[0] ? "y" : "y2",
      stroke,
      width: 1.5,
      spanGaps: false,
      ...(isEvent
        ? { paths: () => null, points: { show: true, size: 5, fill: stroke } }
        : { paths: uPlot.paths.stepped?.({ align: 1 }) ?? (() => null), points: { show: false } }),
    };
  }

  private series(): uPlot.Series[] {
    return this.traces.flatMap((trace) => {
      const stroke = lineColour(this.store.colourOf(trace.number));
      const isAlone = this.traces.length === 1 && isNamed(trace.signal);
      const line = this.lineOf(trace, stroke);
      return [
        isAlone ? { ...line, fill: `${stroke}22`, fillTo: -0.15 } : line,
        ...(trace.others.length > 0
          ? [
              {
                ...line,
                stroke: this.traces.length === 1 ? colour("text") : stroke,
                dash: [5, 4],
              },
            ]
          : []),
      ];
    });
  }

  private options(): uPlot.Options {
    const [left = "", right] = this.axes;
    const space = spaceOnRight(this.store);
    return {
      width: this.width,
      height: this.height,
      legend: { show: false },
      padding: [6, right === undefined ? space : 0, 4, 0],
      cursor: {
        sync: { key: "frob" },
        drag: { x: true, y: false, setScale: false },
        y: false,
        points: { size: 6 },
      },
      scales: {
        x: { time: false, range: () => this.times() },
        y: { range: () => this.rangeOf(left) },
        ...(right === undefined ? {} : { y2: { range: () => this.rangeOf(right) } }),
      },
      axes: [
        {
          grid: { stroke: colour("grid"), width: 1 },
          ticks: { show: false },
          size: 0,
          splits: (plot) => timeTicks(...this.times(), plot.over.clientWidth || this.width),
          values: (_plot, splits) => splits.map(() => ""),
        },
        this.axis(left, 3),
        ...(right === undefined ? [] : [this.axis(right, 1)]),
      ],
      series: [{}, ...this.series()],
      hooks: {
        draw: [
          (plot) => {
            this.drawBeyond(plot);
            this.lines.move(plot);
          },
        ],
        setCursor: [() => this.readOut()],
        setSelect: [(plot) => this.zoom(plot)],
        ready: [(plot) => this.listen(plot)],
      },
    };
  }

  private listen(plot: uPlot): void {
    const { store } = this;
    this.lines.addTo(plot);
    plot.over.addEventListener("click", (event) => {
      if (plot.select.width > 2) return;
      const seconds = plot.posToVal(event.offsetX, "x");
      store.goToTime(seconds, event.shiftKey ? () => store.setMark(store.instant) : undefined);
    });
    plot.over.addEventListener("dblclick", () => store.showAll());
    startTouch(plot.over, store);
  }

  private zoom(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width <= 2) return;
    const from = plot.posToVal(left, "x"),
      to = plot.posToVal(left + width, "x");
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.store.setRange(from, to);
  }

  moved(): void {
    if (this.plot) this.lines.move(this.plot);
    this.readOut();
  }

  /** Marks each value outside the visible range with a triangle at the edge of the plot. */
  private drawBeyond(plot: uPlot): void {
    const {
      ctx,
      bbox: { top, height },
    } = plot;
    const size = 5 * devicePixelRatio;
    ctx.fillStyle = colour("mark");
    for (const { signal, times, values } of this.traces) {
      const { min, max } = plot.scales[axisOf(signal) === this.axes[0] ? "y" : "y2"] ?? {};
      if (min === undefined || max === undefined) continue;
      values.forEach((value, i) => {
        if (value === null || (value >= min && value <= max)) return;
        const x = plot.valToPos(times[i] ?? 0, "x", true);
        const [base, tip] = value > max ? [top + size, top] : [top + height - size, top + height];
        ctx.beginPath();
        ctx.moveTo(x - size * 0.7, base);
        ctx.lineTo(x + size * 0.7, base);
        ctx.lineTo(x, tip);
        ctx.fill();
      });
    }
  }

  get pointed(): Pointed | null {
    const { plot } = this;
    const { left = -1, idx } = plot?.cursor ?? {};
    if (!plot || left < 0 || typeof idx !== "number") return null;
    const time = plot.posToVal(left, "x");
    const near = plot.posToVal(left + close, "x") - time;
    return {
      time,
      value: (trace) => trace.at(time, near),
      other: (trace) => (trace.others.length > 0 ? trace.at(time, near, trace.others) : null),
    };
  }

  end(): void {
    this.plot?.destroy();
    this.element.remove();
  }
}

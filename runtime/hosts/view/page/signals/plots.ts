// The plots of the chosen signals, one below the other on the same time axis.
import uPlot from "uplot";
import type { Series, Signal } from "../protocol";
import type { Store } from "../store";
import { colour, lineColour, onTheme } from "../theme";
import { difference, formatCell, formatNumber, formatPoint } from "../values";

/** Heights of a plot of truth values or names, and of a plot of numbers, which is lower if there are
 * many plots. */
const lowHeight = 64;
const highHeight = (plots: number) => (plots > 4 ? 92 : 124);
const axisWidth = 72;
/** Maximum number of plots at which there is room for a hint on how to add one. */
const hinted = 3;
/** Practically unlimited, for requests of the newest data. */
const mostPoints = 100_000;

function isLow(signal: Signal): boolean {
  return signal.kind === "bool" || signal.kind === "mode" || signal.kind === "sum";
}

class Strip {
  readonly element = document.createElement("article");
  private readonly value = document.createElement("output");
  private readonly other = document.createElement("output");
  private readonly apart = document.createElement("output");
  private readonly place = document.createElement("div");
  private plot: uPlot | null = null;
  private isEmpty = false;
  private values: (number | null)[] = [];
  private others: (number | null)[] = [];
  private data: uPlot.AlignedData = [[], []];
  private isGrowing = false;

  constructor(
    private readonly store: Store,
    readonly number: number,
    private index: number,
  ) {
    const name = document.createElement("h3");
    name.textContent = this.signal.name;
    const close = document.createElement("button");
    close.textContent = "×";
    close.ariaLabel = `Do not plot ${this.signal.name}`;
    close.onclick = () => store.toggle(number);
    const head = document.createElement("header");
    this.other.className = "other";
    name.title = "Why does it have this value?";
    name.onclick = () => store.wonder(number);
    head.append(name, this.value, this.other, this.apart, close);
    this.place.className = "plot";
    this.element.append(head, this.place);
  }

  private get signal(): Signal {
    const signal = this.store.program.signals[this.number];
    if (!signal) throw new Error("a plot of no signal");
    return signal;
  }

  /** Requests the data for the visible range. */
  load(): void {
    const [from, to] = this.store.range;
    const [min, max] = this.times();
    this.plot?.setScale("x", { min, max });
    this.store.series(this.number, from, to, this.place.clientWidth - axisWidth, (series) =>
      this.show(series),
    );
  }

  private show(series: Series): void {
    const isLate = series.from !== this.store.range[0] || series.to !== this.store.range[1];
    if (isLate && !this.store.following) return;
    this.values = series.values;
    this.others = series.others ?? [];
    this.data = series.others
      ? [series.times, series.values, series.others]
      : [series.times, series.values];
    this.isEmpty = series.values.every((value) => value === null);
    if (this.plot && !this.isEmpty && this.plot.series.length === this.data.length)
      this.plot.setData(this.data, true);
    else this.build();
  }

  /** Requests the data that has arrived since, in a live run that is followed. */
  grow(): void {
    if (this.isGrowing) return;
    const from = this.data[0].at(-1) ?? this.store.range[0];
    this.isGrowing = true;
    this.store.series(this.number, from, this.store.program.end, mostPoints, (series) => {
      this.isGrowing = false;
      if (this.store.following) this.append(series);
    });
  }

  private append(series: Series): void {
    const [from] = this.store.range;
    const last = this.data[0].at(-1) ?? -Infinity;
    const isNew = (_: unknown, i: number) => (series.times[i] ?? 0) > last;
    const times = [...this.data[0], ...series.times.filter(isNew)];
    // Keep one point before the visible range, from which a step leads into it.
    const first = Math.max(0, times.findIndex((time) => time > from) - 1);
    const joined = (before: readonly (number | null)[], more: readonly (number | null)[]) =>
      [...before, ...more.filter(isNew)].slice(first);
    const hasOthers = series.others !== undefined;
    const isOther = hasOthers !== this.others.length > 0;
    this.values = joined(this.values, series.values);
    this.others = hasOthers
      ? joined(isOther ? this.values.map(() => null) : this.others, series.others)
      : [];
    this.data = hasOthers
      ? [times.slice(first), this.values, this.others]
      : [times.slice(first), this.values];
    const wasEmpty = this.isEmpty;
    this.isEmpty = this.values.every((value) => value === null);
    const [min, max] = this.times();
    if (this.plot && wasEmpty === this.isEmpty && !isOther) {
      this.plot.batch(() => {
        this.plot?.setData(this.data, false);
        this.plot?.setScale("x", { min, max });
      });
      this.readOut();
    } else this.build();
  }

  /** Redraws the plot, with another size or other colours. */
  build(index = this.index): void {
    this.index = index;
    this.plot?.destroy();
    this.element.style.setProperty("--line", lineColour(this.index));
    this.plot = new uPlot(this.options(), this.data, this.place);
    this.readOut();
  }

  /** Returns the visible time range, which is never empty. */
  private times(): [number, number] {
    const [from, to] = this.store.range;
    return [from, Math.max(to, from + 1e-9)];
  }

  private options(): uPlot.Options {
    const { signal } = this;
    const isEvent = signal.kind === "event";
    const axis = {
      stroke: colour("dim"),
      font: "11px system-ui, sans-serif",
      grid: { stroke: colour("grid"), width: 1 },
      ticks: { show: false },
    };
    const top = Math.max(1, signal.names.length - 1);
    const low = isLow(signal) || this.isEmpty;
    const drawn = (stroke: string): uPlot.Series => ({
      stroke,
      width: 1.5,
      spanGaps: false,
      ...(isEvent
        ? { paths: () => null, points: { show: true, size: 5, fill: stroke } }
        : { paths: uPlot.paths.stepped?.({ align: 1 }) ?? (() => null), points: { show: false } }),
    });
    return {
      width: Math.max(100, this.place.clientWidth),
      height: low ? lowHeight : highHeight(this.store.plotted.length),
      legend: { show: false },
      padding: [6, 18, 0, 0],
      cursor: {
        sync: { key: "frob" },
        drag: { x: true, y: false, setScale: false },
        y: false,
        points: { size: 6 },
      },
      scales: {
        x: { time: false, range: () => this.times() },
        y: low
          ? { range: [-0.15, top + 0.15] }
          : {
              range: () => around([...this.values, ...this.others]),
            },
      },
      axes: [
        {
          ...axis,
          size: 20,
          gap: 2,
          space: 70,
          values: (_plot, splits) => splits.map((x) => `${formatNumber(x)} s`),
        },
        {
          ...axis,
          size: axisWidth,
          gap: 4,
          space: 24,
          ...(this.isEmpty
            ? { splits: () => [] }
            : low
              ? {
                  splits: () => Array.from({ length: top + 1 }, (_, i) => i),
                  values: (_plot: uPlot, splits: number[]) =>
                    splits.map((x) => shorten(formatPoint(signal, x))),
                }
              : // Omit labels next to the first label of the time axis.
                {
                  values: (plot: uPlot, splits: number[]) => {
                    const { min = 0, max = 1 } = plot.scales["y"] ?? {};
                    return splits.map((x) => (x < min + 0.07 * (max - min) ? "" : formatNumber(x)));
                  },
                }),
        },
      ],
      series: [
        {},
        {
          ...drawn(lineColour(this.index)),
          ...(low ? { fill: `${lineColour(this.index)}22`, fillTo: -0.15 } : {}),
        },
        ...(this.data.length > 2 ? [{ ...drawn(colour("text")), dash: [5, 4] }] : []),
      ],
      hooks: {
        draw: [(plot) => this.drawCursors(plot)],
        setCursor: [() => this.readOut()],
        setSelect: [(plot) => this.zoom(plot)],
        ready: [(plot) => this.listen(plot)],
      },
    };
  }

  private listen(plot: uPlot): void {
    plot.over.addEventListener("click", (event) => {
      if (plot.select.width > 2) return;
      const seconds = plot.posToVal(event.offsetX, "x");
      this.store.goToTime(
        seconds,
        event.shiftKey ? () => this.store.setMark(this.store.instant) : undefined,
      );
    });
    plot.over.addEventListener("dblclick", () => this.store.showAll());
  }

  private zoom(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width <= 2) return;
    const from = plot.posToVal(left, "x"),
      to = plot.posToVal(left + width, "x");
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.store.setRange(from, to);
  }

  redraw(): void {
    this.plot?.redraw(false);
    this.readOut();
  }

  private drawCursors(plot: uPlot): void {
    const draw = (seconds: number, stroke: string, dash: number[]) => {
      const x = Math.round(plot.valToPos(seconds, "x", true)) + 0.5;
      if (x < plot.bbox.left || x > plot.bbox.left + plot.bbox.width) return;
      plot.ctx.save();
      plot.ctx.strokeStyle = stroke;
      plot.ctx.lineWidth = devicePixelRatio * 1.5;
      plot.ctx.setLineDash(dash.map((x) => x * devicePixelRatio));
      plot.ctx.beginPath();
      plot.ctx.moveTo(x, plot.bbox.top);
      plot.ctx.lineTo(x, plot.bbox.top + plot.bbox.height);
      plot.ctx.stroke();
      plot.ctx.restore();
    };
    this.drawBeyond(plot);
    if (this.store.mark) draw(this.store.mark.time, colour("mark"), [4, 3]);
    if (this.store.instant) draw(this.store.instant.time, colour("cursor"), []);
  }

  /** Draws a mark at the edge where a value is outside the visible range. */
  private drawBeyond(plot: uPlot): void {
    const { min, max } = plot.scales["y"] ?? {};
    const {
      ctx,
      bbox: { top, height },
    } = plot;
    if (min === undefined || max === undefined) return;
    const size = 5 * devicePixelRatio;
    ctx.fillStyle = colour("mark");
    this.values.forEach((value, i) => {
      if (value === null || (value >= min && value <= max)) return;
      const x = plot.valToPos(this.data[0][i] ?? 0, "x", true);
      const [base, tip] = value > max ? [top + size, top] : [top + height - size, top + height];
      ctx.beginPath();
      ctx.moveTo(x - size * 0.7, base);
      ctx.lineTo(x + size * 0.7, base);
      ctx.lineTo(x, tip);
      ctx.fill();
    });
  }

  /** Shows the value at the pointer, or else at the current instant. */
  readOut(): void {
    const { signal, store, plot } = this;
    const pointed = plot?.cursor.idx;
    const cell = store.instant?.cells[this.number] ?? "";
    const other = store.instant?.others?.[this.number] ?? cell;
    this.other.textContent = other === cell ? "" : `what if: ${formatCell(signal, other)}`;
    const marked = store.mark?.cells[this.number];
    this.element.classList.toggle("pointed", typeof pointed === "number");
    if (plot && typeof pointed === "number") {
      this.value.textContent = formatPoint(signal, this.heldAt(plot));
      this.apart.textContent = `at ${plot.posToVal(plot.cursor.left ?? 0, "x").toFixed(3)} s`;
      return;
    }
    this.value.textContent = formatCell(signal, cell);
    const apart = marked === undefined ? null : difference(signal, marked, cell);
    this.apart.textContent = apart === null ? "" : `Δ ${apart}`;
  }

  /** Returns the value that the signal has at the pointer: its last value before it; for an event,
   * its value there, if any. */
  private heldAt(plot: uPlot): number | null {
    const seconds = plot.posToVal(plot.cursor.left ?? 0, "x");
    const nearest = plot.cursor.idx ?? 0;
    const held = (this.data[0][nearest] ?? 0) > seconds && nearest > 0 ? nearest - 1 : nearest;
    return this.data[1]?.[this.signal.kind === "event" ? nearest : held] ?? null;
  }

  resize(): void {
    this.plot?.setSize({ width: Math.max(100, this.place.clientWidth), height: this.plot.height });
  }

  end(): void {
    this.plot?.destroy();
    this.element.remove();
  }
}

/**
 * Returns the range of a plot. It ignores a few extreme values, such as the first value of a
 * derivative, which would flatten all others to a line.
 */
function around(values: readonly (number | null)[]): [number, number] {
  const sorted = values.filter((x): x is number => typeof x === "number").sort((a, b) => a - b);
  if (sorted.length === 0) return [0, 1];
  const last = sorted.length - 1;
  const at = (place: number) => sorted[place] ?? 0;
  const out = last < 20 ? 0 : Math.max(1, Math.round(0.003 * last));
  const most = at(last - out) - at(out);
  const isFar = most > 0 && at(last) - at(0) > 10 * most;
  const isNear = (x: number) =>
    !isFar || (x >= at(out) - 1.5 * most && x <= at(last - out) + 1.5 * most);
  const near = sorted.filter(isNear);
  const least = near[0] ?? 0,
    greatest = near[near.length - 1] ?? 0;
  const margin = greatest > least ? (greatest - least) * 0.08 : Math.abs(greatest) * 0.1 || 1;
  return [least - margin, greatest + margin];
}

function shorten(name: string): string {
  return name.length > 11 ? `${name.slice(0, 10)}…` : name;
}

export function startPlots(store: Store, host: HTMLElement): void {
  const strips = new Map<number, Strip>();
  const empty = document.createElement("p");
  empty.className = "empty";
  empty.textContent = "Click a value in the source, or a signal in the list, to plot it.";
  const arrange = () => {
    for (const [number, strip] of strips) {
      if (!store.plotted.includes(number)) {
        strip.end();
        strips.delete(number);
      }
    }
    strips.forEach((strip) => strip.build());
    store.plotted.forEach((number, index) => {
      if (strips.has(number)) return;
      const strip = new Strip(store, number, index);
      strips.set(number, strip);
      host.append(strip.element);
      strip.load();
    });
    host.append(empty);
    empty.hidden = strips.size > hinted;
  };
  const all = (act: (strip: Strip) => void) => () => strips.forEach(act);
  store.on("plotted", arrange);
  store.on(
    "range",
    all((strip) => strip.load()),
  );
  store.on(
    "what-if",
    all((strip) => strip.load()),
  );
  store.on(
    "resumed",
    all((strip) => strip.load()),
  );
  store.on(
    "instant",
    all((strip) => (store.following ? strip.readOut() : strip.redraw())),
  );
  store.on("extent", () => store.following && strips.forEach((strip) => strip.grow()));
  store.on(
    "mark",
    all((strip) => strip.redraw()),
  );
  onTheme(all((strip) => strip.build()));
  new ResizeObserver(all((strip) => strip.resize())).observe(host);
  arrange();
}

// The timeline of the whole run: modes as bands, the cursor, the mark, and the range of the plots.
import { clear } from "../canvas";
import { around } from "../plots/scales";
import { machineName } from "../signals/modes";
import type { Claim, Series } from "../protocol";
import type { Store } from "../store";
import { colour, isDark, modeColour, onTheme } from "../theme";
import { timeTicks } from "../ticks";
import { formatName, formatNumber, formatTime } from "../values";
import { rowsOf } from "./rows";

const bandHeight = 16;
const axisHeight = 20;
/** Maximum distance, in pixels, at which the pointer can grab an end of the plots' range. */
const handle = 6;
/** Maximum number of bands that leaves enough space for the rest of the page. */
const mostBands = () => (innerHeight < 800 ? 4 : 6);
/** Interval, in ms, at which the bands of a live run are requested. */
const bandsEvery = 500;

export function startTimeline(store: Store, host: HTMLElement): void {
  const canvas = host.querySelector("canvas");
  const shown = canvas?.getContext("2d");
  // An offscreen canvas for the parts that do not change between instants: everything except
  // the cursor and the mark.
  const context = document.createElement("canvas").getContext("2d");
  if (!canvas || !shown || !context) return;
  const { program } = store;
  const { signals } = program;
  const span = () => Math.max(program.end - program.start, 1e-9);
  const rows = rowsOf(store.program, mostBands());
  const bands = new Map<number, Series>();
  let width = 0;

  const place = (seconds: number) => ((seconds - program.start) / span()) * width;

  const drawBand = (number: number, series: Series, y: number) => {
    const names = signals[number]?.names ?? [];
    const { start, end } = program;
    const title = machineName(signals[number]);
    for (let i = 0; i < series.times.length; ) {
      const mode = series.values[i] ?? null;
      let next = i + 1;
      while (next < series.times.length && (series.values[next] ?? null) === mode) next++;
      const from = place(series.times[i] ?? start);
      const to = place(next < series.times.length ? (series.times[next] ?? end) : end);
      if (mode !== null) {
        context.fillStyle = `${modeColour(mode)}${isDark() ? "77" : "aa"}`;
        context.fillRect(from, y, Math.max(1, to - from - 0.5), bandHeight - 2);
        const short = formatName(names[mode] ?? "");
        const text = `${title}: ${short}`;
        const fitting = [text, short].find((t) => context.measureText(t).width < to - from - 8);
        context.fillStyle = colour("text");
        if (fitting) context.fillText(fitting, from + 4, y + bandHeight / 2 - 1);
      }
      i = next;
    }
  };

  const drawViolations = ({ times, assumed }: Claim, bottom: number) => {
    for (let i = 0; i < times.length; i += 2) {
      const x = place(times[i] ?? program.start);
      const across = Math.max(2, place(times[i + 1] ?? program.end) - x);
      context.fillStyle = colour(assumed ? "failed" : "violated");
      context.fillRect(x, 0, across, bottom);
      context.fillStyle = colour(assumed ? "mark" : "bad");
      context.fillRect(x, bottom - 3, across, 3);
    }
  };

  /** Marks the collisions of a simulated robot at the top. */
  const drawContacts = () => {
    context.fillStyle = colour("bad");
    for (const [time] of store.contacts) {
      const x = place(time);
      context.beginPath();
      context.moveTo(x - 4, 0);
      context.lineTo(x + 4, 0);
      context.lineTo(x, 7);
      context.fill();
    }
  };

  /** Draws the occurrences of an event. */
  const drawEvents = (series: Series, y: number) => {
    context.fillStyle = colour("accent");
    series.times.forEach((time, i) => {
      if (series.values[i] !== null) context.fillRect(place(time) - 1, y, 2, bandHeight - 3);
    });
  };

  /** Draws the curve of a value. */
  const drawCourse = (series: Series, y: number) => {
    const [low, high] = around(series.values);
    const at = (x: number) =>
      y +
      bandHeight -
      3 -
      ((Math.min(high, Math.max(low, x)) - low) / (high - low)) * (bandHeight - 4);
    context.strokeStyle = colour("accent");
    context.lineWidth = 1;
    context.beginPath();
    series.times.forEach((time, i) => {
      const value = series.values[i];
      if (typeof value === "number") context.lineTo(place(time), at(value));
    });
    context.stroke();
  };

  /** Marks the times at which the other program or recording differs: the mode is different, or the
   * values differ by more than 5 % of their range. */
  const drawDifferences = ({ times, values, others }: Series, kind: string, y: number) => {
    if (!others) return;
    const [low, high] = around([...values, ...others]);
    const much = kind === "line" ? (high - low) / 20 : 0;
    context.fillStyle = colour("mark");
    times.forEach((time, i) => {
      const a = values[i] ?? NaN,
        b = others[i] ?? NaN;
      const differs = Number.isNaN(a) !== Number.isNaN(b) || Math.abs(a - b) > much;
      if (!differs) return;
      const x = place(time);
      context.fillRect(x, y + bandHeight - 4, Math.max(1, place(times[i + 1] ?? time) - x), 2);
    });
  };

  const drawName = (number: number, y: number) => {
    const name = signals[number]?.name.replace(/^(out|probe)\./, "") ?? "";
    context.lineWidth = 3;
    context.strokeStyle = colour("panel");
    context.strokeText(name, 4, y + bandHeight / 2);
    context.lineWidth = 1;
    context.fillStyle = colour("text");
    context.fillText(name, 4, y + bandHeight / 2);
  };

  const drawRows = () =>
    rows.forEach(({ kind, number }, i) => {
      const series = bands.get(number);
      const y = 10 + i * bandHeight;
      if (!series) return;
      drawDifferences(series, kind, y);
      if (kind === "modes") drawBand(number, series, y);
      else {
        if (kind === "events") drawEvents(series, y);
        else drawCourse(series, y);
        drawName(number, y);
      }
    });

  const drawAxis = (y: number) => {
    const { start, end } = program;
    context.fillStyle = colour("dim");
    context.strokeStyle = colour("grid");
    for (const t of timeTicks(start, end, width)) {
      const x = place(t);
      context.beginPath();
      context.moveTo(x, 0);
      context.lineTo(x, y + 4);
      context.stroke();
      const text = `${formatNumber(t)} s`;
      const half = context.measureText(text).width / 2;
      context.fillText(text, Math.min(Math.max(x - half, 2), width - 2 * half - 2), y + 12);
    }
  };

  const drawLine = (seconds: number, stroke: string, dash: number[]) => {
    // Keeps the whole line visible at both ends of the timeline.
    const x = Math.min(Math.max(place(seconds), 6), width - 6);
    shown.strokeStyle = stroke;
    shown.lineWidth = 2;
    shown.setLineDash(dash);
    shown.beginPath();
    shown.moveTo(x, 0);
    shown.lineTo(x, canvas.clientHeight);
    shown.stroke();
    if (dash.length > 0) return;
    shown.fillStyle = stroke;
    shown.beginPath();
    shown.moveTo(x - 6, 0);
    shown.lineTo(x + 6, 0);
    shown.lineTo(x, 8);
    shown.fill();
  };

  const drawStill = () => {
    const height = canvas.clientHeight;
    clear(context, width, height);
    context.font = "11px system-ui, sans-serif";
    context.textBaseline = "middle";
    const bottom = height - axisHeight;
    const { start, end } = program;
    const [from, to] = store.range;
    if (from > start || to < end) {
      context.fillStyle = colour("range");
      context.fillRect(place(from), 0, place(to) - place(from), bottom);
      // Handles for dragging the ends of the range.
      context.fillStyle = colour("accent");
      for (const end of [from, to]) context.fillRect(place(end) - 1.5, 0, 3, bottom);
    }
    context.fillStyle = colour("found");
    for (let i = 0; i < store.spans.length; i += 2) {
      const x = place(store.spans[i] ?? start);
      context.fillRect(x, 0, Math.max(2, place(store.spans[i + 1] ?? end) - x), bottom);
    }
    drawAxis(bottom);
    for (const claim of store.claims) drawViolations(claim, bottom);
    drawRows();
    drawContacts();
  };

  const drawMoving = () => {
    if (width === 0 || canvas.clientHeight === 0) return;
    clear(shown, width, canvas.clientHeight);
    shown.drawImage(context.canvas, 0, 0, width, canvas.clientHeight);
    if (store.mark) drawLine(store.mark.time, colour("mark"), [4, 3]);
    if (store.instant) drawLine(store.instant.time, colour("cursor"), []);
  };

  const draw = () => {
    if (width === 0) return;
    drawStill();
    drawMoving();
  };

  const tell = () => {
    if (!store.instant) return;
    host.ariaValueMax = String(program.instants - 1);
    host.ariaValueNow = String(store.instant.k);
    host.ariaValueText = `instant ${store.instant.k}, ${formatTime(store.instant.time)}`;
    if (store.following) drawStill();
    drawMoving();
  };
  host.ariaValueMin = "0";

  canvas.style.height = `${Math.max(1, rows.length) * bandHeight + 12 + axisHeight}px`;
  const timeAt = (event: PointerEvent) =>
    program.start + (event.offsetX / Math.max(1, width)) * span();
  /** Returns which end of the plots' range is under the pointer: 0, 1, or -1 for none. */
  const endAt = (event: PointerEvent) => {
    const [from, to] = store.range;
    if (from <= program.start && to >= program.end) return -1;
    return [from, to].findIndex((end) => Math.abs(place(end) - event.offsetX) <= handle);
  };
  let held = -1;
  const drag = (event: PointerEvent) => {
    const [from, to] = store.range;
    const at = timeAt(event);
    if (held < 0) store.goToTime(at);
    else if (held === 0 && at < to) store.setRange(at, to);
    else if (held === 1 && at > from) store.setRange(from, at);
  };
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    held = endAt(event);
    if (held < 0) drag(event);
  };
  canvas.onpointermove = (event) => {
    if (canvas.hasPointerCapture(event.pointerId)) drag(event);
    else canvas.classList.toggle("on-end", endAt(event) >= 0);
  };
  let asked = 0;
  let timer = 0;
  const askForBands = () => {
    asked = performance.now();
    clearTimeout(timer);
    timer = 0;
    rows.forEach(({ number }) =>
      store.series.request(
        "band",
        { signal: number, from: program.start, to: program.end, width },
        (series) => {
          bands.set(number, series);
          draw();
        },
      ),
    );
  };
  new ResizeObserver(() => {
    width = host.clientWidth;
    askForBands();
    draw();
  }).observe(host);
  store.on("extent", () => {
    const wait = program.live ? asked + bandsEvery - performance.now() : 0;
    if (wait <= 0) askForBands();
    // Requests the bands once the interval has passed, so that the last instants before a pause are
    // shown, too.
    else if (timer === 0) timer = window.setTimeout(askForBands, wait);
    if (!store.following) draw();
  });
  store.on("what-if", askForBands);
  store.on("instant", tell);
  store.on("mark", drawMoving);
  store.on("range", draw);
  store.on("spans", draw);
  store.on("claims", draw);
  store.on("contacts", draw);
  onTheme(draw);
}

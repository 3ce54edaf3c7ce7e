// Saves a plot as a picture, or its values as a table.
import type { Series } from "../protocol";
import type { Store } from "../store";
import { colour } from "../theme";
import { formatPoint } from "../values";

/** Number of columns to request: large enough that the viewer sends every instant of a range with
 * fewer than 500,000 instants. */
const columns = 100_000;

function save(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name.replace(/[^\w.-]+/g, "_");
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

export interface Title {
  readonly text: string;
  readonly colour: string;
}

/** Saves canvases as one picture, one below the other, with a line of titles above them. */
export function savePicture(
  name: string,
  titles: readonly Title[],
  parts: readonly HTMLCanvasElement[],
): void {
  const ratio = devicePixelRatio,
    head = 26 * ratio;
  const canvas = document.createElement("canvas");
  canvas.width = Math.max(...parts.map(({ width }) => width));
  canvas.height = head + parts.reduce((sum, { height }) => sum + height, 0);
  const context = canvas.getContext("2d");
  if (!context) return;
  context.fillStyle = colour("panel");
  context.fillRect(0, 0, canvas.width, canvas.height);
  context.font = `600 ${13 * ratio}px monospace`;
  let x = 12 * ratio,
    y = head;
  for (const title of titles) {
    context.fillStyle = title.colour;
    context.fillText(title.text, x, 18 * ratio);
    x += context.measureText(title.text).width + 20 * ratio;
  }
  for (const part of parts) {
    context.drawImage(part, 0, y);
    y += part.height;
  }
  canvas.toBlob((content) => content && save(`${name}.png`, content));
}

/** Quotes a CSV cell if necessary, because names of constructors and strings may contain commas. */
function quoted(cell: string): string {
  return /[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell;
}

/** Finds where in the visible range a signal differs most from the other recording. Calls `then`
 * with the time, the largest difference and the root mean square difference, or with null if the
 * signal does not differ. */
export function findLargest(
  store: Store,
  signal: number,
  then: (found: { time: number; largest: number; rms: number } | null) => void,
): void {
  const [from, to] = store.range;
  store.series.request("largest", { signal, from, to, width: columns }, (series) => {
    let best = 0,
      at = 0,
      sum = 0,
      count = 0;
    series.times.forEach((time, i) => {
      const a = series.values[i],
        b = series.others?.[i];
      if (typeof a !== "number" || typeof b !== "number" || time < from) return;
      const apart = Math.abs(a - b);
      sum += apart * apart;
      count++;
      if (apart > best) [best, at] = [apart, time];
    });
    then(best === 0 ? null : { time: at, largest: best, rms: Math.sqrt(sum / count) });
  });
}

/** Saves the values of signals at all instants of the visible range, in this run and in the other
 * recording. */
export function saveTable(store: Store, name: string, signals: readonly number[]): void {
  const [from, to] = store.range;
  const found = new Map<number, Series>();
  const cell = (number: number, value: number | null | undefined) => {
    const signal = store.program.signals[number];
    if (value === null || value === undefined || !signal) return "";
    const isNamed = signal.kind === "bool" || signal.names.length > 0;
    return isNamed ? quoted(signal.names[value] ?? formatPoint(signal, value)) : String(value);
  };
  const write = () => {
    const times = found.get(signals[0] ?? 0)?.times ?? [];
    const hasOthers = (number: number) => found.get(number)?.others !== undefined;
    const head = signals.flatMap((number) => {
      const { name = "", unit = "" } = store.program.signals[number] ?? {};
      const title = unit === "" ? name : `${name} [${unit}]`;
      return [title, ...(hasOthers(number) ? [`${title} of ${store.otherName}`] : [])].map(quoted);
    });
    const rows = times.map((time, i) =>
      [
        String(time),
        ...signals.flatMap((number) => {
          const { values, others } = found.get(number) ?? {};
          return [cell(number, values?.[i]), ...(others ? [cell(number, others[i])] : [])];
        }),
      ].join(","),
    );
    const text = [["time", ...head].join(","), ...rows, ""].join("\n");
    save(`${name}.csv`, new Blob([text], { type: "text/csv" }));
  };
  for (const signal of signals)
    store.series.request("table", { signal, from, to, width: columns }, (series) => {
      found.set(signal, series);
      if (found.size === signals.length) write();
    });
}

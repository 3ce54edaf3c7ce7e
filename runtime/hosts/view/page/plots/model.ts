// The model of the plots: which signals share a plot, and on which scale.
import type { Program, Signal } from "../protocol";

export interface Plot {
  readonly id: number;
  /** The numbers of its signals. In an XY plot the first signal is on the horizontal axis. */
  signals: number[];
  /** The range of the left vertical axis; null for an automatic range. */
  fixed: readonly [number, number] | null;
  isXy: boolean;
}

/** The key of an axis: the unit of its signals, or the names of their values. Signals with the same
 * key share an axis. */
export function axisOf(signal: Signal | undefined): string {
  if (!signal) return "";
  if (signal.kind === "bool") return "Bool";
  return signal.names.length > 0 ? signal.names.join() : signal.unit;
}

/** Maximum number of vertical axes: one on the left and one on the right. */
export const mostAxes = 2;

export function axesOf(signals: readonly number[], program: Program): string[] {
  return [...new Set(signals.map((number) => axisOf(program.signals[number])))];
}

let count = 0;

export function newPlot(signals: number[]): Plot {
  return { id: ++count, signals, fixed: null, isXy: false };
}

// The text that describes plots in addresses: plots are separated by `;`, and their signals by
// `,`. An XY plot starts with `xy:`. A fixed range has the form `@LOW..HIGH`, at the end.

export function spell(plots: readonly Plot[], program: Program): string {
  const name = (number: number) => encodeURIComponent(program.signals[number]?.name ?? "");
  return plots
    .map(
      ({ signals, fixed, isXy }) =>
        (isXy ? "xy:" : "") +
        signals.map(name).join(",") +
        (fixed ? `@${fixed[0]}..${fixed[1]}` : ""),
    )
    .join(";");
}

function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return "";
  }
}

/** Parses the text that describes plots. Ignores signals that the program does not have. */
export function readPlots(text: string, program: Program): Plot[] {
  return text.split(";").flatMap((part) => {
    const [, xy, names = "", low, high] =
      /^(xy:)?([^@]*)(?:@([^@]*?)\.\.([^@]*))?$/.exec(part) ?? [];
    const signals = names
      .split(",")
      .map((name) => program.signals.findIndex((signal) => signal.name === decoded(name)))
      .filter((number) => number >= 0);
    if (signals.length === 0) return [];
    const plot = newPlot([...new Set(signals)]);
    plot.isXy = xy !== undefined && signals.length > 1;
    const range: [number, number] = [Number(low), Number(high)];
    if (low !== undefined && range.every(Number.isFinite) && range[0] < range[1])
      plot.fixed = range;
    return [plot];
  });
}

// The ranges and labels of vertical axes.
import type { Signal } from "../protocol";
import { niceStep } from "../ticks";
import { formatNumber, formatPoint } from "../values";

/** Whether the values of a signal are truth values or names, for which a low plot is
 * sufficient. */
export function isNamed(signal: Signal): boolean {
  return signal.kind === "bool" || signal.kind === "mode" || signal.kind === "sum";
}

/** The largest number that represents a name. */
export function topOf(signal: Signal): number {
  return Math.max(1, signal.names.length - 1);
}

/**
 * Returns the range of a plot. It ignores a few extreme values, such as the first value of a
 * derivative, which would flatten all others to a line.
 */
export function around(values: readonly (number | null)[]): [number, number] {
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
  return name.length > 10 ? `${name.slice(0, 9)}…` : name;
}

/** Returns the values to label on an axis that is `pixels` long: round numbers, or the numbers that
 * represent names. */
export function splitsOf(
  named: Signal | undefined,
  [low, high]: readonly [number, number],
  pixels: number,
): number[] {
  if (named) return Array.from({ length: topOf(named) + 1 }, (_, i) => i);
  const step = niceStep((high - low) / Math.max(1, pixels / 19));
  const first = Math.ceil(low / step - 1e-9),
    last = Math.floor(high / step + 1e-9);
  return Array.from({ length: Math.min(50, Math.max(0, last - first + 1)) }, (_, i) =>
    Number(((first + i) * step).toPrecision(12)),
  );
}

/** Returns the labels for these positions on an axis. */
export function labels(signal: Signal | undefined, splits: readonly number[]): string[] {
  return splits.map((x) =>
    signal && isNamed(signal) ? shorten(formatPoint(signal, x)) : formatNumber(x),
  );
}

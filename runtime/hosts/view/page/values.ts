// Formats values in Frob's syntax, shortened so that they can be read at a glance.
import type { Signal } from "./protocol";

/** Number of digits that are shown for the largest value of a signal. */
const digits = 4;
/** Values below `small` or above `large` are shown with an exponent. */
const small = 1e-4,
  large = 1e7;

function special(x: number): string {
  return Number.isNaN(x) ? "nan" : x > 0 ? "inf" : "-inf";
}

function withExponent(x: number, places: number): string {
  return x
    .toExponential(places)
    .replace(/\.?0+e/, "e")
    .replace("e+", "e");
}

export function formatNumber(x: number): string {
  if (!Number.isFinite(x)) return special(x);
  if (x !== 0 && (Math.abs(x) < small || Math.abs(x) >= large)) return withExponent(x, 4);
  return String(Number(x.toPrecision(6)));
}

/** For a signal: the largest absolute value shown so far, and the number of decimals to show. */
interface Look {
  largest: number;
  decimals: number;
}

const looks = new WeakMap<Signal, Look>();

/** Returns the number of decimals that a number needs, but not more than `most`: 2 for 0.25. */
function decimalsOf(x: number, most: number): number {
  let places = most;
  const text = x.toFixed(most);
  while (places > 0 && text[text.length - 1 - (most - places)] === "0") places--;
  return places;
}

/** Formats a value of a signal. So that the number of decimals does not jump from one instant to
 * the next, a signal keeps the largest number of decimals that any of its values needed, within
 * the limit on the digits of its largest value. Only values far below the largest one are shown
 * with more decimals.
 */
function steady(signal: Signal, x: number): string {
  if (!Number.isFinite(x)) return special(x);
  if (signal.kind === "int") return String(x);
  const look = looks.get(signal) ?? { largest: 0, decimals: 0 };
  looks.set(signal, look);
  look.largest = Math.max(look.largest, Math.abs(x));
  if (look.largest === 0) return "0";
  if (look.largest < small || look.largest >= large) return x === 0 ? "0" : withExponent(x, 3);
  const most = Math.max(0, digits - 1 - Math.floor(Math.log10(look.largest)));
  look.decimals = Math.max(look.decimals, decimalsOf(x, most));
  // A value that is far smaller than the largest one still has three digits.
  const own = x === 0 ? 0 : Math.min(3, 2 - Math.floor(Math.log10(Math.abs(x))));
  const text = x.toFixed(Math.max(Math.min(most, look.decimals), Math.min(own, decimalsOf(x, 3))));
  return /^-0(\.0*)?$/.test(text) ? text.slice(1) : text;
}

const numbers = /-?\d+(\.\d+)?(e[-+]?\d+)?/g;

/** Formats the name of a mode or constructor. The compiler numbers modes with the same name: the
 * second mode `timeOut` is `timeOut.2`. */
export function formatName(name: string): string {
  return name.replace(/\.(\d+)$/, " ($1)");
}

/** Formats a cell of a trace in Frob's syntax. */
export function formatCell(signal: Signal, cell: string): string {
  if (cell === "") return signal.kind === "event" ? "NoEvent" : "";
  if (cell === "true") return "True";
  if (cell === "false") return "False";
  if (signal.names.includes(cell)) return formatName(cell);
  // A digit that is part of a name does not belong to a number.
  return withUnit(
    signal,
    cell.replace(numbers, (digits, _fraction, _exponent, at: number) =>
      /[\w']/.test(cell[at - 1] ?? "") ? digits : steady(signal, Number(digits)),
    ),
  );
}

function withUnit(signal: Signal, text: string): string {
  return signal.unit === "" ? text : `${text}[${signal.unit}]`;
}

/** Removes the unit from a formatted value that is next to another one with the same unit. */
export function withoutUnit(signal: Signal, text: string): string {
  const unit = `[${signal.unit}]`;
  return text.endsWith(unit) ? text.slice(0, -unit.length) : text;
}

/** Formats a number from a signal's plot as the value that it represents. */
export function formatPoint(signal: Signal, x: number | null): string {
  if (x === null) return signal.kind === "event" ? "NoEvent" : "";
  if (signal.kind === "bool") return x === 0 ? "False" : "True";
  const name = signal.names[x];
  return name === undefined ? withUnit(signal, steady(signal, x)) : formatName(name);
}

export function isNothing(signal: Signal, cell: string): boolean {
  return cell === "" || (signal.kind === "bool" && cell === "false");
}

export function formatTime(seconds: number): string {
  return `${seconds.toFixed(3)} s`;
}

/** Returns the difference between two cells of a numeric signal; null if they are not numbers. */
export function difference(signal: Signal, from: string, to: string): string | null {
  if ((signal.kind !== "float" && signal.kind !== "int") || from === "" || to === "") return null;
  const x = Number(to) - Number(from);
  const sign = x < 0 ? "−" : "+";
  return Number.isNaN(x) ? null : sign + withUnit(signal, steady(signal, Math.abs(x)));
}

// Formats values in Frob's syntax, shortened so that they can be read at a glance.
import type { Signal } from "./protocol";

export function formatNumber(x: number): string {
  if (!Number.isFinite(x)) return Number.isNaN(x) ? "nan" : x > 0 ? "inf" : "-inf";
  if (x !== 0 && (Math.abs(x) < 1e-4 || Math.abs(x) >= 1e7))
    return x
      .toExponential(4)
      .replace(/\.?0+e/, "e")
      .replace("e+", "e");
  return String(Number(x.toPrecision(6)));
}

const numbers = /-?\d+(\.\d+)?(e[-+]?\d+)?/g;

/** Formats the cell of a trace in Frob's syntax. */
export function formatCell(signal: Signal, cell: string): string {
  if (cell === "") return signal.kind === "event" ? "NoEvent" : "";
  if (cell === "true") return "True";
  if (cell === "false") return "False";
  // A digit within a name is not part of a number.
  return withUnit(
    signal,
    cell.replace(numbers, (digits, _fraction, _exponent, at: number) =>
      /[\w']/.test(cell[at - 1] ?? "") ? digits : formatNumber(Number(digits)),
    ),
  );
}

function withUnit(signal: Signal, text: string): string {
  return signal.unit === "" ? text : `${text}[${signal.unit}]`;
}

/** Formats a number from a signal's plot as the value that it represents. */
export function formatPoint(signal: Signal, x: number | null): string {
  if (x === null) return signal.kind === "event" ? "NoEvent" : "";
  if (signal.kind === "bool") return x === 0 ? "False" : "True";
  return signal.names[x] ?? withUnit(signal, formatNumber(x));
}

export function isNothing(signal: Signal, cell: string): boolean {
  return cell === "" || (signal.kind === "bool" && cell === "false");
}

export function formatTime(seconds: number): string {
  return `${seconds.toFixed(3)} s`;
}

/** Returns the difference of two cells of a numeric signal; null if they are not numbers. */
export function difference(signal: Signal, from: string, to: string): string | null {
  if ((signal.kind !== "float" && signal.kind !== "int") || from === "" || to === "") return null;
  const x = Number(to) - Number(from);
  const sign = x < 0 ? "−" : "+";
  return Number.isNaN(x) ? null : sign + withUnit(signal, formatNumber(Math.abs(x)));
}

// The rows of the timeline show the modes of state machines. If a program has few state machines,
// the rows also show some of its events and outputs, so that the user can recognize parts of the
// run.
import { grouped } from "../signals/groups";
import { modeSignals } from "../signals/modes";
import type { Program } from "../protocol";

export interface Row {
  readonly kind: "modes" | "events" | "line";
  /** The number of its signal. */
  readonly number: number;
}

/** If the timeline has at least this many rows with modes, it does not show events and
 * outputs. */
const enough = 2;
const mostEvents = 2;
const mostLines = 2;

export function rowsOf(program: Program, most: number): Row[] {
  const groups = grouped(program);
  const all = modeSignals(program);
  const isOwn = (number: number) => groups[number] === "Modes";
  const modes = [...all.filter(isOwn), ...all.filter((number) => !isOwn(number))].slice(0, most);
  const rows = (kind: Row["kind"], numbers: readonly number[]) =>
    numbers.map((number): Row => ({ kind, number }));
  if (modes.length >= enough) return rows("modes", modes);
  const own = program.signals.flatMap((signal, number) =>
    groups[number] === "Output" || groups[number] === "Inside" ? [{ signal, number }] : [],
  );
  const events = own.filter(({ signal }) => signal.kind === "event");
  const lines = own.filter(({ signal }) => signal.side === "output" && signal.kind === "float");
  const numbers = (all: typeof own, count: number) =>
    all.slice(0, count).map(({ number }) => number);
  return [
    ...rows("modes", modes),
    ...rows("line", numbers(lines, mostLines)),
    ...rows("events", numbers(events, mostEvents)),
  ].slice(0, most);
}

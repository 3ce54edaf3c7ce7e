// Divides the list of signals into groups. The program's own signals are first; those of the
// library are last, and folded.
import type { Program, Signal } from "../protocol";
import { modeSignals } from "./modes";

export type GroupName = "Output" | "Modes" | "Inside" | "Constants" | "Input" | "Library";

/** The groups in the order in which the list shows them. */
export const groupNames: readonly GroupName[] = [
  "Output",
  "Modes",
  "Inside",
  "Constants",
  "Input",
  "Library",
];

/** Returns the group of each signal; null if the list does not show it. */
export function grouped(program: Program): (GroupName | null)[] {
  const modes = new Set(modeSignals(program));
  const library = new Set(
    program.sources.filter((source) => source.library).map(({ name }) => name),
  );
  return program.signals.map((signal: Signal, number): GroupName | null => {
    if (signal.side === "output") return "Output";
    if (signal.side === "input") return "Input";
    if (modes.has(number)) return library.has(signal.file) ? "Library" : "Modes";
    if (signal.side === "mode") return null;
    if (library.has(signal.file)) return "Library";
    return signal.fixed && signal.kind !== "event" ? "Constants" : "Inside";
  });
}

// How the list of signals is divided: the program's own signals first, those of the library last
// and folded.
import type { Program, Signal } from "../protocol";
import { modeSignals } from "./modes";

export type GroupName = "Output" | "Modes" | "Inside" | "Constants" | "Input" | "Library";

/** In the order of the list. */
export const groupNames: readonly GroupName[] = [
  "Output",
  "Modes",
  "Inside",
  "Constants",
  "Input",
  "Library",
];

/** Returns the group of each signal; null: the list does not show it. */
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

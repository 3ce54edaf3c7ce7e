// Finds the signals of each source line, and their values at an instant.
import type { Program, Signal } from "../protocol";
import type { Store } from "../store";
import { formatCell } from "../values";

/** The value of one signal, shown at the end of its line. */
export interface Chip {
  readonly number: number;
  readonly name: string;
  readonly value: string;
  /** The edited program's value, if it differs. */
  readonly other: string | null;
  readonly isPlotted: boolean;
}

export interface LineValues {
  readonly chips: readonly Chip[];
  /** Number of signals on the line that are not shown. */
  readonly more: number;
  /** Index of the shown instance of the line's signal function, and the number of instances. */
  readonly instance: number;
  readonly instances: number;
  readonly instanceName: string;
  /** Whether the signal function runs at this instant. */
  readonly runs: boolean;
}

const mostChips = 12;

/** The signals on a line, by instance. */
type Instances = Map<string, number[]>;

export class Lines {
  private readonly files = new Map<string, Map<number, Instances>>();
  /** Maps a line's instances to the index of the chosen one. */
  private readonly chosen = new Map<string, number>();
  /** The signals of each instance. */
  private readonly members = new Map<string, number[]>();

  constructor(private readonly store: Store) {
    store.program.signals.forEach((signal, number) => this.add(signal, number));
  }

  private add(signal: Signal, number: number): void {
    if (signal.file === "") return;
    const lines = this.files.get(signal.file) ?? new Map<number, Instances>();
    const line = lines.get(signal.line) ?? new Map<string, number[]>();
    this.files.set(signal.file, lines.set(signal.line, line));
    line.set(signal.instance, [...(line.get(signal.instance) ?? []), number]);
    this.members.set(signal.instance, [...(this.members.get(signal.instance) ?? []), number]);
  }

  has(file: string): boolean {
    return this.files.has(file);
  }

  /** Returns the number of the first line in a file that has signals, or 1 if there is none. */
  first(file: string): number {
    const lines = [...(this.files.get(file)?.keys() ?? [])];
    return lines.length === 0 ? 1 : Math.min(...lines);
  }

  /** Returns the lines with signals in a range of a file, in order. */
  between(file: string, first: number, last: number): number[] {
    const lines = this.files.get(file);
    const all = Array.from({ length: last - first + 1 }, (_, i) => first + i);
    return lines ? all.filter((line) => lines.has(line)) : [];
  }

  private static key(instances: Instances): string {
    return [...instances.keys()].join(" ");
  }

  /** Shows the next instance of the signal function of this line. */
  next(file: string, line: number): void {
    const instances = this.files.get(file)?.get(line);
    if (!instances) return;
    const key = Lines.key(instances);
    this.chosen.set(key, (this.shown(instances) + 1) % instances.size);
  }

  /** Shows this instance on every line from `first` to `last` that has any of its signals. */
  choose(file: string, first: number, last: number, instance: string): void {
    for (const line of this.between(file, first, last)) {
      const instances = this.files.get(file)?.get(line) ?? new Map<string, number[]>();
      const at = [...instances.keys()].indexOf(instance);
      if (at >= 0) this.chosen.set(Lines.key(instances), at);
    }
  }

  /** Returns whether an instance runs. While it runs, at least one of its signals has a value. An
   * instance that contains only events always counts as running, because events have no value at
   * most instants. */
  private runs(instance: string): boolean {
    const { instant, program } = this.store;
    const members = this.members.get(instance) ?? [];
    const isThere = (number: number) => (instant?.cells[number] ?? "") !== "";
    return (
      members.some(isThere) || members.every((number) => program.signals[number]?.kind === "event")
    );
  }

  /** Returns the index of the chosen instance or, if none was chosen, of the first one that
   * runs. */
  private shown(instances: Instances): number {
    const chosen = this.chosen.get(Lines.key(instances));
    if (chosen !== undefined) return chosen;
    return Math.max(
      0,
      [...instances.keys()].findIndex((name) => this.runs(name)),
    );
  }

  /** Returns as many values on a line as fit into `room` characters, but at least one. */
  values(file: string, line: number, room: number): LineValues | null {
    const instances = this.files.get(file)?.get(line);
    if (!instances) return null;
    const instance = this.shown(instances);
    const [instanceName, numbers] = [...instances][instance] ?? ["", []];
    const { program, instant, plotted } = this.store;
    const chips = numbers.slice(0, mostChips).flatMap((number) => {
      const signal = program.signals[number];
      const cell = instant?.cells[number] ?? "";
      const other = instant?.others?.[number] ?? cell;
      return signal
        ? [
            {
              number,
              name: signal.own,
              value: formatCell(signal, cell),
              other: other === cell ? null : formatCell(signal, other),
              isPlotted: plotted.includes(number),
            },
          ]
        : [];
    });
    const shown = fitting(chips, room - (instances.size > 1 ? instanceName.length + 6 : 0));
    return {
      chips: shown,
      more: numbers.length - shown.length,
      instance,
      instances: instances.size,
      instanceName,
      runs: this.runs(instanceName),
    };
  }
}

function fitting(chips: readonly Chip[], room: number): Chip[] {
  const width = ({ name, value, other }: Chip) =>
    name.length + value.length + (other?.length ?? 0) + 4;
  let used = 0;
  return chips.filter((chip, i) => (used += width(chip)) <= room || i === 0);
}

/** Returns the sources that get a tab: the user's, and those of the library that have signals. */
export function shownSources(program: Program, lines: Lines): Program["sources"] {
  return program.sources.filter((source) => !source.library || lines.has(source.name));
}

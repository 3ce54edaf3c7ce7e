// What the viewer answers; view.h has the requests.

export interface Signal {
  readonly name: string;
  readonly side: "input" | "output" | "mode";
  readonly kind: "bool" | "int" | "float" | "event" | "sum" | "data" | "mode";
  /** What the numbers 0, 1, … of its plot stand for; none if they are numbers. */
  readonly names: readonly string[];
}

export interface Source {
  readonly name: string;
  readonly text: string;
}

export interface Program {
  readonly is: "program";
  readonly name: string;
  readonly robot: string;
  readonly recording: string;
  readonly instants: number;
  readonly start: number;
  readonly end: number;
  /** Whether the program can be run on the recording. */
  readonly runs: boolean;
  readonly notes: string;
  readonly signals: readonly Signal[];
  readonly sources: readonly Source[];
}

export interface Instant {
  readonly is: "instant";
  readonly k: number;
  readonly time: number;
  readonly dt: number;
  /** Of each signal, as the cell of a trace. */
  readonly cells: readonly string[];
}

export interface Series {
  readonly is: "series";
  readonly signal: number;
  readonly from: number;
  readonly to: number;
  readonly times: number[];
  readonly values: (number | null)[];
}

export interface Refused {
  readonly is: "refused";
  readonly why: string;
}

export type Answer = Program | Instant | Series | Refused;

// What the viewer answers; view.h has the requests.

export interface Signal {
  readonly name: string;
  readonly side: "input" | "output" | "probe" | "mode";
  readonly kind: "bool" | "int" | "float" | "event" | "sum" | "data" | "mode";
  /** What the numbers 0, 1, … of its plot stand for; none if they are numbers. */
  readonly names: readonly string[];
  /** As the language writes it, such as `m/s`; empty without one. */
  readonly unit: string;
  /** Of a probe: the instance of a signal function that it is in, its name there, and where
   *  that is written. Else empty. */
  readonly instance: string;
  readonly own: string;
  readonly file: string;
  readonly line: number;
  /** Of the running mode of a machine: how it comes from one to the other. */
  readonly transitions?: readonly Transition[];
}

/** Between modes, by their numbers in `names`; `from` is -1 from any, -2 as the machine
 *  begins. */
export interface Transition {
  readonly from: number;
  readonly to: number;
  /** What it waits for, as far as that is known; or empty. */
  readonly label: string;
  readonly delayed: boolean;
}

/** What the program asks its operator for; requests know it by its place in the list. */
export interface Control {
  readonly kind: "button" | "hold" | "knob" | "toggle" | "map" | "camera";
  readonly label: string;
  /** Of a knob. */
  readonly unit: string;
  readonly least: number;
  readonly most: number;
  /** Where it is before anybody touches it; of a toggle 0 or 1. */
  readonly first: number;
  /** What it is in the program's input. */
  readonly signal: number;
}

/** A number that is fixed when a run starts. */
export interface Param {
  readonly name: string;
  readonly unit: string;
  /** As a setting has it, `0.3[m/s]`: in this run, and by default. */
  readonly value: string;
  readonly first: string;
}

export interface Source {
  readonly name: string;
  readonly library: boolean;
  readonly text: string;
}

export interface Program {
  readonly is: "program";
  readonly name: string;
  readonly robot: string;
  readonly recording: string;
  // These grow while the run goes on.
  instants: number;
  start: number;
  end: number;
  /** Whether it does. */
  live: boolean;
  /** The time to show at first. */
  readonly at: number;
  /** Whether the program can be run on the recording. */
  readonly runs: boolean;
  /** Whether outputs were recorded, so that those of the replay can be compared. */
  readonly compared: boolean;
  /** How many instants it has been run over. */
  readonly replayed: number;
  readonly notes: string;
  /** Whether frames of cameras are among its inputs. */
  readonly sees: boolean;
  readonly signals: readonly Signal[];
  readonly console: readonly Control[];
  readonly params: readonly Param[];
  readonly sources: readonly Source[];
  /** That the robot may have driven in. */
  readonly world: Source | null;
}

/** Comes by itself, while a run goes on, and at its end: what has grown, and the newest instant. */
export interface Live {
  readonly is: "live";
  readonly instants: number;
  readonly start: number;
  readonly end: number;
  readonly live: boolean;
  readonly replayed: number;
  readonly notes: string;
  readonly newest?: Instant;
}

/** Comes by itself: how the run goes on, and what this page may do to it besides stopping it. */
export interface Run {
  readonly is: "run";
  /** Of several pages one does. */
  readonly operates: boolean;
  /** Whether pages may pause it and set its speed; and send events. */
  readonly paces: boolean;
  readonly sends: boolean;
  readonly stopping: boolean;
  readonly paused: boolean;
  readonly speed: number;
}

/** Comes by itself, when the program has been run over the whole recording. */
export interface Progress {
  readonly is: "progress";
  readonly replayed: number;
  readonly notes: string;
}

export interface Instant {
  readonly is: "instant";
  readonly k: number;
  readonly time: number;
  readonly dt: number;
  /** Of each signal, as the cell of a trace. */
  readonly cells: readonly string[];
  /** Of the edited program, if there is one; null: it has no such signal. */
  readonly others?: readonly (string | null)[];
  /** Of each robot of a simulator, where it really is: x, y, heading, and 1 where it touches
   *  something. */
  readonly truth?: readonly (readonly [number, number, number, number])[];
}

export interface Series {
  readonly is: "series";
  readonly signal: number;
  readonly from: number;
  readonly to: number;
  readonly times: number[];
  readonly values: (number | null)[];
  readonly others?: (number | null)[];
}

export interface Path {
  readonly is: "path";
  readonly x: number;
  readonly y: number;
  /** Times and the two signals. */
  readonly points: readonly (readonly [number, number | null, number | null])[];
  /** Of the edited program, where it has driven itself. */
  readonly others?: readonly (readonly [number, number | null, number | null])[];
}

/** Where a robot of a simulator really was: time, x and y. */
export interface Way {
  readonly is: "way";
  readonly robot: number;
  readonly points: readonly (readonly [number, number, number])[];
}

/** What a value was computed of, and when. */
export interface Origin {
  readonly signal: number;
  readonly k: number;
  readonly time: number;
  readonly cell: string;
}

/** Of an equation; an empty file if there is none. */
export interface Place {
  readonly file: string;
  readonly line: number;
  readonly last: number;
}

export interface Switch extends Place {
  readonly from: string;
  readonly to: string;
  readonly label: string;
  readonly k: number;
  readonly time: number;
  readonly sources: readonly Origin[];
}

export interface Why extends Place {
  readonly is: "why";
  readonly k: number;
  readonly signal: number;
  /** The first instant from which on it is so; `longer`: or before that. */
  readonly since: { readonly k: number; readonly time: number; readonly longer: boolean };
  readonly sources: readonly Origin[];
  /** Of the running mode of a machine. */
  readonly switches?: readonly Switch[];
}

export interface Found {
  readonly is: "found";
  /** What is wrong with the condition; then there is nothing else. */
  readonly why?: string;
  readonly count?: number;
  readonly first?: number | null;
  readonly before?: number | null;
  readonly after?: number | null;
  /** From and to, in turn; what holds to the end has no end. */
  readonly spans?: readonly number[];
}

/** What became of an assertion. */
export interface Fate {
  readonly failed: boolean;
  /** It mattered at some instant. */
  readonly asked: boolean;
  readonly open: boolean;
  /** As a summary has it: `violated, first at 3.200 s; in all at 2 instants`. */
  readonly text: string;
}

export interface Claim {
  readonly label: string;
  /** Its name among the columns of a trace. */
  readonly column: string;
  readonly place: string;
  readonly assumed: boolean;
  /** That has its verdict; -1: none. */
  readonly signal: number;
  readonly fate: Fate;
  /** At which it was violated: from and to, in turn; what lasts has no end. */
  readonly times: readonly number[];
  /** Of the edited program, if there is one; null: it has no such assertion. */
  readonly other?: Fate | null;
}

export interface Claims {
  readonly is: "claims";
  readonly all: readonly Claim[];
}

/** An edited program was run on the same inputs, or in the simulator. */
export interface WhatIf {
  readonly is: "what-if";
  /** There is one, and it can be compared. */
  readonly there: boolean;
  /** In the simulator, from the start. */
  readonly drives?: boolean;
  /** Why there is none, as the compiler says it; nothing if none was asked for. */
  readonly why?: string;
  /** Where its outputs are others for the first time; nothing if they never are. */
  readonly first?: number;
  readonly signal?: string;
}

/** What is shown of an image, or what the camera saw last. */
export interface Picture {
  readonly is: "picture";
  /** The instant of which it is. */
  readonly k: number;
  /** Whether the program shows it, or else just its camera has seen it. */
  readonly chosen: boolean;
  /** A frame that the recording names, and does not have; then there is nothing else. */
  readonly lost?: { readonly number: number; readonly k: number; readonly changed: boolean };
  /** The instant at which the program was given the image; nothing if there is none yet. */
  readonly at?: number;
  readonly number?: number;
  readonly width?: number;
  readonly height?: number;
  /** Seconds. */
  readonly age?: number;
  readonly marks?: readonly string[];
  /** The pixels, each the mean of `by` times `by` of the image's; nothing if the page has them. */
  readonly by?: number;
  readonly columns?: number;
  readonly rows?: number;
  readonly grey?: boolean;
  /** Red, green, blue, 255 in turn. */
  readonly data?: Uint8ClampedArray<ArrayBuffer>;
}

export interface Refused {
  readonly is: "refused";
  readonly why: string;
}

export type Answer =
  | Picture
  | Program
  | Progress
  | Live
  | Run
  | Instant
  | Series
  | Path
  | Way
  | Why
  | Found
  | WhatIf
  | Claims
  | Refused;

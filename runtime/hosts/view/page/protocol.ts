// The viewer's answers; view.h describes the requests.
import type { ControlKind } from "./operate/kinds";

export interface Signal {
  readonly name: string;
  readonly side: "input" | "output" | "probe" | "mode";
  readonly kind: "bool" | "int" | "float" | "event" | "sum" | "data" | "mode";
  /** The names that the numbers 0, 1, … of its plot represent; empty if they are plain numbers. */
  readonly names: readonly string[];
  /** The unit in Frob's syntax, such as `m/s`; empty if the signal has none. */
  readonly unit: string;
  /** For a probe: the signal-function instance that contains the probe, the probe's name in that
   * instance, and the file and line where it is defined. Otherwise empty. */
  readonly instance: string;
  readonly own: string;
  readonly file: string;
  readonly line: number;
  /** Whether the signal is independent of all other signals. Such a signal is constant unless it
   * depends on the time or a mode. */
  readonly fixed: boolean;
  /** For the running mode of a machine: the transitions between its modes. */
  readonly transitions?: readonly Transition[];
}

/**
 * A transition between modes, which are given by their numbers in `names`. `from` is -1 for any
 * mode, and -2 for the start of the machine.
 */
export interface Transition {
  readonly from: number;
  readonly to: number;
  /** The event that triggers the transition, if known; otherwise empty. */
  readonly label: string;
  readonly delayed: boolean;
}

/** A control of the program's console; requests identify it by its index in the list. */
export interface Control {
  readonly kind: ControlKind;
  readonly label: string;
  /** The unit and the range of a knob. */
  readonly unit: string;
  readonly least: number;
  readonly most: number;
  /** Its initial value; for a toggle 0 or 1. */
  readonly first: number;
  /** The number of its signal in the program's input. */
  readonly signal: number;
}

/** A parameter, which is fixed when a run starts. */
export interface Param {
  readonly name: string;
  readonly unit: string;
  /** The value in this run and the default, in the form of a setting, such as `0.3[m/s]`. */
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
  // These members grow during a live run.
  instants: number;
  start: number;
  end: number;
  /** Whether the run is live. */
  live: boolean;
  /** The time to show first. */
  readonly at: number;
  /** Whether the program can be run on the recording. */
  readonly runs: boolean;
  /** Whether outputs were recorded, so that those of the replay can be compared. */
  readonly compared: boolean;
  /** Number of instants over which the program has been run. */
  readonly replayed: number;
  readonly notes: string;
  /** Whether its inputs include camera frames. */
  readonly sees: boolean;
  readonly signals: readonly Signal[];
  readonly console: readonly Control[];
  readonly params: readonly Param[];
  readonly sources: readonly Source[];
  /** The world in which the robot drove, if it is known. */
  readonly world: Source | null;
  /** The recording to compare with, if there is one. */
  readonly other?: Other;
  /** The page state saved during an earlier run of this program, as JSON; empty if there is
   * none. */
  readonly kept: string;
}

/**
 * Sent without a request during a live run and at its end: the members that have grown,
 * and the newest instant.
 */
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

/** Sent without a request: the state of the run, and the controls that this page may use besides
    Stop. */
export interface Run {
  readonly is: "run";
  /** If there are several pages, only one of them operates the run. */
  readonly operates: boolean;
  /** Whether pages may pause the run and set its speed, and whether they may send events. */
  readonly paces: boolean;
  readonly sends: boolean;
  readonly stopping: boolean;
  readonly paused: boolean;
  readonly speed: number;
}

/** The viewer's heartbeat, which it sends ten times a second without a request. */
export interface Beat {
  readonly is: "beat";
  /** The viewer's clock, in ms; commands repeat it to show that they are recent. */
  readonly time: number;
  /** For a run that was live when the viewer started: the number of seconds for which its host has
   * been silent, and the state of the run, as reported by the host. */
  readonly silence?: number | null;
  readonly fate?: RunFate;
}

/** `gone` means that the host's process has ended without a report. */
export type RunFate = "goes on" | "stopping" | "at rest" | "told" | "not reached" | "gone";

/** Sent without a request when the program has been run over the whole recording. */
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
  /** The value of each signal, in the form of a trace's cell. */
  readonly cells: readonly string[];
  /** The values in the edited program, if there is one; null for signals that it does not have. */
  readonly others?: readonly (string | null)[];
  /** Input events in the last 0.4 s. For each: the number and the value of its signal, and the
   * first robot's position and heading at that time, either true or from odometry. For records,
   * also the cell. */
  readonly recent: readonly (readonly [
    signal: number,
    value: number,
    x: number | null,
    y: number | null,
    heading: number | null,
    cell?: string,
  ])[];
  /** The true state of each simulated robot: x, y, heading, and 1 if it touches something, else
   * 0. */
  readonly truth?: readonly (readonly [number, number, number, number])[];
  /** The true poses of the simulator's boxes, and then of its balls, in the order of the world
   * file: x, y and heading. */
  readonly objects?: readonly (readonly [number, number, number])[];
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
  /** The instants of the first point and of the last corner. */
  readonly from: number;
  readonly next: number;
  readonly x: number;
  readonly y: number;
  /** Time, and the values of the two signals. */
  readonly points: readonly (readonly [number, number | null, number | null])[];
  /** The same points in the other recording, or in the simulator run of the edited program. */
  readonly others?: readonly (readonly [number, number | null, number | null])[];
}

/** The true path of a simulated robot: time, x and y. */
export interface Way {
  readonly is: "way";
  readonly robot: number;
  readonly from: number;
  readonly next: number;
  readonly points: readonly (readonly [number, number, number])[];
}

/** A value from which another one was computed, and the instant at which it was read. */
export interface Origin {
  readonly signal: number;
  readonly k: number;
  readonly time: number;
  readonly cell: string;
}

/** The place of an equation; `file` is the empty string if there is none. */
export interface Place {
  readonly file: string;
  readonly line: number;
  readonly last: number;
  /** The instance of its signal function, if it is known. */
  readonly instance?: string;
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
  /** The instant from which the signal has had this value. If `longer` is true, it may have had the
   * value even earlier. */
  readonly since: { readonly k: number; readonly time: number; readonly longer: boolean };
  readonly sources: readonly Origin[];
  /** The transitions that led to this value, if the signal is the running mode of a machine. */
  readonly switches?: readonly Switch[];
}

export interface Found {
  readonly is: "found";
  /** The error in the condition, if there is one; then the other members are missing. */
  readonly why?: string;
  readonly count?: number;
  readonly first?: number | null;
  readonly before?: number | null;
  readonly after?: number | null;
  /** Starts and ends alternate. If the last span lasts until the end of the run, its end is
   * missing. */
  readonly spans?: readonly number[];
}

/** The result of an assertion. */
export interface Fate {
  readonly failed: boolean;
  /** Whether there was any instant at which the assertion had to hold. */
  readonly asked: boolean;
  readonly open: boolean;
  /** A summary, such as `violated, first at 3.200 s; in total at 2 instants`. */
  readonly text: string;
}

export interface Claim {
  readonly label: string;
  /** Its column in a trace. */
  readonly column: string;
  readonly place: string;
  readonly assumed: boolean;
  /** The signal that contains its verdict; -1 if there is none. */
  readonly signal: number;
  readonly fate: Fate;
  /** Times at which it was violated. Starts and ends alternate. If the last violation continues,
   * its end is missing. */
  readonly times: readonly number[];
  /** The result in the edited program, if there is one; null if it does not have this assertion. */
  readonly other?: Fate | null;
}

export interface Claims {
  readonly is: "claims";
  readonly all: readonly Claim[];
}

/** How often the first simulated robot came into contact with an object, and the time and position
 * of each contact, for at most 1000 contacts. */
export interface Contacts {
  readonly is: "contacts";
  readonly count: number;
  readonly all: readonly (readonly [time: number, x: number, y: number])[];
}

/** The result of running an edited program on the same inputs, or in the simulator. */
export interface WhatIf {
  readonly is: "what-if";
  /** Whether there is an edited program to compare with. */
  readonly there: boolean;
  /** Whether the edited program drove the simulated robot, from the first instant. */
  readonly drives?: boolean;
  /** If the program could not be compiled or run, the reason, such as the compiler's messages. */
  readonly why?: string;
  /** The first instant at which its outputs differ, and the name of an output that differs; missing
   * if they do not differ. */
  readonly first?: number;
  readonly signal?: string;
}

/** The image that the program shows, or the camera's last image. */
export interface Picture {
  readonly is: "picture";
  /** The instant of the request. */
  readonly k: number;
  /** True if this is the image that the program shows; false if it is the camera's last image. */
  readonly chosen: boolean;
  /** Set if the frame is missing or has changed since it was recorded; then the members below are
   * missing. */
  readonly lost?: { readonly number: number; readonly k: number; readonly changed: boolean };
  /** The instant at which the program received the image; missing if there is no image yet. */
  readonly at?: number;
  readonly number?: number;
  readonly width?: number;
  readonly height?: number;
  /** Age in seconds. */
  readonly age?: number;
  readonly marks?: readonly string[];
  /** The pixels, each the mean of a square of image pixels whose side is `by`; missing if the page
   * already has them. */
  readonly by?: number;
  readonly columns?: number;
  readonly rows?: number;
  readonly grey?: boolean;
  /** Red, green, blue and 255 for each pixel. */
  readonly data?: Uint8ClampedArray<ArrayBuffer>;
}

/** A recording to compare with. */
export interface Other {
  readonly name: string;
  /** Whether the recording is from this version of the program. Only then are its inner signals
   * known. */
  readonly runs: boolean;
  /** The time, in seconds, in this recording that corresponds to time 0 of the displayed
   * recording. */
  readonly shift: number;
  /** Its parameters whose values differ from those of the displayed recording, as NAME=VALUE. */
  readonly set: readonly string[];
  /** The first instant at which the outputs differ, and the name of an output that differs; missing
   * if they do not differ. */
  readonly first?: number;
  readonly signal?: string;
}

/** Reports the new shift of the recording to compare with, or the reason why the shift has not
 * changed. */
export interface Align {
  readonly is: "align";
  readonly why?: string;
  readonly other?: Other;
}

/** Confirms that the viewer has saved the page's state. */
export interface KeepDone {
  readonly is: "keep";
}

export interface Refused {
  readonly is: "refused";
  /** True if the viewer has refused a command rather than a question. */
  readonly command?: boolean;
  readonly why: string;
}

export type Answer =
  | Beat
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
  | Contacts
  | KeepDone
  | Align
  | Refused;

// The common interface of all kinds of plots, and the sizes of their parts.
import type { Trace } from "./trace";

/** Width of an axis on the left or on the right. */
export const axisWidth = 62;
/** Space to the right of a plot that has no axis on that side. */
export const rightSpace = 18;

/** The values of signals at the pointer. */
export interface Pointed {
  readonly time: number;
  value(trace: Trace): number | null;
  /** The value in the other recording; null if there is none. */
  other(trace: Trace): number | null;
}

/** A plot without its header. */
export interface Body {
  readonly element: HTMLElement;
  readonly traces: readonly Trace[];
  /** Requests the data for the visible range. */
  load(): void;
  /** Requests data that has arrived since the last request, if the plot follows a live run. */
  grow(): void;
  /** Draws the plot with a new height, or with new colours. */
  build(height: number): void;
  /** Called when the instant or the mark has changed. */
  moved(): void;
  /** The position of the pointer; null if it is not on the plot. */
  readonly pointed: Pointed | null;
  /** The drawn plot, for saving it as a picture. */
  readonly picture: HTMLCanvasElement | null;
  end(): void;
}

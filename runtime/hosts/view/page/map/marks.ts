// Parses and draws the marks that the program draws at an instant. Each cell of the probe `draw`
// contains one mark, in Frob's syntax.
import type { Signal } from "../protocol";
import { isDark } from "../theme";
import { formatNumber } from "../values";
import type { Point } from "./world";

export type Shape =
  | { readonly is: "line" | "arrow"; readonly from: Point; readonly to: Point }
  | { readonly is: "circle"; readonly middle: Point; readonly radius: number }
  | { readonly is: "box"; readonly corners: readonly Point[] }
  | { readonly is: "cross"; readonly at: Point }
  | { readonly is: "label"; readonly at: Point; readonly text: string };

export interface Mark {
  readonly frame: "world" | "robot" | "image";
  readonly colour: string;
  readonly shape: Shape;
}

export interface Reading {
  readonly name: string;
  readonly value: string;
}

// A value in Frob's syntax: a number, a string, or a constructor with its arguments or fields.
type Value = number | string | { readonly name: string; readonly parts: readonly Value[] };

const token = /\s*("(?:[^"\\]|\\.)*"|[A-Z][\w']*|[a-z_][\w']*|-?(?:\d[\w.+-]*|inf|nan)|[(){}=,])/y;

function tokens(cell: string): string[] {
  const found: string[] = [];
  token.lastIndex = 0;
  for (let match = token.exec(cell); match; match = token.exec(cell)) found.push(match[1] ?? "");
  return found;
}

function number(word: string): number {
  if (word === "inf") return Infinity;
  return word === "-inf" ? -Infinity : Number(word);
}

const escapes: Readonly<Record<string, string>> = { n: "\n", t: "\t" };

class Reader {
  private at = 0;
  constructor(private readonly words: readonly string[]) {}

  private take(): string {
    return this.words[this.at++] ?? "";
  }

  whole(): Value {
    const next = this.words[this.at] ?? "";
    if (!/^[A-Z]/.test(next) || this.words[this.at + 1] === "{") return this.part();
    this.at++;
    const parts: Value[] = [];
    while (this.at < this.words.length && !")},".includes(this.words[this.at] ?? ""))
      parts.push(this.part());
    return { name: next, parts };
  }

  private part(): Value {
    const word = this.take();
    if (word === "(") {
      const value = this.whole();
      this.take();
      return value;
    }
    if (word.startsWith('"'))
      return word.slice(1, -1).replace(/\\(.)/g, (_, c: string) => escapes[c] ?? c);
    if (!/^[A-Z]/.test(word)) return number(word);
    const parts: Value[] = [];
    if (this.words[this.at] === "{")
      for (this.at++; this.at < this.words.length; ) {
        this.at += 2; // skips the field's name and the equals sign, because fields are in order
        parts.push(this.whole());
        if (this.take() === "}") break;
      }
    return { name: word, parts };
  }
}

function parts(value: Value | undefined): readonly Value[] {
  return typeof value === "object" ? value.parts : [];
}

function real(value: Value | undefined): number {
  return typeof value === "number" ? value : NaN;
}

function point(value: Value | undefined): Point {
  const [x, y] = parts(value);
  return [real(x), real(y)];
}

function box([x, y]: Point, heading: number, length: number, width: number): Point[] {
  const cos = Math.cos(heading),
    sin = Math.sin(heading);
  const corner = (along: number, across: number): Point => [
    x + along * length * cos - across * width * sin,
    y + along * length * sin + across * width * cos,
  ];
  return [corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
}

function shape(value: Value | undefined): Shape | null {
  if (typeof value !== "object") return null;
  const [a, b, c, d] = value.parts;
  switch (value.name) {
    case "Line":
      return { is: "line", from: point(a), to: point(b) };
    case "Arrow":
      return { is: "arrow", from: point(a), to: point(b) };
    case "Circle":
      return { is: "circle", middle: point(a), radius: real(b) };
    case "Box":
      return { is: "box", corners: box(point(a), real(b), real(c), real(d)) };
    case "Cross":
      return { is: "cross", at: point(a) };
    case "Label":
      return { is: "label", at: point(a), text: typeof b === "string" ? b : "" };
    default:
      return null;
  }
}

/** Returns points of the shape that determine its bounding box. */
export function points(shape: Shape): readonly Point[] {
  switch (shape.is) {
    case "line":
    case "arrow":
      return [shape.from, shape.to];
    case "circle":
      return [
        [shape.middle[0] - shape.radius, shape.middle[1] - shape.radius],
        [shape.middle[0] + shape.radius, shape.middle[1] + shape.radius],
      ];
    case "box":
      return shape.corners;
    case "cross":
    case "label":
      return [shape.at];
  }
}

/** Returns the shape with its points moved. Angles and lengths do not change. */
export function moved(shape: Shape, move: (p: Point) => Point): Shape {
  switch (shape.is) {
    case "line":
    case "arrow":
      return { ...shape, from: move(shape.from), to: move(shape.to) };
    case "circle":
      return { ...shape, middle: move(shape.middle) };
    case "box":
      return { ...shape, corners: shape.corners.map(move) };
    case "cross":
    case "label":
      return { ...shape, at: move(shape.at) };
  }
}

/** Returns the numbers of the signals that contain marks. */
export function markSignals(signals: readonly Signal[]): number[] {
  return signals.flatMap((signal, i) =>
    /^probe\.draw(\.\d+)?\[\d+\]$/.test(signal.name) ? [i] : [],
  );
}

const frames: Readonly<Record<string, Mark["frame"]>> = {
  InWorld: "world",
  OnRobot: "robot",
  InImage: "image",
};

/** Parses the cells; ignores shapes whose coordinates are not finite. */
export function readMarks(cells: readonly string[]): { marks: Mark[]; readings: Reading[] } {
  const marks: Mark[] = [],
    readings: Reading[] = [];
  for (const cell of cells) {
    if (cell === "") continue;
    const value = new Reader(tokens(cell)).whole();
    const [a, b, c] = parts(value);
    if (typeof value !== "object") continue;
    if (value.name === "Reading") {
      const unit = typeof c === "string" && c !== "" ? `[${c}]` : "";
      readings.push({ name: String(a), value: formatNumber(real(b)) + unit });
      continue;
    }
    const drawn = shape(b);
    if (drawn && typeof a === "object" && points(drawn).flat().every(Number.isFinite))
      marks.push({ frame: frames[value.name] ?? "world", colour: a.name, shape: drawn });
  }
  return { marks, readings };
}

// The Okabe-Ito palette, adapted to light and dark backgrounds.
const colours: Readonly<Record<string, readonly [string, string]>> = {
  Red: ["#d03b00", "#ff7043"],
  Orange: ["#c98500", "#e69f00"],
  Yellow: ["#a39200", "#f0e442"],
  Green: ["#009e73", "#00c08b"],
  Blue: ["#0072b2", "#56b4e9"],
  Purple: ["#b0558a", "#e69ac4"],
  Grey: ["#6b7280", "#9aa3af"],
};

/** Draws a shape in pixels, on the map or on an image. On an image it has dark edges, so that it is
 * visible on any background. */
export function drawShape(
  context: CanvasRenderingContext2D,
  shape: Shape,
  name: string,
  toPixel: (p: Point) => Point,
  scale: number,
  on: "map" | "image" = "map",
): void {
  const isOnImage = on === "image";
  const tint = colours[name]?.[isDark() || isOnImage ? 1 : 0] ?? "gray";
  const stroke = (width: number) => {
    if (isOnImage) {
      context.strokeStyle = "#000a";
      context.lineWidth = width + 2.5;
      context.stroke();
    }
    context.strokeStyle = tint;
    context.lineWidth = width;
    context.stroke();
  };
  context.fillStyle = tint;
  context.beginPath();
  const [first, second] = points(shape).map(toPixel);
  if (!first) return;
  const [x, y] = first;
  switch (shape.is) {
    case "arrow":
    case "line": {
      const [u, v] = second ?? first;
      context.moveTo(x, y);
      context.lineTo(u, v);
      if (shape.is === "arrow") {
        const angle = Math.atan2(v - y, u - x);
        for (const side of [-1, 1]) {
          context.moveTo(u, v);
          context.lineTo(
            u - 9 * Math.cos(angle + side * 0.45),
            v - 9 * Math.sin(angle + side * 0.45),
          );
        }
      }
      break;
    }
    case "circle":
      context.arc(...toPixel(shape.middle), Math.abs(shape.radius) * scale, 0, 2 * Math.PI);
      break;
    case "box":
      for (const corner of shape.corners) context.lineTo(...toPixel(corner));
      context.closePath();
      break;
    case "cross":
      context.moveTo(x - 5, y - 5);
      context.lineTo(x + 5, y + 5);
      context.moveTo(x - 5, y + 5);
      context.lineTo(x + 5, y - 5);
      break;
    case "label":
      context.font = `${isOnImage ? "600 13px" : "12px"} system-ui, sans-serif`;
      if (isOnImage) {
        context.strokeStyle = "#000a";
        context.lineWidth = 3;
        context.strokeText(shape.text, x + 6, y - 6);
      }
      context.fillText(shape.text, x + 6, y - 6);
      return;
  }
  stroke(2);
}

/** Adds the list of readings to the map. Returns the function that updates it. */
export function readingsList(host: HTMLElement): (readings: readonly Reading[]) => void {
  const list = document.createElement("dl");
  list.id = "readings";
  host.append(list);
  return (readings) => {
    list.hidden = readings.length === 0;
    list.replaceChildren(
      ...readings.flatMap(({ name, value }) => {
        const term = document.createElement("dt"),
          number = document.createElement("dd");
        term.textContent = name;
        number.textContent = value;
        return [term, number];
      }),
    );
  };
}

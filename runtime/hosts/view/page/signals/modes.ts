// Shows the modes of a machine as a state diagram with the running mode highlighted. A click on a
// mode moves to the next instant at which it begins.
import type { Program, Signal, Transition } from "../protocol";
import type { Store } from "../store";
import { modeColour, onTheme } from "../theme";
import { formatName } from "../values";

const any = -1;
const before = -2;

/**
 * Returns the signals that contain the running modes: the inner signals with known transitions or
 * the modes that the host reports, whichever are more numerous.
 */
export function modeSignals({ signals }: Program): number[] {
  const numbers = signals.map((_, number) => number);
  const inside = numbers.filter((number) => signals[number]?.transitions);
  const known = numbers.filter((number) => signals[number]?.side === "mode");
  return inside.length >= known.length ? inside : known;
}

/** Returns the name of a machine. */
export function machineName(signal: Signal | undefined): string {
  return (signal?.name ?? "").replace(/^(mode|probe)\./, "").replace(/\.mode$/, "");
}

/** Orders the modes by a depth-first search from the initial mode, followed by any other modes. */
function inOrder(signal: Signal, transitions: readonly Transition[]): number[] {
  const order: number[] = [];
  const visit = (from: number) => {
    const next = transitions.filter((t) => t.from === from && !order.includes(t.to));
    for (const { to } of next) {
      if (order.includes(to)) continue;
      order.push(to);
      visit(to);
    }
  };
  visit(before);
  signal.names.forEach((_, mode) => {
    if (!order.includes(mode)) order.push(mode);
  });
  return order;
}

// The modes are arranged in a column. A transition to the next mode is a short line between them, a
// transition further down is a curve on the right, and one further up a curve on the left.

/** Distance between the modes, and their height. On a phone, the modes are large enough to tap. */
const narrow = matchMedia("(max-width: 820px)");
const step = () => (narrow.matches ? 52 : 27);
const height = () => (narrow.matches ? 44 : 20);
/** Minimum width for showing the events next to the modes, in pixels. */
const leastNote = 48;
const lane = 9;
const head = 4;

interface Edge {
  readonly from: number;
  readonly to: number;
  readonly lane: number;
}

/** Computes the edges from the positions of their ends. Each edge gets the first lane that is free
 * along its length. */
function edges(
  transitions: readonly Transition[],
  order: readonly number[],
  isDown: boolean,
): Edge[] {
  const places = transitions
    .filter(({ from }) => from >= 0)
    .map(({ from, to }) => ({ from: order.indexOf(from), to: order.indexOf(to) }))
    .filter(({ from, to }) => (isDown ? to > from + 1 : to <= from))
    .filter((a, i, all) => all.findIndex((b) => b.from === a.from && b.to === a.to) === i)
    .sort((a, b) => Math.abs(a.to - a.from) - Math.abs(b.to - b.from));
  const found: Edge[] = [];
  for (const { from, to } of places) {
    const touches = (e: Edge) =>
      Math.min(e.from, e.to) <= Math.max(from, to) && Math.max(e.from, e.to) >= Math.min(from, to);
    let free = 0;
    while (found.some((e) => e.lane === free && touches(e))) free++;
    found.push({ from, to, lane: free });
  }
  return found;
}

function path(d: string, className: string): SVGPathElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", "path");
  made.setAttribute("d", d);
  made.setAttribute("class", className);
  return made;
}

class Diagram {
  readonly element = document.createElement("div");
  private readonly drawing = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  private readonly order: number[];
  private readonly pills = new Map<number, HTMLButtonElement>();
  private readonly down: Edge[];
  private readonly up: Edge[];
  private readonly transitions: readonly Transition[];

  constructor(
    private readonly store: Store,
    private readonly signal: Signal,
    private readonly number: number,
  ) {
    this.transitions = signal.transitions ?? [];
    this.order = inOrder(signal, this.transitions);
    this.down = edges(this.transitions, this.order, true);
    this.up = edges(this.transitions, this.order, false);
    this.element.className = "modes";
    this.element.append(this.drawing);
    for (const mode of this.order) this.element.append(this.row(mode));
    this.element.style.paddingLeft = `${this.margin(this.up) + 12}px`;
    this.colour();
    onTheme(() => this.colour());
    store.on("instant", () => this.light());
    narrow.addEventListener("change", () => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.element);
  }

  private margin(all: readonly Edge[]): number {
    return all.reduce((most, { lane: at }) => Math.max(most, at + 1), 0) * lane + 6;
  }

  private row(mode: number): HTMLElement {
    const name = this.signal.names[mode] ?? "";
    const row = document.createElement("div");
    const pill = document.createElement("button");
    pill.textContent = formatName(name);
    pill.onclick = () =>
      this.store.find(`${this.signal.name} == ${name}`, (found) => {
        const to = found.after ?? found.first;
        if (to !== null && to !== undefined) this.store.goTo(to);
      });
    this.pills.set(mode, pill);
    const waits = [
      ...new Set(
        this.transitions
          .filter(({ from, label }) => from === mode && label !== "")
          .map(({ label }) => label),
      ),
    ];
    const ends = waits.length > 0 ? `; it ends with ${waits.join(" or ")}` : "";
    const numbered = formatName(name) === name ? "" : ` (in a condition: ${name})`;
    pill.title = `Go to the next start of ${formatName(name)}${numbered}${ends}`;
    const note = document.createElement("small");
    note.textContent = waits.join(", ");
    note.title = waits.length > 0 ? `Events that end this mode: ${waits.join(", ")}` : "";
    row.append(pill, note);
    return row;
  }

  private colour(): void {
    this.pills.forEach((pill, mode) => pill.style.setProperty("--line", modeColour(mode)));
  }

  private light(): void {
    const running = this.store.instant?.cells[this.number];
    this.pills.forEach((pill, mode) =>
      pill.classList.toggle("running", this.signal.names[mode] === running),
    );
  }

  private middle(place: number): number {
    return place * step() + height() / 2 + 2;
  }

  private draw(): void {
    const { clientWidth: width } = this.element;
    if (width === 0) return;
    const left = parseFloat(this.element.style.paddingLeft);
    const pill = (place: number) => this.pills.get(this.order[place] ?? 0);
    // Lines and events are next to the modes, so that they do not cross any mode.
    const most = width - this.margin(this.down) - left - 8;
    for (const pill of this.pills.values()) pill.style.maxWidth = `${Math.max(30, most)}px`;
    const right = (place: number) =>
      Math.min(left + (pill(place)?.offsetWidth ?? 0), width - this.margin(this.down));
    const outer = Math.max(...this.order.map((_, place) => right(place))) + 4;
    const beside = outer + this.margin(this.down) + 4;
    for (const note of this.element.querySelectorAll("small")) {
      note.style.left = `${beside}px`;
      note.hidden = beside > width - leastNote;
    }
    const tip = (x: number, y: number, dx: number, dy: number) =>
      dx !== 0
        ? `M${x + dx * head},${y - head}L${x},${y}L${x + dx * head},${y + head}`
        : `M${x - head},${y + dy * head}L${x},${y}L${x + head},${y + dy * head}`;
    const all: SVGPathElement[] = [];
    const draw = (line: string, arrow: string) => all.push(path(line, "edge"), path(arrow, "edge"));
    for (const { from, to } of this.transitions) {
      const a = this.order.indexOf(from),
        b = this.order.indexOf(to);
      if (from >= 0 && b === a + 1) {
        const x = left + 14,
          y = this.middle(b) - height() / 2 - 1;
        draw(`M${x},${this.middle(a) + height() / 2}V${y}`, tip(x, y, 0, -1));
      } else if (from === before || from === any) {
        const x = left - 1,
          y = this.middle(b) + (from === any ? 5 : -4);
        draw(`M${x - 9},${y}H${x}`, tip(x, y, -1, 0));
        if (from === before) all.push(path(`M${x - 9},${y}h0`, "start"));
      }
    }
    for (const { from, to, lane: at } of this.down) {
      const x = outer + (at + 1) * lane,
        a = this.middle(from) + 3,
        b = this.middle(to) - 3;
      const end = right(to) + 1;
      const start = `M${right(from)},${a}H${x - 4}Q${x},${a} ${x},${a + 4}`;
      draw(`${start}V${b - 4}Q${x},${b} ${x - 4},${b}H${end}`, tip(end, b, 1, 0));
    }
    for (const { from, to, lane: at } of this.up) {
      const x = left - 6 - (at + 1) * lane,
        a = this.middle(from) - 3,
        b = this.middle(to) + 4;
      const end = left - 1;
      if (from === to) {
        const c = a + 7;
        const start = `M${left},${a}H${x + 3}Q${x},${a} ${x},${a + 3}`;
        draw(`${start}V${c - 3}Q${x},${c} ${x + 3},${c}H${end}`, tip(end, c, -1, 0));
      } else {
        const start = `M${left},${a}H${x + 4}Q${x},${a} ${x},${a - 4}`;
        draw(`${start}V${b + 4}Q${x},${b} ${x + 4},${b}H${end}`, tip(end, b, -1, 0));
      }
    }
    this.drawing.replaceChildren(...all);
  }
}

export function modesOf(store: Store, signal: Signal, number: number): HTMLElement {
  return new Diagram(store, signal, number).element;
}

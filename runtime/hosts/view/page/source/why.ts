// Explains a value: shows its equation and the values that it reads. The user can click each of
// these to have it explained, too.
import type { Origin, Place, Signal, Switch, Why } from "../protocol";
import type { Store } from "../store";
import { formatCell, formatTime } from "../values";

/** Maximum number of lines to show for an equation. */
const mostLines = 8;

interface Asked {
  readonly signal: number;
  readonly k: number;
}

function button(text: string, title: string, act: () => void): HTMLButtonElement {
  const made = document.createElement("button");
  made.textContent = text;
  made.title = title;
  made.onclick = act;
  return made;
}

function span(className: string, text: string): HTMLElement {
  const made = document.createElement("span");
  made.className = className;
  made.textContent = text;
  return made;
}

export class WhyPanel {
  /** The button that opens and closes the panel. */
  readonly button: HTMLButtonElement;
  readonly element = document.createElement("section");
  /** The signals and instants explained so far. The panel shows the last one. */
  private way: Asked[] = [];
  /** Whether the cursor is moving to the instant of the last step. */
  private isMoving = false;

  constructor(private readonly store: Store) {
    this.button = button("Why?", "Where a value came from (w)", () => this.toggle());
    this.button.id = "why";
    this.element.className = "why";
    this.element.hidden = true;
    this.element.ariaLabel = "Why";
    store.beginAsking = () => this.begin();
    store.on("why", () => this.answered());
    store.on("instant", () => this.follow());
  }

  toggle(): void {
    const [first] = this.store.plotted;
    if (this.store.asker) this.end();
    else if (first !== undefined) this.store.wonder(first);
    else this.begin();
  }

  private begin(): void {
    const { store } = this;
    document.querySelector<HTMLButtonElement>("#panels [data-panel=source]")?.click();
    store.asker = (signal) => this.step(signal, store.instant?.k ?? 0);
    this.render();
    store.changed("why");
  }

  end(): void {
    this.way = [];
    this.store.asker = null;
    this.store.why = null;
    this.render();
    this.store.show(null);
    this.store.changed("why");
  }

  /** Goes one step further back. */
  private step(signal: number, k: number): void {
    this.way.push({ signal, k });
    this.load();
  }

  back(): void {
    if (this.way.length < 2) return;
    this.way.pop();
    this.load();
  }

  private load(): void {
    const last = this.way.at(-1);
    if (!last) return;
    this.isMoving = true;
    this.store.goTo(last.k, () => {
      this.isMoving = false;
    });
    this.store.askWhy(last.signal, last.k);
  }

  /** If the cursor was moved by other means, explains the same signal at the new instant. */
  private follow(): void {
    const last = this.way.at(-1);
    const k = this.store.instant?.k;
    if (!last || this.isMoving || k === undefined || k === last.k) return;
    this.way[this.way.length - 1] = { signal: last.signal, k };
    this.store.askWhy(last.signal, k);
  }

  private answered(): void {
    const { why } = this.store;
    const last = this.way.at(-1);
    if (!why || why.signal !== last?.signal || why.k !== last.k) return;
    this.render();
    const { instance } = this.signal(why.signal);
    this.store.show(why.file === "" ? null : { ...why, instance });
  }

  private signal(number: number): Signal {
    const signal = this.store.program.signals[number];
    if (!signal) throw new Error("the signal to explain does not exist");
    return signal;
  }

  private render(): void {
    const { store, way } = this;
    const { why } = store;
    const isAsking = store.asker !== null;
    this.button.ariaPressed = String(isAsking);
    this.element.hidden = !isAsking;
    const back = button("‹ Back", "One step back (Backspace)", () => this.back());
    back.disabled = way.length < 2;
    const close = button("×", "Close (w)", () => this.end());
    close.ariaLabel = "Close";
    const head = document.createElement("header");
    head.append(back);
    this.element.replaceChildren(head);
    if (!why) {
      head.append(
        span(
          "hint",
          "Click a value or a signal to see where it came from; close this panel to plot signals again.",
        ),
        close,
      );
      return;
    }
    const signal = this.signal(why.signal);
    const cell = store.instant?.k === why.k ? (store.instant.cells[why.signal] ?? "") : "";
    const value = span("value", `= ${formatCell(signal, cell) || "–"}`);
    head.append(span("name", plainName(signal)), value, this.since(why), close);
    this.element.append(...this.equation(why), this.sources(why.sources, signal, why.k));
    for (const change of why.switches ?? []) this.element.append(this.switched(change, signal));
    if (why.sources.length === 0 && (why.switches ?? []).length === 0)
      this.element.append(span("hint", reasonForNone(signal)));
  }

  private since({ since, k }: Why): HTMLElement {
    if (since.k === k && !since.longer) return span("hint", "changed at this instant");
    const { longer } = since;
    const made = button(
      `since instant ${since.k}${longer ? " or longer" : ""}`,
      longer ? "The search ended here" : "Go to the instant at which it changed",
      () => {
        this.way.push({ signal: this.way.at(-1)?.signal ?? 0, k: since.k });
        this.load();
      },
    );
    made.className = "since";
    return made;
  }

  /** Returns the lines of the equation at a place. */
  private equation(place: Place): HTMLElement[] {
    const source = this.store.program.sources.find(({ name }) => name === place.file);
    if (!source) return [];
    const all = source.text.split("\n").slice(place.line - 1, place.last);
    const lines = all.slice(0, mostLines);
    const indent = Math.min(
      ...lines
        .filter((line) => line.trim() !== "")
        .map((line) => line.length - line.trimStart().length),
    );
    const text = document.createElement("pre");
    text.textContent =
      lines.map((line) => line.slice(indent)).join("\n") + (all.length > mostLines ? "\n…" : "");
    text.title = `${place.file}, line ${place.line}`;
    return [text];
  }

  private sources(sources: readonly Origin[], of: Signal, k: number): HTMLElement {
    const list = document.createElement("ul");
    list.append(
      ...sources.map((source) => {
        const signal = this.signal(source.signal);
        const name =
          signal.instance !== "" && signal.instance === of.instance
            ? signal.own
            : plainName(signal);
        const made = button("", `Why does ${name} have this value?`, () =>
          this.step(source.signal, source.k),
        );
        made.append(
          span("name", name),
          span("value", formatCell(signal, source.cell) || "–"),
          span(
            "when",
            source.k === k
              ? ""
              : k - source.k === 1
                ? "one instant earlier"
                : `instant ${source.k} · ${formatTime(source.time)}`,
          ),
        );
        const item = document.createElement("li");
        item.append(made);
        return item;
      }),
    );
    return list;
  }

  private switched(change: Switch, of: Signal): HTMLElement {
    const place = document.createElement("div");
    place.className = "switch";
    const head = document.createElement("p");
    head.append(
      `${change.from} → ${change.to}`,
      span(
        "when",
        `instant ${change.k} · ${formatTime(change.time)}` +
          (change.label === "" ? "" : `, by ${change.label}`),
      ),
    );
    place.append(head, ...this.equation(change), this.sources(change.sources, of, change.k));
    return place;
  }
}

function plainName(signal: Signal): string {
  return signal.name.replace(/^probe\./, "");
}

function reasonForNone(signal: Signal): string {
  if (signal.side === "input") return "It is an input from the robot or the operator.";
  if (signal.side === "mode") return "Click the mode on its line in the source.";
  return "It does not depend on a signal, only on constants, the time, or a mode that has run since the start.";
}

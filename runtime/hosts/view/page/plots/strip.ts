// A plot with its header: its signals with their values, and its tools.
import type { Store } from "../store";
import { colour, lineColour } from "../theme";
import { difference, formatCell, formatPoint, withoutUnit } from "../values";
import type { Body, Pointed } from "./body";
import { takesSignals } from "./drag";
import { findLargest, savePicture, saveTable } from "./export";
import type { Plot } from "./model";
import { isNamed } from "./scales";
import { spaceOnRight, TimePlot } from "./time_plot";
import type { Trace } from "./trace";
import { XyPlot } from "./xy_plot";

function button(text: string, title: string, act: () => void): HTMLButtonElement {
  const made = document.createElement("button");
  made.textContent = text;
  made.title = title;
  // A button whose text is a word does not need a label.
  if (!/\w/.test(text)) made.ariaLabel = title;
  made.onclick = act;
  return made;
}

/** The name of a signal, with its value. */
class Entry {
  readonly element = document.createElement("span");
  readonly name: HTMLButtonElement;
  private readonly value = document.createElement("output");
  private readonly other = document.createElement("output");
  private readonly apart = document.createElement("output");

  constructor(
    private readonly store: Store,
    readonly trace: Trace,
    isOneOfSeveral: boolean,
  ) {
    const name = trace.signal.name.replace(/^probe\./, "");
    this.name = button(name, `Why does ${name} have this value?`, () => store.wonder(trace.number));
    this.name.className = "name";
    this.element.className = "entry";
    this.other.className = "other";
    this.apart.className = "apart";
    this.element.append(this.name, this.value, this.other, this.apart);
    if (isOneOfSeveral)
      this.element.append(button("×", `Remove ${name}`, () => store.toggle(trace.number)));
    this.colour();
  }

  colour(): void {
    this.name.style.setProperty("--line", lineColour(this.store.colourOf(this.trace.number)));
  }

  /** Shows the value at the pointer, or else at the current instant. */
  show(pointed: Pointed | null): void {
    const { store, trace } = this;
    const { signal, number } = trace;
    if (pointed) {
      const other = pointed.other(trace);
      this.value.textContent = formatPoint(signal, pointed.value(trace));
      this.other.textContent =
        other === null
          ? ""
          : `${store.otherWord}: ${withoutUnit(signal, formatPoint(signal, other))}`;
      this.apart.textContent = "";
      return;
    }
    const cell = store.instant?.cells[number] ?? "";
    const other = store.instant?.others?.[number] ?? cell;
    const marked = store.mark?.cells[number];
    const apart = marked === undefined ? null : difference(signal, marked, cell);
    this.value.textContent = formatCell(signal, cell);
    this.other.textContent =
      other === cell ? "" : `${store.otherWord}: ${withoutUnit(signal, formatCell(signal, other))}`;
    this.apart.textContent = apart === null ? "" : `Δ ${apart}`;
  }
}

export class Strip {
  readonly element = document.createElement("article");
  private readonly head = document.createElement("header");
  private readonly tools = document.createElement("div");
  private readonly pointedAt = document.createElement("output");
  private readonly add: HTMLButtonElement;
  private entries: Entry[] = [];
  private body: Body;
  /** The signals and other settings for which the body was built, to detect changes. */
  private shown = "";

  constructor(
    private readonly store: Store,
    readonly plot: Plot,
    /** The time axis below all plots, for saving a picture. */
    private readonly axis: HTMLCanvasElement,
  ) {
    this.add = button("+", "Click signals to add them to this plot", () => {
      store.target = store.target === plot ? null : plot;
      store.changed("plotted");
    });
    this.tools.className = "plot-tools";
    this.tools.hidden = true;
    this.pointedAt.className = "at";
    this.body = this.newBody();
    this.element.append(this.head, this.tools);
    takesSignals(this.element, (signal) => store.addTo(plot, signal));
    this.update();
  }

  private newBody(): Body {
    const readOut = () => this.readOut();
    return this.plot.isXy
      ? new XyPlot(this.store, this.plot, readOut)
      : new TimePlot(this.store, this.plot, readOut);
  }

  get isLow(): boolean {
    return !this.plot.isXy && this.body.traces.every(({ signal }) => isNamed(signal));
  }

  get headHeight(): number {
    return this.element.offsetHeight - this.body.element.offsetHeight;
  }

  /** Shows the plot's signals, if they have changed. Returns whether they have. */
  update(): boolean {
    const { plot, store } = this;
    const now = `${plot.isXy} ${plot.signals.join()} ${spaceOnRight(store)} ${store.otherName}`;
    this.add.ariaPressed = String(store.target === plot);
    if (now === this.shown) return false;
    this.shown = now;
    this.body.end();
    this.body = this.newBody();
    const { traces } = this.body;
    this.entries = traces.map((trace) => new Entry(store, trace, traces.length > 1));
    const more = button("⋯", "Range, XY plot, export", () => {
      this.tools.hidden = !this.tools.hidden;
      more.ariaExpanded = String(!this.tools.hidden);
      store.changed("sizes");
    });
    more.ariaExpanded = String(!this.tools.hidden);
    const names = traces.map(({ signal }) => signal.name).join(", ");
    const end = button("×", `Do not plot ${names}`, () =>
      store.setPlots(store.plots.filter((each) => each !== plot)),
    );
    const buttons = document.createElement("span");
    buttons.className = "buttons";
    buttons.append(this.add, more, end);
    const entries = document.createElement("h2");
    entries.append(...this.entries.map(({ element }) => element), this.pointedAt);
    this.head.replaceChildren(entries, buttons);
    this.showTools();
    this.element.append(this.body.element);
    return true;
  }

  private showTools(): void {
    const { plot, store } = this;
    const range = document.createElement("label");
    const [low, high] = [0, 1].map((i) => {
      const field = document.createElement("input");
      field.type = "text";
      field.inputMode = "decimal";
      field.size = 6;
      field.placeholder = "auto";
      field.ariaLabel = i === 0 ? "Low end of the axis" : "High end of the axis";
      field.value = plot.fixed ? String(plot.fixed[i]) : "";
      field.onchange = () => fix();
      return field;
    }) as [HTMLInputElement, HTMLInputElement];
    const fix = () => {
      const ends: [number, number] = [parseFloat(low.value), parseFloat(high.value)];
      plot.fixed = ends.every(Number.isFinite) && ends[0] < ends[1] ? ends : null;
      store.changed("plotted");
      this.body.build(this.body.element.clientHeight);
      this.body.load();
    };
    range.append("range ", low, " to ", high);
    const auto = button("Auto", "Fit the range to the values", () => {
      low.value = high.value = "";
      fix();
    });
    const name = `${store.program.name}-${plot.signals
      .map((number) => store.program.signals[number]?.name ?? "")
      .join("-")}`;
    this.tools.replaceChildren(
      range,
      auto,
      button("PNG", "Save this plot as a picture", () => this.savePicture(name)),
      button("CSV", "Save the values in the visible range", () =>
        saveTable(store, name, plot.signals),
      ),
    );
    if (store.hasOthers) this.tools.append(this.largest());
    if (plot.signals.length > 1) {
      const xy = button("XY", "Plot the other signals against the first one", () => {
        plot.isXy = !plot.isXy;
        store.changed("plotted");
      });
      xy.ariaPressed = String(plot.isXy);
      this.tools.append(xy);
    }
    if (plot.isXy)
      this.tools.append(
        button("Swap", "Use the next signal as the horizontal axis", () => {
          plot.signals = [...plot.signals.slice(1), ...plot.signals.slice(0, 1)];
          store.changed("plotted");
        }),
      );
  }

  /** A button that goes to the largest difference from the other recording. */
  private largest(): HTMLElement {
    const { store, plot } = this;
    const place = document.createElement("span");
    const said = document.createElement("output");
    const [first] = plot.signals;
    const find = button(
      "Largest difference",
      "Go to where the first signal differs most in the visible range",
      () => {
        const signal = first === undefined ? undefined : store.program.signals[first];
        if (first === undefined || !signal) return;
        findLargest(store, first, (found) => {
          said.textContent = found
            ? ` ${formatPoint(signal, found.largest)}; root mean square ${formatPoint(signal, found.rms)}`
            : " none";
          if (found) store.goToTime(found.time);
        });
      },
    );
    place.append(find, said);
    return place;
  }

  private savePicture(name: string): void {
    const { picture } = this.body;
    if (!picture) return;
    savePicture(
      name,
      [
        ...this.entries.map(({ trace }) => ({
          text:
            trace.signal.unit === ""
              ? trace.signal.name
              : `${trace.signal.name} [${trace.signal.unit}]`,
          colour: lineColour(this.store.colourOf(trace.number)),
        })),
        ...(this.store.hasOthers
          ? [{ text: `dashed: ${this.store.otherName}`, colour: colour("dim") }]
          : []),
      ],
      this.plot.isXy ? [picture] : [picture, this.axis],
    );
  }

  load(): void {
    this.body.load();
  }

  grow(): void {
    this.body.grow();
  }

  moved(): void {
    this.body.moved();
  }

  build(height: number): void {
    this.body.build(height);
  }

  /** Redraws the plot after a change of colours. */
  restyle(): void {
    for (const entry of this.entries) entry.colour();
    if (this.body instanceof TimePlot) this.body.forget();
  }

  private readOut(): void {
    const { pointed } = this.body;
    this.element.classList.toggle("pointed", pointed !== null);
    for (const entry of this.entries) entry.show(pointed);
    this.pointedAt.textContent = pointed ? `at ${pointed.time.toFixed(3)} s` : "";
  }

  end(): void {
    this.body.end();
    this.element.remove();
  }
}

// The program's source, read-only. The end of each line shows its values at the current instant.
import {
  Compartment,
  EditorState,
  StateEffect,
  StateField,
  type Extension,
} from "@codemirror/state";
import {
  Decoration,
  EditorView,
  keymap,
  lineNumbers,
  WidgetType,
  type DecorationSet,
} from "@codemirror/view";
import { highlight } from "./highlight";
import { canBeDragged } from "../plots/drag";
import { input } from "./input";
import { Lines, shownSources, type Chip, type LineValues } from "./lines";
import type { Source } from "../protocol";
import type { Store } from "../store";
import { undoing } from "./undo";
import { WhatIfBar } from "./what_if";
import { WhyPanel } from "./why";

const look = EditorView.theme({
  "&": { height: "100%", color: "var(--text)", backgroundColor: "transparent", fontSize: "13px" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.55", overflowX: "hidden" },
  ".cm-gutters": { backgroundColor: "transparent", color: "var(--dim)", border: "none" },
  "&.cm-focused": { outline: "none" },
  ".token-keyword": { color: "var(--keyword)", fontWeight: "600" },
  ".token-comment": { color: "var(--dim)", fontStyle: "italic" },
  ".token-number": { color: "var(--number)" },
  ".token-type": { color: "var(--type)" },
  ".token-operator": { color: "var(--operator)" },
  ".idle, .idle span": { color: "var(--dim) !important", fontWeight: "400 !important" },
  ".asked": { backgroundColor: "var(--picked)" },
  // The values take no space, so they never make a line wrap. If there is not enough space after
  // the text, they cover its end.
  ".values": {
    position: "sticky",
    right: "6px",
    display: "inline-block",
    marginRight: "-100em",
    padding: "0 0 0 1.5ch",
    lineHeight: "1.4",
    whiteSpace: "nowrap",
    background: "linear-gradient(to right, transparent, var(--panel) 1.5ch)",
  },
  // The values become almost transparent while the pointer is on the text.
  ".cm-line:hover .values:not(:hover)": { opacity: "0.15" },
  ".values button": {
    font: "12px var(--mono)",
    color: "var(--text)",
    background: "var(--chip)",
    border: "1px solid transparent",
    borderRadius: "5px",
    padding: "0 5px",
    margin: "0 4px 0 0",
    cursor: "pointer",
  },
  ".values button:hover": { borderColor: "var(--accent)" },
  ".values button[aria-pressed=true]": {
    borderColor: "var(--accent)",
    background: "var(--picked)",
  },
  ".values .name": { color: "var(--dim)", marginRight: "0.7ch" },
  ".values .other": { color: "var(--mark)" },
  ".values .instance": {
    background: "transparent",
    color: "var(--dim)",
    border: "1px solid var(--edge)",
  },
  "&.editing": { backgroundColor: "var(--edited)" },
  "&.editing .cm-cursor": { borderLeftColor: "var(--text)" },
  ".values .more": { color: "var(--dim)" },
});

interface Act {
  pick(number: number): void;
  next(line: number): void;
  /** Toggles between showing all values of a line and only as many as fit. */
  expand(line: number): void;
}

/** The values at the end of a line. */
class Values extends WidgetType {
  private readonly text: string;

  constructor(
    private readonly line: number,
    private readonly values: LineValues,
    private readonly act: Act,
  ) {
    super();
    this.text = JSON.stringify(values);
  }

  override eq(other: Values): boolean {
    return this.line === other.line && this.text === other.text;
  }

  private chip({ number, name, value, other, isPlotted }: Chip): HTMLElement {
    const button = document.createElement("button");
    const label = document.createElement("span");
    label.className = "name";
    label.textContent = name;
    button.append(label, value === "" ? "–" : value);
    if (other !== null) {
      const changed = document.createElement("span");
      changed.className = "other";
      changed.textContent = ` → ${other === "" ? "–" : other}`;
      button.append(changed);
    }
    button.ariaPressed = String(isPlotted);
    button.title = isPlotted ? `${name} is plotted` : `Plot ${name}`;
    button.onclick = () => this.act.pick(number);
    button.tabIndex = -1;
    canBeDragged(button, number);
    return button;
  }

  toDOM(): HTMLElement {
    const place = document.createElement("span");
    place.className = "values";
    const { chips, more, instance, instances, instanceName } = this.values;
    if (instances > 1) {
      const button = document.createElement("button");
      button.className = "instance";
      button.textContent = `${instanceName} ${instance + 1}/${instances}`;
      button.title = "Show the next instance";
      button.onclick = () => this.act.next(this.line);
      button.tabIndex = -1;
      place.append(button);
    }
    place.append(...chips.map((chip) => this.chip(chip)));
    if (more > 0) {
      const rest = document.createElement("button");
      rest.className = "more";
      rest.textContent = `+${more}`;
      rest.title = "Show all values of this line";
      rest.tabIndex = -1;
      rest.onclick = () => this.act.expand(this.line);
      place.append(rest);
    }
    return place;
  }

  override ignoreEvent(): boolean {
    return true;
  }
}

const show = StateEffect.define<DecorationSet>();
const shown = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update: (before, change) =>
    change.effects.reduce(
      (now, effect) => (effect.is(show) ? effect.value : now),
      before.map(change.changes),
    ),
  provide: (field) => EditorView.decorations.from(field),
});

const tinted = EditorView.editorAttributes.of({ class: "editing" });
/** First line that may be out of view when the file is scrolled to the top. */
const farDown = 15;
const idle = Decoration.line({ class: "idle" });
const asked = Decoration.line({ class: "asked" });

export function startSource(store: Store, host: HTMLElement): WhyPanel {
  const lines = new Lines(store);
  const sources = shownSources(store.program, lines);
  const tabs = document.createElement("nav");
  const editor = document.createElement("div");
  // In a shadow tree the editor adds its styles as style sheets, not as `<style>` elements, which
  // the page's security policy would reject.
  const root = editor.attachShadow({ mode: "open" });

  const writing = new Compartment();
  const extensions: Extension = [
    lineNumbers(),
    EditorView.lineWrapping,
    writing.of(EditorState.readOnly.of(true)),
    EditorView.contentAttributes.of({ "aria-label": "Source" }),
    highlight,
    look,
    shown,
    EditorView.updateListener.of(({ docChanged, viewportChanged }) => {
      if (docChanged && store.isEditing) {
        const text = view.state.doc.toString();
        store.edited = text === sources[0]?.text ? null : text;
      }
      if (docChanged) store.changed("edited");
      if (viewportChanged) requestAnimationFrame(scrolled);
    }),
  ];
  const stateOf = (source: Source | undefined) =>
    EditorState.create({ doc: source?.text ?? "", extensions });
  let current = sources[0];
  const view = new EditorView({ root, parent: root, state: stateOf(current) });

  const act: Act = {
    pick: (number) => store.pick(number),
    next: (line) => {
      if (current) lines.next(current.name, line);
      update();
    },
    expand: (line) => {
      expanded = expanded === line ? 0 : line;
      update();
    },
  };
  /** The line whose values are all shown; 0 if there is none. */
  let expanded = 0;
  /** Returns the space for values after a text, in characters. If there is little free space, the
   * values may cover the end of the text, but always less than half of the line. */
  const roomAfter = (line: number, text: string) => {
    const across = view.contentDOM.clientWidth / Math.max(1, view.defaultCharacterWidth) - 2;
    const free = text.length < across ? across - text.length : 0;
    return line === expanded ? Infinity : Math.max(free, 0.45 * across);
  };
  /** Returns the first and last lines that may be visible. */
  const inView = (): [number, number] => {
    const {
      state: { doc },
      viewport: { from, to },
    } = view;
    return [doc.lineAt(from).number, doc.lineAt(to).number];
  };
  let covered: [number, number] = [1, 0];
  const scrolled = () => {
    const [first, last] = inView();
    if (first < covered[0] || last > covered[1]) update();
  };
  /** Returns whether the text still has its original number of lines. Otherwise, the values would
   * be next to the wrong lines. */
  const hasItsLines = () => view.state.doc.lines === current?.text.split("\n").length;
  const update = () => {
    if (!current) return;
    const { name } = current;
    const { place } = store;
    const { doc } = view.state;
    covered = inView();
    const marks = lines.between(name, ...covered).flatMap((line) => {
      const { from, to, text } = doc.line(line);
      const values = lines.values(name, line, roomAfter(line, text));
      if (!values) return [];
      const widget = Decoration.widget({ widget: new Values(line, values, act), side: 1 });
      return [...(values.runs ? [] : [idle.range(from)]), widget.range(to)];
    });
    for (let line = place?.line ?? 1; place?.file === name && line <= place.last; line++)
      if (line <= doc.lines) marks.push(asked.range(doc.line(line).from));
    view.dispatch({
      effects: show.of(hasItsLines() ? Decoration.set(marks, true) : Decoration.none),
    });
  };

  const select = (source: Source | undefined) => {
    current = source;
    view.setState(stateOf(source));
    for (const tab of tabs.children) tab.ariaPressed = String(tab.textContent === source?.name);
    update();
    showFirst();
  };
  /** Scrolls so that the first values are visible, with some lines above them. */
  const showFirst = () => {
    const line = current ? lines.first(current.name) : 1;
    if (store.isEditing || line < farDown || line > view.state.doc.lines) return;
    view.dispatch({
      effects: EditorView.scrollIntoView(view.state.doc.line(line).from, {
        y: "start",
        yMargin: 110,
      }),
    });
  };
  /** Shows the program's own file. If it was already shown, returns the position at the top of the
   * view, for `scrollTo`; otherwise returns null. */
  const selectOwn = () => {
    const at =
      current === sources[0] ? view.lineBlockAtHeight(view.scrollDOM.scrollTop).from : null;
    select(sources[0]);
    return at;
  };
  const scrollTo = (at: number | null) => {
    if (at !== null && at <= view.state.doc.length)
      view.dispatch({
        selection: { anchor: at },
        effects: EditorView.scrollIntoView(at, { y: "start", yMargin: 0 }),
      });
  };
  const bar = new WhatIfBar(store, {
    begin: (text) => {
      const at = selectOwn();
      const undo = undoing();
      const keys = keymap.of([
        {
          key: "Mod-Enter",
          run: () => {
            bar.run("what-if");
            return true;
          },
        },
        {
          key: "Mod-Shift-Enter",
          run: () => {
            bar.run("drive");
            return true;
          },
        },
        {
          key: "Escape",
          run: () => {
            bar.close();
            return true;
          },
        },
        ...undo.keys,
      ]);
      const { length } = view.state.doc;
      view.dispatch({
        effects: writing.reconfigure([keys, undo.extension, input, tinted]),
        ...(text === null ? {} : { changes: { from: 0, to: length, insert: text } }),
      });
      scrollTo(at);
      view.focus();
    },
    text: () => view.state.doc.toString(),
    end: () => {
      scrollTo(selectOwn());
    },
  });

  for (const source of sources) {
    const tab = document.createElement("button");
    tab.textContent = source.name;
    tab.onclick = () => {
      if (store.isEditing) bar.close();
      select(source);
    };
    tabs.append(tab);
  }
  const head = document.createElement("header");
  const why = new WhyPanel(store);
  head.append(tabs, why.button, bar.button);
  host.append(head, bar.element, editor, why.element);
  select(current);
  store.continueEditing = (text) => bar.begin(text);
  store.on("instant", update);
  store.on("plotted", update);
  store.on("place", () => {
    const { place } = store;
    if (place?.instance !== undefined)
      lines.choose(place.file, place.line, place.last, place.instance);
    if (!store.isEditing && place && place.file !== current?.name)
      select(sources.find((source) => source.name === place.file) ?? current);
    update();
    if (place && place.file === current?.name && place.line <= view.state.doc.lines)
      view.dispatch({
        effects: EditorView.scrollIntoView(view.state.doc.line(place.line).from, {
          y: "nearest",
          yMargin: 40,
        }),
      });
  });
  return why;
}

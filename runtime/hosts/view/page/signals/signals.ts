// The list of all signals with their values. A click plots a signal.
import { grouped, groupNames, type GroupName } from "./groups";
import { machineName, modesOf } from "./modes";
import { canBeDragged } from "../plots/drag";
import type { Signal } from "../protocol";
import { startRoving } from "../roving";
import type { Store } from "../store";
import { formatCell, isNothing } from "../values";

interface Row {
  readonly row: HTMLButtonElement;
  readonly value: HTMLElement;
  readonly signal: Signal;
  cell: string | null;
}

const titles: Readonly<Partial<Record<GroupName, string>>> = {
  Inside: "Values of the program's equations",
  Constants: "Values that have not changed since the start and do not depend on any signal",
  Library: "Values inside signal functions of the library",
};

/** A part of the list, with its title. */
class Group {
  readonly element = document.createElement("section");
  readonly rows: Row[] = [];
  private readonly title = document.createElement("h2");
  private readonly fold = document.createElement("button");
  private isOpen: boolean;

  constructor(
    readonly name: GroupName,
    isFolded: boolean,
  ) {
    this.isOpen = !isFolded;
    this.title.title = titles[name] ?? "";
    if (isFolded) {
      this.fold.onclick = () => {
        this.isOpen = !this.isOpen;
        this.show();
      };
      this.title.append(this.fold);
    }
    this.element.append(this.title);
    this.show();
  }

  add(row: Row, ...more: HTMLElement[]): void {
    this.rows.push(row);
    this.element.append(row.row, ...more);
    this.show();
  }

  remove(row: Row): void {
    this.rows.splice(this.rows.indexOf(row), 1);
    this.show();
  }

  /** Shows the rows whose signals match, even in a folded group. */
  filter(wanted: string): void {
    let count = 0;
    for (const { row, signal } of this.rows) {
      row.hidden = !signal.name.toLowerCase().includes(wanted);
      if (!row.hidden) count++;
      const { nextElementSibling: diagram } = row;
      if (diagram?.classList.contains("modes")) (diagram as HTMLElement).hidden = row.hidden;
    }
    this.element.hidden = count === 0;
    this.element.classList.toggle("found", wanted !== "");
  }

  private show(): void {
    const { name, rows, fold, element, title } = this;
    element.classList.toggle("folded", !this.isOpen);
    element.hidden = rows.length === 0;
    if (title.contains(fold)) {
      fold.textContent = `${this.isOpen ? "▾" : "▸"} ${name} (${rows.length})`;
      fold.ariaExpanded = String(this.isOpen);
    } else title.textContent = name;
  }
}

function makeRow(store: Store, signal: Signal, number: number, name: string): Row {
  const row = document.createElement("button");
  const label = document.createElement("span");
  const value = document.createElement("output");
  label.textContent = name;
  row.title = signal.name;
  value.append("");
  row.append(label, value);
  row.onclick = () => store.pick(number);
  canBeDragged(row, number);
  return { row, value, signal, cell: null };
}

export function startSignals(store: Store, list: HTMLElement, filter: HTMLInputElement): void {
  const groups = new Map(groupNames.map((name) => [name, new Group(name, name === "Library")]));
  const rows: (Row | undefined)[] = [];
  const groupOf = grouped(store.program);
  groupOf.forEach((name, number) => {
    const signal = store.program.signals[number];
    const group = name && groups.get(name);
    if (!signal || !group) return;
    const isMode = signal.side === "mode" || signal.transitions !== undefined;
    const label = isMode ? machineName(signal) : signal.name.replace(/^(in|out|probe)\./, "");
    const row = makeRow(store, signal, number, label);
    rows[number] = row;
    group.add(row, ...(isMode ? [modesOf(store, signal, number)] : []));
  });
  const none = document.createElement("p");
  none.className = "empty";
  none.textContent = "No signal name contains this text.";
  none.hidden = true;
  list.append(...[...groups.values()].map(({ element }) => element), none);
  startRoving(list);

  const matching = () => filter.value.trim().toLowerCase();
  /** Moves a signal from the group of constants to that of inner signals, because its value has
   * changed. */
  const unfix = (row: Row) => {
    groups.get("Constants")?.remove(row);
    groups.get("Inside")?.add(row);
    groups.get("Inside")?.filter(matching());
  };
  const showValues = () =>
    rows.forEach((shown, number) => {
      if (!shown) return;
      const { row, value, signal } = shown;
      const cell = store.instant?.cells[number] ?? "";
      if (cell === shown.cell) return;
      const hadValue = shown.cell !== null && shown.cell !== "";
      if (groupOf[number] === "Constants" && hadValue && cell !== "") {
        groupOf[number] = "Inside";
        unfix(shown);
      }
      if (cell !== "" || groupOf[number] !== "Constants") shown.cell = cell;
      // Changes the existing text node, because creating new nodes many times a second would
      // produce a lot of garbage.
      (value.firstChild as Text).data = formatCell(signal, cell);
      value.title = cell;
      row.classList.toggle("nothing", isNothing(signal, cell));
    });
  const showPlotted = () => {
    const plotted = new Set(store.plotted);
    rows.forEach((shown, number) => {
      if (shown) shown.row.ariaPressed = String(plotted.has(number));
    });
  };
  filter.oninput = () => {
    for (const group of groups.values()) group.filter(matching());
    none.hidden = [...groups.values()].some(({ element }) => !element.hidden);
  };
  filter.onkeydown = (event) => {
    const first = [...groups.values()]
      .flatMap(({ rows }) => rows)
      .find(({ signal }) => signal.name.toLowerCase().includes(matching()));
    if (event.key === "Enter" && first) first.row.click();
    if (event.key === "ArrowDown") list.querySelector<HTMLElement>("[tabindex='0']")?.focus();
    if (event.key === "Escape") {
      filter.value = "";
      filter.dispatchEvent(new Event("input"));
      filter.blur();
    }
  };
  store.on("instant", showValues);
  store.on("plotted", showPlotted);
  showPlotted();
}

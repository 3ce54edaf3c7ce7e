// The list of all signals, with their values; a click plots one.
import { machineName, modesOf, modeSignals } from "./modes";
import { canBeDragged } from "../plots/drag";
import type { Signal } from "../protocol";
import type { Store } from "../store";
import { formatCell, isNothing } from "../values";

const titles = { input: "Input", output: "Output", probe: "Inside", mode: "Modes" } as const;

export function startSignals(store: Store, list: HTMLElement, filter: HTMLInputElement): void {
  const rows: {
    row: HTMLButtonElement;
    value: HTMLElement;
    signal: Signal;
    cell: string | null;
  }[] = [];
  const groups: HTMLElement[] = [];
  const modes = new Set(modeSignals(store.program));
  const sideOf = (signal: Signal, number: number) =>
    modes.has(number) ? "mode" : signal.side === "mode" ? null : signal.side;
  for (const side of ["output", "mode", "probe", "input"] as const) {
    const group = document.createElement("section");
    const title = document.createElement("h2");
    title.textContent = titles[side];
    group.append(title);
    store.program.signals.forEach((signal, number) => {
      if (sideOf(signal, number) !== side) return;
      const row = document.createElement("button");
      const name = document.createElement("span");
      const value = document.createElement("output");
      name.textContent =
        side === "mode" ? machineName(signal) : signal.name.replace(/^(in|out|probe)\./, "");
      row.title = signal.name;
      value.append("");
      row.append(name, value);
      row.onclick = () => store.pick(number);
      canBeDragged(row, number);
      rows[number] = { row, value, signal, cell: null };
      group.append(row);
      if (side === "mode") group.append(modesOf(store, signal, number));
    });
    if (group.childElementCount > 1) groups.push(group);
  }
  list.append(...groups);

  const showValues = () =>
    rows.forEach((shown, number) => {
      const { row, value, signal } = shown;
      const cell = store.instant?.cells[number] ?? "";
      if (cell === shown.cell) return;
      shown.cell = cell;
      // Change the existing text node: new nodes many times a second would leave a lot of garbage.
      (value.firstChild as Text).data = formatCell(signal, cell);
      value.title = cell;
      row.classList.toggle("nothing", isNothing(signal, cell));
    });
  const showPlotted = () =>
    rows.forEach(({ row }, number) => {
      row.ariaPressed = String(store.plotted.includes(number));
    });
  const matching = () =>
    rows.filter(({ signal }) =>
      signal.name.toLowerCase().includes(filter.value.trim().toLowerCase()),
    );
  filter.oninput = () => {
    const shown = new Set(matching().map(({ row }) => row));
    rows.forEach(({ row }, number) => {
      row.hidden = !shown.has(row);
      if (modes.has(number) && row.nextElementSibling instanceof HTMLElement)
        row.nextElementSibling.hidden = row.hidden;
    });
    for (const group of groups)
      group.hidden = !group.querySelector(":scope > button:not([hidden])");
  };
  filter.onkeydown = (event) => {
    const [first] = matching();
    if (event.key === "Enter" && first) first.row.click();
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

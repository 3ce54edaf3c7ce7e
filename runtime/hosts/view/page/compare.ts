// Names the edited program or second recording that is drawn on top of the run. Offers controls to
// find the differences and to align the two runs.
import type { Align } from "./protocol";
import type { Store } from "./store";
import { formatTime } from "./values";

function part<T extends HTMLElement>(host: HTMLElement, id: string): T {
  const found = host.querySelector<T>(`#${id}`);
  if (!found) throw new Error(`the page has no ${id}`);
  return found;
}

/** Returns a function that handles the viewer's answer to an alignment request. */
export function startComparison(store: Store, host: HTMLElement): (answer: Align) => void {
  const said = part<HTMLOutputElement>(host, "compared");
  const go = part<HTMLButtonElement>(host, "first-difference");
  const field = part<HTMLInputElement>(host, "align");
  const aligning = field.parentElement ?? field;
  const wrong = part<HTMLOutputElement>(host, "align-said");

  const show = () => {
    const { other } = store;
    const edits = store.whatIf?.there === true;
    host.hidden = other === null && !edits;
    aligning.hidden = other === null;
    if (edits) {
      const again = other ? ` Discard it to see ${other.name} again.` : "";
      said.textContent = `Solid: the program of this run. Dashed: the edited program.${again}`;
      go.hidden = true;
    }
    if (!other || edits) return;
    const set = other.set.length > 0 ? ` (${other.set.join(", ")})` : "";
    const shift = other.shift === 0 ? "" : `, shifted by ${formatTime(-other.shift)}`;
    const inside = other.runs
      ? ""
      : " It is from another version of the program, so only inputs and outputs are known.";
    const differs =
      other.first === undefined
        ? "The outputs are the same at all instants."
        : `The outputs differ from instant ${other.first} on, first in ${other.signal ?? ""}.`;
    said.textContent = `Dashed: ${other.name}${set}${shift}. ${differs}${inside}`;
    go.hidden = other.first === undefined;
  };
  go.onclick = () => store.other?.first !== undefined && store.goTo(store.other.first);
  field.onkeydown = (event) => {
    if (event.key === "Enter") store.align(field.value.trim());
    if (event.key === "Escape") field.blur();
  };
  store.on("what-if", show);
  show();
  return (answer) => {
    wrong.textContent = answer.why ?? "";
    if (answer.other) store.aligned(answer);
  };
}

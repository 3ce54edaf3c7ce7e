// Controls for a second recording, drawn on top of the first one: where the two differ, and how
// they are aligned.
import type { Align } from "./protocol";
import type { Store } from "./store";
import { formatTime } from "./values";

function part<T extends HTMLElement>(host: HTMLElement, id: string): T {
  const found = host.querySelector<T>(`#${id}`);
  if (!found) throw new Error(`the page has no ${id}`);
  return found;
}

/** Returns a function that handles the viewer's answer to a new alignment. */
export function startComparison(store: Store, host: HTMLElement): (answer: Align) => void {
  const said = part<HTMLOutputElement>(host, "compared");
  const go = part<HTMLButtonElement>(host, "first-difference");
  const field = part<HTMLInputElement>(host, "align");
  const wrong = part<HTMLOutputElement>(host, "align-said");

  const show = () => {
    const { other } = store;
    host.hidden = other === null;
    if (!other) return;
    if (store.whatIf?.there) {
      said.textContent = `Dashed: the edited program. Discard it to see ${other.name} again.`;
      go.hidden = true;
      return;
    }
    const set = other.set.length > 0 ? ` (${other.set.join(", ")})` : "";
    const shift = other.shift === 0 ? "" : `, shifted by ${formatTime(-other.shift)}`;
    const inside = other.runs
      ? ""
      : " It is from another version: only inputs and outputs are known.";
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

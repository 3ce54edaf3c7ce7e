// Finds when a condition becomes true.
import type { Found } from "../protocol";
import type { Store } from "../store";

export function startSearch(
  store: Store,
  field: HTMLInputElement,
  said: HTMLElement,
  before: HTMLButtonElement,
  after: HTMLButtonElement,
): void {
  let searched = "";

  const show = (found: Found, go: "first" | "before" | "after") => {
    const to = found.why === undefined ? found[go] : null;
    said.classList.toggle("bad", found.why !== undefined);
    if (found.why !== undefined) said.textContent = found.why;
    else if (found.count === 0) said.textContent = "never";
    else {
      const times = found.count === 1 ? "once" : `${found.count} times`;
      said.textContent =
        to !== null && to !== undefined
          ? times
          : `${times}, none ${go === "before" ? "before" : "after"} this`;
    }
    store.setSpans(found.spans ?? []);
    if (to !== null && to !== undefined) store.goTo(to);
  };

  const find = (go: "first" | "before" | "after") => {
    const text = field.value.trim();
    if (text === "") {
      searched = "";
      said.textContent = "";
      store.setSpans([]);
      return;
    }
    const really = text === searched ? go : "first";
    searched = text;
    store.find(text, (found) => show(found, really));
  };

  field.onkeydown = (event) => {
    if (event.key === "Enter") find(event.shiftKey ? "before" : "after");
    if (event.key === "Escape") {
      field.value = "";
      find("first");
      field.blur();
    }
  };
  before.onclick = () => find("before");
  after.onclick = () => find("after");
}

// The modes of a machine, the one that runs lit; a click goes to when one next begins.
import type { Signal } from "./protocol";
import type { Store } from "./store";
import { lineColour, onTheme } from "./theme";

export function modesOf(store: Store, signal: Signal, number: number): HTMLElement {
  const place = document.createElement("div");
  place.className = "modes";
  const pills = signal.names.map((name) => {
    const pill = document.createElement("button");
    pill.textContent = name;
    pill.title = `Go to when ${name} next begins`;
    pill.onclick = () => store.find(`${signal.name} == ${name}`, (found) => {
      const to = found.after ?? found.first;
      if (to !== null && to !== undefined) store.goTo(to);
    });
    return pill;
  });
  const colour = () => pills.forEach((pill, i) =>
    pill.style.setProperty("--line", lineColour(i)));
  colour();
  onTheme(colour);
  place.append(...pills);
  store.on("instant", () => {
    const running = store.instant?.cells[number];
    pills.forEach((pill, i) =>
      pill.classList.toggle("running", signal.names[i] === running));
  });
  return place;
}

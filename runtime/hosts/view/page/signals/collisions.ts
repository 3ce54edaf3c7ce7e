// Counts the collisions of a simulated robot. A click goes to the next one.
import type { Store } from "../store";

/** Interval, in ms, at which the collisions of a live run are requested. */
const every = 500;

export function startCollisions(store: Store, button: HTMLButtonElement): void {
  let asked = 0;
  const ask = () => {
    asked = performance.now();
    store.askContacts();
  };
  button.onclick = () => {
    const now = store.instant?.time ?? 0;
    const times = store.contacts.map(([time]) => time);
    const next = times.find((time) => time > now) ?? times[0];
    if (next !== undefined) store.goToTime(next);
  };
  store.on("contacts", () => {
    const { length } = store.contacts;
    button.hidden = length === 0;
    button.textContent = length === 1 ? "1 collision" : `${length} collisions`;
  });
  store.on("extent", () => {
    if (performance.now() > asked + every || !store.program.live) ask();
  });
  ask();
}

// Controls of a live run: a button that returns to the newest instant, the speed, keys for the
// program, and Stop.
import { Stop } from "./stop";
import type { Store } from "../store";

const speeds = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];
/** Practically unlimited: the simulator runs as fast as it can. */
const fullSpeed = 1_000_000;

/** The codes that a terminal sends for keys that are not characters. */
const codes: Readonly<Record<string, number>> = {
  Enter: 10,
  Backspace: 127,
  Tab: 9,
  Delete: 127,
};

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no ${id}`);
  return found as T;
}

/** Sends typed characters as events, including characters from a phone's keyboard. */
function startKeyboard(store: Store, field: HTMLInputElement): void {
  const press = (code: number) => store.command(`key ${code}`);
  field.oninput = () => {
    for (const character of field.value) press(character.codePointAt(0) ?? 0);
    field.value = "";
  };
  field.onkeydown = (event) => {
    const code = codes[event.key];
    if (event.key === "Escape") field.blur();
    if (code === undefined || event.shiftKey) return;
    event.preventDefault();
    press(code);
  };
}

export function startLive(store: Store): Stop {
  const bar = element("live");
  const follow = element("follow");
  const hold = element("hold");
  const single = element<HTMLButtonElement>("single");
  const speed = element<HTMLSelectElement>("run-speed");
  const type = element<HTMLInputElement>("type");
  const operate = element("operate");
  const takesKeys = store.program.sources.some(
    (source) => !source.library && source.text.includes("keyPressed"),
  );
  const isLive = store.program.live;

  for (const each of speeds) speed.append(new Option(`${each}×`, String(each)));
  speed.append(new Option("full", String(fullSpeed)));
  follow.onclick = () => store.follow();
  hold.onclick = () => store.command(store.run?.paused ? "go" : "pause");
  single.onclick = () => store.command("step");
  speed.onchange = () => {
    store.command(`speed ${speed.value}`);
    speed.blur(); // returns the keyboard focus to the page
  };
  operate.onclick = () => store.command("take");
  startKeyboard(store, type);

  const show = () => {
    const { run, program, following } = store;
    bar.hidden = !isLive;
    bar.classList.toggle("over", !program.live);
    const { isLost, silent } = store.contact;
    follow.textContent = !program.live
      ? "The run is over"
      : isLost
        ? "No contact"
        : !following
          ? "Back to live"
          : silent === "instants"
            ? "No new instant"
            : "Live";
    follow.ariaPressed = String(following && silent === "nobody");
    // Disables controls whose commands cannot be executed at the moment.
    for (const each of [element("pace"), type, operate]) each.inert = isLost;
    element("pace").hidden = !run?.paces || !run.operates;
    hold.textContent = run?.paused ? "Continue" : "Pause";
    hold.ariaPressed = String(run?.paused === true);
    // The playback speed does not apply while the page follows a live run.
    element("speed").hidden = following;
    single.disabled = !run?.paused;
    speed.value = String(run?.speed ?? 1);
    type.hidden = !takesKeys || !run?.sends || !run.operates;
    operate.hidden = !run || run.operates;
  };
  store.on("run", show);
  store.on("following", show);
  store.on("contact", show);
  show();
  return new Stop(store, element<HTMLButtonElement>("stop"), element("fate"));
}

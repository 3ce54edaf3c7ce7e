// The program's controls: buttons, knobs and toggles, shown during a live run that this page
// operates. The map itself handles clicks; cameras are not controls.
import type { Control } from "../protocol";
import type { Store } from "../store";
import { formatNumber } from "../values";

/** Interval at which a held button is reported, in ms: the host releases it after 300 ms without a
 * report. */
const renewal = 100;
/** Minimum interval between the values that are sent while a knob is turned, in ms. */
const pace = 50;
const steps = 200;

/** A control: its element, and functions that update and release it. */
interface Shown {
  readonly host: HTMLElement;
  readonly show: (cell: string) => void;
  readonly release: () => void;
}

const nothing = () => undefined;

function button(control: Control, press: () => void): Shown {
  const host = document.createElement("button");
  host.textContent = control.label;
  host.onclick = press;
  return { host, show: nothing, release: nothing };
}

function toggle(control: Control, touch: (x: number) => void): Shown {
  const host = document.createElement("button");
  let on = control.first !== 0;
  const draw = () => {
    host.ariaChecked = String(on);
  };
  host.role = "switch";
  host.textContent = control.label;
  host.onclick = () => {
    on = !on;
    touch(Number(on));
    draw();
  };
  draw();
  return {
    host,
    show: (cell) => {
      on = cell === "true";
      draw();
    },
    release: nothing,
  };
}

function holdButton(control: Control, hold: (x: number) => void): Shown {
  const host = document.createElement("button");
  let timer: number | undefined;
  const release = () => {
    if (timer === undefined) return;
    clearInterval(timer);
    timer = undefined;
    hold(0);
    host.ariaPressed = "false";
  };
  const press = () => {
    if (timer !== undefined) return;
    hold(1);
    timer = window.setInterval(() => hold(1), renewal);
    host.ariaPressed = "true";
  };
  host.className = "hold";
  host.ariaPressed = "false";
  host.textContent = control.label;
  host.title = `${control.label}: active while you hold it down`;
  host.onpointerdown = (event) => {
    if (event.button !== 0) return;
    host.setPointerCapture(event.pointerId);
    press();
  };
  host.onpointerup = host.onpointercancel = host.onlostpointercapture = release;
  host.onkeydown = (event) => {
    if (event.key !== " " && event.key !== "Enter") return;
    event.preventDefault();
    press();
  };
  host.onkeyup = host.onblur = release;
  host.oncontextmenu = (event) => event.preventDefault();
  return { host, show: nothing, release };
}

function knob(control: Control, touch: (x: number) => void): Shown {
  const host = document.createElement("label");
  const name = document.createElement("span");
  const value = document.createElement("output");
  const slider = document.createElement("input");
  let timer: number | undefined;
  const draw = () => {
    const unit = control.unit === "" ? "" : `[${control.unit}]`;
    value.textContent = formatNumber(Number(slider.value)) + unit;
  };
  host.className = "knob";
  name.textContent = control.label;
  slider.type = "range";
  slider.min = String(control.least);
  slider.max = String(control.most);
  slider.step = String((control.most - control.least) / steps);
  slider.value = String(control.first);
  slider.oninput = () => {
    draw();
    timer ??= window.setTimeout(() => {
      timer = undefined;
      touch(Number(slider.value));
    }, pace);
  };
  host.append(name, value, slider);
  draw();
  const show = (cell: string) => {
    // Does nothing while the user is turning the knob.
    if (timer !== undefined || slider.matches(":active")) return;
    slider.value = cell;
    draw();
  };
  return { host, show, release: nothing };
}

function note(text: string): Shown {
  const host = document.createElement("p");
  host.textContent = text;
  return { host, show: nothing, release: nothing };
}

/** Creates a control. Returns null if the page does not show controls of this kind. */
function make(store: Store, control: Control, number: number): Shown | null {
  const touch = (x: number) => void store.command(`touch ${number} ${x} 0`);
  // If contact is lost, the host releases the button automatically.
  const hold = (x: number) => {
    if (x > 0 || !store.contact.isLost) store.command(`hold ${number} ${x}`);
  };
  switch (control.kind) {
    case "button":
      return button(control, () => touch(1));
    case "hold":
      return holdButton(control, hold);
    case "knob":
      return knob(control, touch);
    case "toggle":
      return toggle(control, touch);
    case "map":
      return note("The program receives clicks on the map.");
    case "camera":
    case "tags":
    case "lidar":
    case "imu":
      return null;
    default: {
      const unknown: never = control.kind;
      return note(`${control.label}: this page does not support “${String(unknown)}”.`);
    }
  }
}

export function startConsole(store: Store, host: HTMLElement): void {
  const shown = store.program.console.map((control, number) => make(store, control, number));
  const seen = shown.filter((each) => each !== null);
  const releaseAll = () => {
    for (const each of seen) each.release();
  };
  host.append(...seen.map((each) => each.host));

  // Updates a control when the program's input changes, even if another page caused the change.
  // Until then, a control shows the user's pending change.
  const follow = () => {
    store.program.console.forEach((control, number) => {
      const cell = store.newest?.cells[control.signal];
      if (cell !== undefined && cell !== "" && cell !== cells[number]) {
        cells[number] = cell;
        shown[number]?.show(cell);
      }
    });
  };
  const cells: string[] = [];
  /** Makes `follow` show the program's values again instead of the values that the user
   * requested. */
  const forget = () => {
    cells.length = 0;
  };
  const lookedAt = note(
    "This page can only watch the robot. To operate it, start the run with --view=control.",
  ).host;
  const show = () => {
    const {
      operates,
      program: { live },
      run,
    } = store;
    const isLookedAt = live && run !== null && !run.sends;
    for (const each of seen) each.host.hidden = !operates;
    if (isLookedAt) host.prepend(lookedAt);
    else lookedAt.remove();
    host.hidden = seen.length === 0 || !(operates || isLookedAt);
    host.inert = store.contact.isLost;
    if (!operates || store.contact.isLost) releaseAll();
  };
  store.on("extent", follow);
  store.on("run", show);
  store.on("contact", show);
  store.on("undone", forget);
  store.on("resumed", forget);
  window.addEventListener("pagehide", releaseAll);
  window.addEventListener("blur", releaseAll);
  document.addEventListener("visibilitychange", releaseAll);
  show();
}

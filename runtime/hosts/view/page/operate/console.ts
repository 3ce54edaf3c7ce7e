// What the program asks its operator for: buttons, knobs and toggles, while a run goes on that this
// page operates. Clicks on the map are the map's.
import type { Control } from "../protocol";
import type { Store } from "../store";
import { formatNumber } from "../values";

/** How often a button that is held says so, in ms: it is let go of after 300 without. */
const renewal = 100;
/** How often a knob that is turned says so, in ms. */
const pace = 50;
const steps = 200;

/** One thing on the console: what is shown of it, and how that follows the program's input. */
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
  host.title = `${control.label}: as long as it is held down`;
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
    // Not while it is being turned.
    if (timer !== undefined || slider.matches(":active")) return;
    slider.value = cell;
    draw();
  };
  return { host, show, release: nothing };
}

function text(control: Control): Shown {
  const host = document.createElement("p");
  host.textContent = control.kind === "map" ? "Clicks on the map go to the program." : "";
  return { host, show: nothing, release: nothing };
}

export function startConsole(store: Store, host: HTMLElement): void {
  const shown = store.program.console.map((control, number) => {
    const touch = (x: number) => store.command(`touch ${number} ${x} 0`);
    switch (control.kind) {
      case "button":
        return button(control, () => touch(1));
      case "hold":
        return holdButton(control, (x) => store.command(`hold ${number} ${x}`));
      case "knob":
        return knob(control, touch);
      case "toggle":
        return toggle(control, touch);
      case "map":
      case "camera":
        return text(control);
    }
  });
  const isAsked = store.program.console.some(({ kind }) => kind !== "camera");
  const releaseAll = () => {
    for (const each of shown) each.release();
  };
  host.append(...shown.map((each) => each.host));

  // What is in the program's input counts, whoever did it; but not while that is on its way.
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
  const note = document.createElement("p");
  note.textContent = "This robot is only looked at. --view=control lets a page operate it.";
  const show = () => {
    const {
      operates,
      program: { live },
      run,
    } = store;
    const isLookedAt = live && run !== null && !run.sends;
    shown.forEach((each, i) => {
      each.host.hidden = !operates || store.program.console[i]?.kind === "camera";
    });
    if (isLookedAt) host.prepend(note);
    else note.remove();
    host.hidden = !isAsked || !(operates || isLookedAt);
    if (!operates) releaseAll();
  };
  store.on("extent", follow);
  store.on("run", show);
  window.addEventListener("pagehide", releaseAll);
  window.addEventListener("blur", releaseAll);
  document.addEventListener("visibilitychange", releaseAll);
  show();
}

// Plays the run, handles the playback buttons, and displays the current instant.
import type { Store } from "../store";
import { formatNumber, formatTime } from "../values";

const speeds = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no ${id}`);
  return found as T;
}

export class Player {
  private seconds = 0;
  private before = 0;
  private readonly speed = element<HTMLSelectElement>("speed");

  constructor(private readonly store: Store) {
    const press = (id: string, act: () => void) => (element(id).onclick = act);
    press("start", () => store.goTo(0));
    press("back", () => store.stepBy(-1));
    press("play", () => this.toggle());
    press("forward", () => store.stepBy(1));
    press("end", () => this.toEnd());
    for (const speed of speeds) this.speed.append(new Option(`${speed}×`, String(speed)));
    this.speed.onchange = () => this.setSpeed(Number(this.speed.value));
    this.setSpeed(1);
    store.on("instant", () => this.tell());
    store.on("mark", () => this.tell());
  }

  toggle(): void {
    const { store } = this;
    const { end, start } = store.program;
    store.playing = !store.playing;
    const play = element("play");
    play.ariaPressed = String(store.playing);
    play.ariaLabel = store.playing ? "Pause" : "Play";
    if (!store.playing) return;
    const now = store.instant?.time ?? start;
    this.seconds = now >= end ? start : now;
    this.before = performance.now();
    requestAnimationFrame((at) => this.advance(at));
  }

  private advance(at: number): void {
    const { store } = this;
    if (!store.playing) return;
    this.seconds += (Math.max(0, at - this.before) / 1000) * store.speed;
    this.before = at;
    store.goToTime(Math.min(this.seconds, store.program.end));
    if (this.seconds >= store.program.end) {
      this.toggle();
      store.follow();
    } else requestAnimationFrame((next) => this.advance(next));
  }

  /** Goes to the end; in a live run, follows the newest instant. */
  toEnd(): void {
    const { store } = this;
    if (store.program.live) store.follow();
    else store.goTo(store.program.instants - 1);
  }

  pause(): void {
    if (this.store.playing) this.toggle();
  }

  faster(by: number): void {
    const at = speeds.indexOf(this.store.speed) + by;
    this.setSpeed(speeds[Math.max(0, Math.min(speeds.length - 1, at))] ?? 1);
  }

  private setSpeed(speed: number): void {
    this.store.speed = speed;
    this.speed.value = String(speed);
  }

  private tell(): void {
    const { instant, mark } = this.store;
    if (!instant) return;
    element("now").textContent =
      `instant ${instant.k}  ·  ${formatTime(instant.time)}  ·  dt ${formatNumber(instant.dt)} s`;
    element("apart").textContent = mark
      ? `Δ ${instant.k - mark.k} instants  ·  ${formatTime(instant.time - mark.time)}`
      : "";
  }
}

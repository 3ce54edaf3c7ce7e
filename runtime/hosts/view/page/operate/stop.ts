// The Stop button and its result. It says "stopped" only when the process that drives the robot has
// confirmed it.
import type { Store } from "../store";

/** Maximum time that the host may take to acknowledge a stop, in ms. */
const patience = 500;
const period = 50;

/** Messages that say how a run ended. */
const fates = {
  "at rest": "Stopped.",
  told: "A stop command was sent to the robot, but it may still be moving.",
  "not reached": "Not reached: the run is over, but the stop command did not reach the robot.",
  gone:
    "The process that ran the program has ended without a result. " +
    "This page does not know what the robot is doing.",
};

type State = "not asked" | "asked" | "missed" | "stopping" | "over";

const labels: Readonly<Record<State, string>> = {
  "not asked": "Stop",
  asked: "Stopping …",
  missed: "Not reached",
  stopping: "Stopping …",
  over: "Stop",
};

export class Stop {
  /** The time at which the user requested the stop, according to the page's clock; null if it was
   * not requested. */
  private asked: number | null = null;
  /** Whether the stop was sent on the current connection. */
  private isSent = false;

  constructor(
    private readonly store: Store,
    private readonly button: HTMLButtonElement,
    private readonly said: HTMLElement,
  ) {
    button.onclick = () => this.press();
    store.on("run", () => this.show());
    store.on("contact", () => this.show());
    setInterval(() => this.asked !== null && this.show(), period);
    this.show();
  }

  press(): void {
    if (!this.store.program.live) return;
    this.asked = performance.now();
    this.isSent = this.store.stop();
    this.show();
  }

  private get state(): State {
    const { contact, program } = this.store;
    if (!program.live) return "over";
    if (contact.fate !== "goes on") return "stopping";
    if (this.asked === null) return "not asked";
    return performance.now() - this.asked < patience ? "asked" : "missed";
  }

  private text(state: State): string {
    const { contact } = this.store;
    if (state === "missed")
      return (
        "Stop has not reached the run. The page sends it again as soon as there is contact. " +
        "If the robot is moving, stop it by hand."
      );
    if (state === "stopping" && contact.isLost)
      return "The run was stopping when contact was lost.";
    if (
      state !== "over" ||
      contact.fate === "goes on" ||
      contact.fate === "stopping" ||
      (contact.fate === "at rest" && this.asked === null)
    )
      return "";
    return fates[contact.fate];
  }

  private show(): void {
    const { contact, run } = this.store;
    // Another page may have requested the stop.
    if (run?.stopping && this.asked === null) {
      this.asked = performance.now();
      this.isSent = true;
    }
    if (contact.silent === "connection") this.isSent = false;
    const { state } = this;
    if (this.asked !== null && !this.isSent && state !== "over") this.isSent = this.store.stop();
    const text = this.text(state);
    this.button.hidden = state === "over";
    if (this.button.textContent !== labels[state]) this.button.textContent = labels[state];
    this.button.classList.toggle("missed", state === "missed");
    if (this.said.textContent !== text) this.said.textContent = text;
    this.said.hidden = text === "";
    this.said.classList.toggle("bad", text !== fates["at rest"]);
  }
}

// Monitors the contact between the page and the run. The page must not present old data as current:
// after half a second of silence it turns grey, and shows when the silence began.
//
// Ten times a second, the viewer sends a heartbeat with the state of the host, which is the process
// that runs the program. The viewer reads that state from memory that it shares with the host. In a
// live run, a lack of new instants also counts as silence.
import type { Beat, Live, Program, RunFate } from "./protocol";

/** Maximum silence, in ms. */
const patience = 500;
/** Time between checks, in ms. */
const period = 50;
/** Duration for which the page shows "Contact again", in ms. */
const gladness = 4000;

export type Silent =
  /** There is contact, and instants arrive on time. */
  | "nobody"
  /** The viewer's process does not send anything. */
  | "viewer"
  /** There is no connection to a viewer. */
  | "connection"
  /** The viewer works, but the process that runs the program does not. */
  | "host"
  /** Both processes work, but there are no new instants. */
  | "instants";

export class Contact {
  silent: Silent = "nobody";
  private readonly says = document.createElement("span");
  /** The seconds of silence, hidden from screen readers so that they are not read out every
   * second. */
  private readonly counts = document.createElement("span");
  /** The state of the run, as its host reports it. */
  fate: RunFate = "goes on";
  /** Times of the last sign of life from each source, according to the page's clock. */
  private viewerHeard = performance.now();
  private hostHeard = Infinity;
  private instantHeard = Infinity;
  private instants = 0;
  private isLive = false;
  private isPaused = false;
  /** Maximum time between instants of this run, in ms. */
  private instantPatience = patience;
  private closedAt: number | null = null;
  private isFinal = false;
  /** Time at which the current or last silence began. */
  private since = -Infinity;
  /** Time at which the last silence ended. */
  private until = -Infinity;
  private lastTick = performance.now();
  private wasLate = false;
  /** Total delay of the last checks, which were late because the page was blocked. */
  private lateness = 0;

  constructor(
    private readonly box: HTMLElement,
    /** Called when `silent` or `fate` has changed. */
    private readonly changed: () => void,
  ) {
    this.says.role = "alert";
    this.counts.ariaHidden = "true";
    box.append(this.says, this.counts);
    setInterval(() => this.tick(), period);
  }

  /** Whether a command from the page would be lost now, because no process would execute it. */
  get isLost(): boolean {
    return this.silent !== "nobody" && this.silent !== "instants";
  }

  /** The time at which the silence began, formatted for display. */
  get sinceWhen(): string {
    return new Date(Date.now() - (performance.now() - this.since)).toLocaleTimeString();
  }

  /** Must be called for each message that the viewer sends. */
  heard(): void {
    this.viewerHeard = performance.now();
    this.closedAt = null;
  }

  beat({ silence, fate }: Beat): void {
    if (silence !== undefined) this.hostHeard = performance.now() - (silence ?? Infinity) * 1000;
    if (fate !== undefined && fate !== this.fate) {
      this.fate = fate;
      this.changed();
    }
  }

  /** Updates the number of instants; `seconds` is the real time between two instants. */
  extent({ instants, live }: Program | Live, seconds: number): void {
    this.isLive = live;
    this.instantPatience = Math.max(patience, 3000 * seconds);
    if (instants > this.instants) this.instantHeard = performance.now();
    this.instants = instants;
  }

  /** A paused run has no new instants, so their absence is not silence. */
  pause(isPaused: boolean): void {
    if (this.isPaused && !isPaused) this.expectInstants();
    this.isPaused = isPaused;
  }

  /** Restarts the timeout for new instants. Must be called when the page requests them or the run
   * is resumed. */
  expectInstants(): void {
    if (this.instants > 0) this.instantHeard = performance.now();
  }

  closed(isFinal: boolean): void {
    this.isFinal = isFinal;
    this.closedAt ??= performance.now();
    this.look();
  }

  private tick(): void {
    const now = performance.now();
    const late = Math.max(0, now - this.lastTick - period),
      isLate = late > 2 * period;
    this.lateness = late + (this.wasLate ? this.lateness : 0);
    this.lastTick = now;
    // If the page was blocked, skips one check, so that the page first reads the messages that
    // arrived in the meantime.
    if (isLate && !this.wasLate) {
      this.wasLate = true;
      return;
    }
    this.wasLate = false;
    this.look();
    this.tell(now);
  }

  private look(): void {
    const now = performance.now();
    const before = this.silent;
    const since = this.judge(now);
    if (this.silent === before) return;
    if (this.silent === "nobody") this.until = now;
    else if (before === "nobody") {
      this.since = since;
      // The time from the start of the silence until the page reports it, and the part of that time
      // during which the page was blocked.
      this.box.dataset["after"] = (now - since).toFixed(0);
      this.box.dataset["late"] = this.lateness.toFixed(0);
    }
    document.body.classList.toggle("silent", this.silent !== "nobody");
    this.changed();
    this.tell(now);
  }

  /** Sets `silent`, and returns the time at which the silence began. A finished run may be
   * silent. */
  private judge(now: number): number {
    if (this.closedAt !== null) {
      this.silent = "connection";
      return Math.min(this.closedAt, this.viewerHeard);
    }
    if (now - this.viewerHeard > patience) {
      this.silent = "viewer";
      return this.viewerHeard;
    }
    if (this.isLive && now - this.hostHeard > patience) {
      this.silent = "host";
      return this.hostHeard;
    }
    if (
      this.isLive &&
      !this.isPaused &&
      !document.hidden &&
      now - this.instantHeard > this.instantPatience
    ) {
      this.silent = "instants";
      return this.instantHeard;
    }
    this.silent = "nobody";
    return now;
  }

  private tell(now: number): void {
    const { box, counts, says, silent } = this;
    const isBack = silent === "nobody" && now - this.until < gladness;
    const text = this.isFinal
      ? replaced
      : isBack
        ? `Contact again, after ${((this.until - this.since) / 1000).toFixed(1)} s.`
        : silent === "nobody"
          ? ""
          : `${silent === "instants" ? "No new instant" : "No contact"} since ${this.sinceWhen}: ` +
            `${reasons[silent]} The page shows the last known state.`;
    const count =
      silent === "nobody" || text === "" ? "" : ` (${((now - this.since) / 1000).toFixed(0)} s)`;
    if (says.textContent !== text) says.textContent = text;
    if (counts.textContent !== count) counts.textContent = count;
    box.hidden = text === "";
    box.classList.toggle("good", isBack);
  }
}

const replaced = "Another viewer answers at this address. Open the address that it printed.";

const reasons: Readonly<Record<Exclude<Silent, "nobody">, string>> = {
  viewer: "the viewer does not respond.",
  connection:
    "the page cannot reach the viewer and keeps trying. If the viewer has ended, start it again and " +
    "open the address that it prints.",
  host: "the process that runs the program does not respond.",
  instants: "the program has not taken a step.",
};

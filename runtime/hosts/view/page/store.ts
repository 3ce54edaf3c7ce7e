// The state of the page, and the listeners for its changes.
import type { Connection } from "./connection";
import type { Contact } from "./contact";
import type {
  Claim,
  Claims,
  Found,
  Instant,
  Live,
  Path,
  Picture,
  Place,
  Program,
  Run,
  Series,
  Way,
  WhatIf,
  Why,
} from "./protocol";

type Listener = () => void;
export type Change =
  | "instant"
  | "mark"
  | "range"
  | "plotted"
  | "spans"
  | "what-if"
  | "extent"
  | "following"
  | "run"
  | "why"
  | "place"
  | "claims"
  /** "contact": contact was lost or is back; "resumed": contact is back, perhaps with much data. */
  | "contact"
  | "resumed"
  /** A command was not executed. */
  | "undone";

/** Seconds that plots show initially during a live run. */
const recently = 20;

function withoutOthers<T extends { readonly others?: unknown }>(answer: T): Omit<T, "others"> {
  const { others: _, ...rest } = answer;
  return rest;
}

export class Store {
  instant: Instant | null = null;
  /** The marked instant, with which others are compared. */
  mark: Instant | null = null;
  /** The time range of plots, in seconds. */
  range: readonly [number, number];
  /** The numbers of the signals that are plotted, in order. */
  plotted: number[] = [];
  playing = false;
  speed = 1;

  /** The times at which the current search condition holds: alternating start and end. */
  spans: readonly number[] = [];

  /** The results of the program's assertions. */
  claims: readonly Claim[] = [];

  /** The edited program's result; null before any was requested. */
  whatIf: WhatIf | null = null;
  /** Whether keys go to the program's editor. */
  isEditing = false;

  /** The explanation of the last explained value; null if there is none. */
  why: Why | null = null;
  /** Explains a signal that is clicked; null if a click plots it instead. */
  asker: ((signal: number) => void) | null = null;
  /** The lines of a source to highlight: the equation of the explained value. */
  place: Place | null = null;

  beginAsking: () => void = () => undefined;

  /** Whether the page always shows the newest instant of a live run. */
  following = false;
  /** The newest instant of a live run. */
  newest: Instant | null = null;
  /** The state of a live run; null for a finished one. */
  run: Run | null = null;
  /** Seconds that plots currently show while the run is followed. */
  private recent = recently;

  private shownIn: { width: number; then: (picture: Picture) => void } = {
    width: 1,
    then: () => undefined,
  };
  private pictureIsAsked = false;
  private pictureIsWanted = false;
  /** For the current pixels: the requested width, and their instant. */
  private readonly picture: { width: number; at?: number | undefined } = { width: 0 };
  private finding: ((found: Found) => void)[] = [];
  private readonly paths = new Map<string, (path: Path) => void>();
  private readonly ways = new Map<number, (way: Way) => void>();
  private readonly listeners = new Map<Change, Listener[]>();
  private readonly waiting = new Map<string, (series: Series) => void>();
  /** The instant that the cursor is moving to. */
  private target: number | null = null;
  private outstanding = false;
  private wanted: string | null = null;
  private readonly arrivals: Listener[] = [];

  constructor(
    readonly program: Program,
    private readonly connection: Connection,
    readonly contact: Contact,
    /** Tells the user which command was not executed, and why. */
    private readonly complain: (what: string) => void,
  ) {
    this.range = [program.start, program.end];
  }

  on(change: Change, listener: Listener): void {
    this.listeners.set(change, [...(this.listeners.get(change) ?? []), listener]);
  }

  changed(change: Change): void {
    for (const listener of this.listeners.get(change) ?? []) listener();
  }

  // Updates the store when a live run has grown.

  grew(live: Live): void {
    const { program } = this;
    const isNews = program.live !== live.live;
    program.instants = live.instants;
    program.start = live.start;
    program.end = live.end;
    program.live = live.live;
    if (!live.live) this.run = null;
    this.newest = live.newest ?? null;
    if (this.following) this.range = this.recentRange();
    this.changed("extent");
    if (this.following) {
      if (live.newest) this.instant = live.newest;
      this.following = live.live;
      this.changed("instant");
    }
    if (isNews) {
      this.changed("run");
      this.changed("following");
    }
  }

  private recentRange(): [number, number] {
    const { start, end } = this.program;
    return [Math.max(start, end - this.recent), end];
  }

  /** Shows the newest instant from now on. */
  follow(): void {
    if (!this.program.live || this.following) return;
    this.following = true;
    this.range = this.recentRange();
    this.changed("range");
    this.changed("following");
  }

  private leave(): void {
    if (!this.following) return;
    this.following = false;
    this.changed("following");
  }

  runsOn(run: Run): void {
    this.run = run;
    this.changed("run");
  }

  /** Whether this page operates the run. */
  get operates(): boolean {
    return this.program.live && this.run !== null && this.run.operates && this.run.sends;
  }

  /** Sends a command of control.h to the run, immediately or not at all. If it cannot be sent, the
   *  page says so, and this returns false. */
  command(request: string): boolean {
    const isSent = !this.contact.isLost && this.connection.command(request);
    if (!isSent) this.undone("not done: no contact with the run");
    return isSent;
  }

  undone(why: string): void {
    this.complain(why);
    this.changed("undone");
  }

  /** Sends a stop even without contact to the host. Returns false if there is no connection. */
  stop(): boolean {
    return this.connection.command("stop");
  }

  // Moves the cursor. Only one request is pending at a time; of requests made meanwhile only the
  // last is sent.

  goTo(k: number, then?: Listener): void {
    this.leave();
    if (this.program.instants === 0) return;
    const last = this.program.instants - 1;
    this.target = Math.max(0, Math.min(last, Math.round(k)));
    this.ask(`instant ${this.target}`, then);
  }

  goToTime(seconds: number, then?: Listener): void {
    this.leave();
    if (this.program.instants === 0) return;
    this.target = null;
    this.ask(`time ${seconds}`, then);
  }

  stepBy(instants: number): void {
    this.goTo((this.target ?? this.instant?.k ?? 0) + instants);
  }

  private ask(request: string, then?: Listener): void {
    if (then) this.arrivals.push(then);
    if (this.outstanding) {
      this.wanted = request;
      return;
    }
    this.outstanding = true;
    this.connection.ask(request);
  }

  arrived(instant: Instant): void {
    // Another page may have an edited program where this one has none.
    if (!this.following) this.instant = this.whatIf?.there ? instant : withoutOthers(instant);
    this.outstanding = false;
    if (this.wanted !== null) {
      const request = this.wanted;
      this.wanted = null;
      this.ask(request);
    } else {
      this.target = null;
      for (const then of this.arrivals.splice(0)) then();
    }
    this.changed("instant");
  }

  setMark(mark: Instant | null): void {
    this.mark = mark;
    this.changed("mark");
  }

  // Sets the range of plots.

  setRange(from: number, to: number): void {
    this.leave();
    this.range = [Math.max(this.program.start, from), Math.min(this.program.end, to)];
    this.changed("range");
  }

  /** Shows the whole run; while the run is followed, toggles between the whole run and the last
   * seconds. */
  showAll(): void {
    if (!this.following) {
      this.setRange(this.program.start, this.program.end);
      return;
    }
    this.recent = this.recent === recently ? Infinity : recently;
    this.range = this.recentRange();
    this.changed("range");
  }

  toggle(signal: number): void {
    const at = this.plotted.indexOf(signal);
    if (at >= 0) this.plotted.splice(at, 1);
    else this.plotted.push(signal);
    this.changed("plotted");
  }

  /** Handles a click on a signal. */
  pick(signal: number): void {
    if (this.asker) this.asker(signal);
    else this.toggle(signal);
  }

  // Explains a signal's value.

  wonder(signal: number): void {
    if (!this.asker) this.beginAsking();
    this.asker?.(signal);
  }

  askWhy(signal: number, k: number): void {
    this.connection.ask(`why ${k} ${signal}`);
  }

  whyReceived(why: Why): void {
    if (!this.asker) return;
    this.why = why;
    this.changed("why");
  }

  show(place: Place | null): void {
    this.place = place;
    this.changed("place");
  }

  series(
    signal: number,
    from: number,
    to: number,
    width: number,
    then: (series: Series) => void,
  ): void {
    this.waiting.set(`${signal} ${from} ${to}`, then);
    this.connection.ask(`series ${signal} ${from} ${to} ${Math.max(1, Math.round(width))}`);
  }

  received(series: Series): void {
    const key = `${series.signal} ${series.from} ${series.to}`;
    const then = this.waiting.get(key);
    this.waiting.delete(key);
    then?.(this.whatIf?.there ? series : withoutOthers(series));
  }

  way(robot: number, count: number, then: (way: Way) => void): void {
    this.ways.set(robot, then);
    this.connection.ask(`way ${robot} ${count}`);
  }

  wayReceived(way: Way): void {
    this.ways.get(way.robot)?.(way);
  }

  path(x: number, y: number, count: number, then: (path: Path) => void): void {
    this.paths.set(`${x} ${y}`, then);
    this.connection.ask(`path ${x} ${y} ${count}`);
  }

  pathReceived(path: Path): void {
    this.paths.get(`${path.x} ${path.y}`)?.(this.whatIf?.there ? path : withoutOthers(path));
  }

  // Requests the picture of the current instant. Only one request is pending at a time.

  askPicture(width: number, then: (picture: Picture) => void): void {
    this.shownIn = { width, then };
    if (!this.pictureIsAsked) this.askNextPicture();
    else this.pictureIsWanted = true;
  }

  private askNextPicture(): void {
    const { width } = this.shownIn;
    // While a run is followed, requests the newest picture.
    const k = this.following ? "newest" : this.instant?.k;
    if (k === undefined) return;
    const has = this.picture.width === width ? (this.picture.at ?? -1) + 1 : 0;
    this.pictureIsWanted = false;
    this.pictureIsAsked = true;
    this.picture.width = width;
    this.connection.ask(`picture ${k} ${width} ${has}`);
  }

  pictureReceived(picture: Picture): void {
    this.pictureIsAsked = false;
    if (picture.lost || picture.at === undefined) this.picture.at = undefined;
    else if (picture.data) this.picture.at = picture.at;
    this.shownIn.then(picture);
    if (this.pictureIsWanted) this.askNextPicture();
  }

  // Searches for a condition. Answers arrive in the order of the questions.

  find(condition: string, then: (found: Found) => void): void {
    this.finding.push(then);
    this.connection.ask(`find ${this.instant?.k ?? 0} ${condition}`);
  }

  found(found: Found): void {
    this.finding.shift()?.(found);
  }

  setSpans(spans: readonly number[]): void {
    this.spans = spans;
    this.changed("spans");
  }

  askClaims(): void {
    this.connection.ask("claims");
  }

  claimsReceived(claims: Claims): void {
    this.claims = claims.all;
    this.changed("claims");
  }

  // Removes the edited program.

  dropWhatIf(): void {
    this.connection.ask("what-if");
  }

  /** Runs the program with parameters set, NAME=VALUE each, on the same inputs or in the simulator
   * from the start. */
  askWhatIf(how: "what-if" | "drive", text: string, settings: readonly string[]): void {
    const set = settings.length > 0 ? `with ${settings.join(" ")} ` : "";
    this.connection.ask(`${set}${how} ${text}`);
  }

  whatIfReceived(whatIf: WhatIf): void {
    this.whatIf = whatIf;
    this.changed("what-if");
    if (this.following && whatIf.first === undefined) return;
    this.goTo(whatIf.first ?? this.instant?.k ?? 0);
  }
}

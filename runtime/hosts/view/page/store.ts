// The state of the page, and the listeners for its changes.
import type { Link } from "./connection";
import type { Contact } from "./contact";
import { axesOf, mostAxes, newPlot, type Plot } from "./plots/model";
import { SeriesRequests } from "./plots/requests";
import type {
  Align,
  Claim,
  Claims,
  Contacts,
  Found,
  Instant,
  Live,
  Other,
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
  | "contacts"
  /** Emitted when the text of the edited program has changed. */
  | "edited"
  /** Emitted when the plots must be resized. */
  | "sizes"
  /** Emitted when the map shows another part of the world. */
  | "view"
  /** "contact": contact was lost or restored; "resumed": contact was restored, possibly with a lot
   * of new data. */
  | "contact"
  | "resumed"
  /** A command was not executed. */
  | "undone";

/** Number of seconds that the plots show initially during a live run. */
const recently = 20;

function withoutOthers<T extends { readonly others?: unknown }>(answer: T): Omit<T, "others"> {
  const { others: _, ...rest } = answer;
  return rest;
}

export class Store {
  instant: Instant | null = null;
  /** The marked instant, with which other instants are compared. */
  mark: Instant | null = null;
  /** The time range of the plots, in seconds. */
  range: readonly [number, number];
  plots: Plot[] = [];
  /** The plot that receives the next signal the user picks; null if that signal gets a plot of its
   * own. */
  target: Plot | null = null;
  playing = false;
  speed = 1;

  /** The times at which the current search condition is true. Starts and ends alternate. */
  spans: readonly number[] = [];

  /** The results of the program's assertions. */
  claims: readonly Claim[] = [];

  /** When and where the simulated robot touched an object. */
  contacts: Contacts["all"] = [];

  /** The edited program's result; null until one is requested. */
  whatIf: WhatIf | null = null;
  /** The recording to compare with; null if there is none. */
  other: Other | null;
  /** Whether the user is editing the program. */
  isEditing = false;
  /** The edited text, which is kept when the editor is closed; null if the text is unchanged. */
  edited: string | null = null;
  continueEditing: (text: string) => void = () => undefined;

  /** The most recent explanation of a value; null if there is none. */
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
  /** Number of seconds that the plots show while the page follows the run. */
  private recent = recently;

  private shownIn: { width: number; then: (picture: Picture) => void } = {
    width: 1,
    then: () => undefined,
  };
  private pictureIsAsked = false;
  private pictureIsWanted = false;
  /** The width requested for the current image, and the instant of that image. */
  private readonly picture: { width: number; at?: number | undefined } = { width: 0 };
  private finding: ((found: Found) => void)[] = [];
  private readonly paths = new Map<string, (path: Path | null) => void>();
  private readonly ways = new Map<number, (way: Way | null) => void>();
  private readonly listeners = new Map<Change, Listener[]>();
  readonly series: SeriesRequests;
  /** The instant or the time that the cursor is moving to. */
  private goal: number | null = null;
  private goalTime: number | null = null;
  private outstanding = false;
  private wanted: string | null = null;
  private readonly arrivals: Listener[] = [];
  private readonly savings = new Map<number, (instant: Instant) => void>();
  private readonly colours = new Map<number, number>();

  constructor(
    readonly program: Program,
    private readonly connection: Link,
    readonly contact: Contact,
    /** Tells the user which command was not executed, and why. */
    private readonly complain: (what: string) => void,
  ) {
    this.range = [program.start, program.end];
    this.other = program.other ?? null;
    this.series = new SeriesRequests((question) => connection.ask(question));
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

  /** Sends a command (see control.h) to the run. If it cannot be sent now, informs the user and
   * returns false. */
  command(request: string): boolean {
    const isSent = !this.contact.isLost && this.connection.command(request);
    if (!isSent) this.undone("not done: no contact with the run");
    return isSent;
  }

  undone(why: string): void {
    this.complain(why);
    this.changed("undone");
  }

  /** Sends the `stop` command even if contact with the host is lost. Returns false if there is no
   * connection to the viewer. */
  stop(): boolean {
    return this.connection.command("stop");
  }

  // Moves the cursor. Only one request is pending at a time. Of the requests made in the meantime,
  // only the last one is sent.

  goTo(k: number, then?: Listener): void {
    this.leave();
    if (this.program.instants === 0) return;
    const last = this.program.instants - 1;
    this.goalTime = null;
    this.goal = Math.max(0, Math.min(last, Math.round(k)));
    this.ask(`instant ${this.goal}`, then);
  }

  goToTime(seconds: number, then?: Listener): void {
    this.leave();
    if (this.program.instants === 0) return;
    this.goal = null;
    this.goalTime = seconds;
    this.ask(`time ${seconds}`, then);
  }

  stepBy(instants: number): void {
    this.goTo((this.goal ?? this.instant?.k ?? 0) + instants);
  }

  stepSeconds(seconds: number): void {
    const { start, end } = this.program;
    const from = this.goalTime ?? this.instant?.time ?? start;
    this.goToTime(Math.max(start, Math.min(end, from + seconds)));
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

  /** Requests instants in order to save them, without displaying them. */
  instants(from: number, to: number): Promise<Instant[]> {
    return new Promise((resolve) => {
      const all: Instant[] = [];
      for (let k = from; k < to; k++) {
        this.savings.set(k, (instant) => {
          all.push(instant);
          if (all.length === to - from) resolve(all.sort((a, b) => a.k - b.k));
        });
        this.connection.ask(`cells ${k}`);
      }
    });
  }

  arrived(instant: Instant, question: string): void {
    if (question.startsWith("cells ")) {
      this.savings.get(instant.k)?.(instant);
      this.savings.delete(instant.k);
      return;
    }
    // Another page may have an edited program even if this page has none.
    if (!this.following) this.instant = this.hasOthers ? instant : withoutOthers(instant);
    this.outstanding = false;
    if (this.wanted !== null) {
      const request = this.wanted;
      this.wanted = null;
      this.ask(request);
    } else {
      this.goal = this.goalTime = null;
      for (const then of this.arrivals.splice(0)) then();
    }
    this.changed("instant");
  }

  /** Whether this page shows values of an edited program or of another recording. */
  get hasOthers(): boolean {
    return this.other !== null || (this.whatIf?.there ?? false);
  }

  /** The label for values from the edited program or the other recording. */
  get otherWord(): string {
    return this.whatIf?.there ? "what if" : "other";
  }

  /** The name of the other recording, or "edited" for the edited program. */
  get otherName(): string {
    return this.whatIf?.there ? "edited" : (this.other?.name ?? "");
  }

  /** Aligns the other recording at the instant when a condition first holds or, if the condition is
   * empty, at its start. */
  align(condition: string): void {
    this.connection.ask(condition === "" ? "align" : `align ${condition}`);
  }

  aligned({ other }: Align): void {
    this.other = other ?? null;
    this.changed("what-if");
    this.goTo(this.instant?.k ?? 0);
  }

  setMark(mark: Instant | null): void {
    this.mark = mark;
    this.changed("mark");
  }

  // Sets the range of the plots.

  setRange(from: number, to: number): void {
    this.leave();
    this.range = [Math.max(this.program.start, from), Math.min(this.program.end, to)];
    this.changed("range");
  }

  /** Shows a longer or shorter part of the run in the plots, around the current instant. */
  zoom(factor: number): void {
    const [from, to] = this.range;
    const middle = Math.max(from, Math.min(to, this.instant?.time ?? from));
    this.setRange(middle - (middle - from) * factor, middle + (to - middle) * factor);
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

  // Changes the plots.

  /** The numbers of the signals that are plotted, in order. */
  get plotted(): number[] {
    return this.plots.flatMap(({ signals }) => signals);
  }

  /** Returns the number of a signal's colour in plots. It is the lowest number that was free when
   * the signal was first plotted. */
  colourOf(signal: number): number {
    const known = this.colours.get(signal);
    if (known !== undefined) return known;
    const plotted = new Set(this.plotted);
    for (const other of this.colours.keys()) if (!plotted.has(other)) this.colours.delete(other);
    const used = new Set(this.colours.values());
    let free = 0;
    while (used.has(free)) free++;
    this.colours.set(signal, free);
    return free;
  }

  setPlots(plots: Plot[]): void {
    this.plots = plots;
    if (this.target && !plots.includes(this.target)) this.target = null;
    this.changed("plotted");
  }

  /** Plots a signal, or removes it from all plots. */
  toggle(signal: number): void {
    if (this.plotted.includes(signal)) {
      for (const plot of this.plots) plot.signals = plot.signals.filter((each) => each !== signal);
      for (const plot of this.plots) plot.isXy &&= plot.signals.length > 1;
      this.setPlots(this.plots.filter(({ signals }) => signals.length > 0));
    } else if (!this.target || !this.addTo(this.target, signal)) {
      this.setPlots([...this.plots, newPlot([signal])]);
    }
  }

  /** Adds a signal to a plot, unless that would require a third axis. */
  addTo(plot: Plot, signal: number): boolean {
    if (plot.signals.includes(signal)) return true;
    const signals = [...plot.signals, signal];
    if (axesOf(signals, this.program).length > mostAxes) {
      this.complain("a plot has at most two axes, so it can show at most two different units");
      return false;
    }
    plot.signals = signals;
    this.changed("plotted");
    return true;
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

  received(series: Series): void {
    this.series.received(this.hasOthers ? series : withoutOthers(series));
  }

  /** Handles the viewer's refusal to answer a question. Returns false if the user should see it. */
  refused(question: string): boolean {
    const [word, ...numbers] = question.split(" ");
    const [first = 0, second = 0, third = 0] = numbers.map(Number);
    if (word === "series") this.series.end(first, second, third);
    else if (word === "path") this.paths.get(`${first} ${second}`)?.(null);
    else if (word === "way") this.ways.get(first)?.(null);
    return word === "series" || word === "path" || word === "way" || word === "keep";
  }

  way(robot: number, count: number, from: number, then: (way: Way | null) => void): void {
    this.ways.set(robot, then);
    this.connection.ask(`way ${robot} ${count} ${from}`);
  }

  wayReceived(way: Way): void {
    this.ways.get(way.robot)?.(way);
  }

  path(x: number, y: number, count: number, from: number, then: (path: Path | null) => void): void {
    this.paths.set(`${x} ${y}`, then);
    this.connection.ask(`path ${x} ${y} ${count} ${from}`);
  }

  pathReceived(path: Path): void {
    this.paths.get(`${path.x} ${path.y}`)?.(this.hasOthers ? path : withoutOthers(path));
  }

  // Requests the picture of the current instant. Only one request is pending at a time.

  askPicture(width: number, then: (picture: Picture) => void): void {
    this.shownIn = { width, then };
    if (!this.pictureIsAsked) this.askNextPicture();
    else this.pictureIsWanted = true;
  }

  private askNextPicture(): void {
    const { width } = this.shownIn;
    // While the page follows a live run, requests the newest picture.
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

  askContacts(): void {
    this.connection.ask("contacts");
  }

  contactsReceived(contacts: Contacts): void {
    this.contacts = contacts.all;
    this.changed("contacts");
  }

  // Removes the edited program.

  dropWhatIf(): void {
    this.changed("edited");
    this.connection.ask("what-if");
  }

  /** Runs the program with the given parameters, each as NAME=VALUE, on the same inputs, or in the
   * simulator from the start. */
  askWhatIf(how: "what-if" | "drive", text: string, settings: readonly string[]): void {
    const set = settings.length > 0 ? `with ${settings.join(" ")} ` : "";
    this.connection.ask(`${set}${how} ${text}`);
  }

  whatIfReceived(whatIf: WhatIf): void {
    this.whatIf = whatIf;
    this.changed("what-if");
    if (this.following) return;
    this.goTo(this.instant?.k ?? 0);
  }
}

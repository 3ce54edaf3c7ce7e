// The page: connects to the viewer, and starts the panels.
import { token } from "./address";
import { startCamera } from "./camera/camera";
import { Connection, type Link, type Listener } from "./connection";
import { startComparison } from "./compare";
import { Contact } from "./contact";
import { startClaims } from "./signals/claims";
import { startCollisions } from "./signals/collisions";
import { startConsole } from "./operate/console";
import { Kept } from "./kept";
import { startKeys } from "./keys";
import { Layout } from "./layout";
import { startLive } from "./operate/live";
import { Player } from "./time/player";
import { startMap } from "./map/map";
import { startPlots } from "./plots/plots";
import type { Align, Answer, Live, Program, Progress, Run } from "./protocol";
import { startSearch } from "./time/search";
import { startSignals } from "./signals/signals";
import { withRadians } from "./source/angles";
import { startSource } from "./source/source";
import { restore, restorePlots } from "./restore";
import { startSaving } from "./save/save";
import { Saved } from "./save/saved";
import { Store } from "./store";
import { startTheme, toggleTheme } from "./theme";
import { startTimeline } from "./time/timeline";
import { formatNumber } from "./values";

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no ${id}`);
  return found as T;
}

/** Time for which the page shows an error message, in ms. */
const attention = 4000;
let complaint: { readonly text: string; readonly until: number } | null = null;

function showState(text: string, isGood: boolean): void {
  const isComplaint = complaint !== null && performance.now() < complaint.until;
  element("state").textContent = isComplaint && complaint ? complaint.text : text;
  element("state").classList.toggle("bad", isComplaint || !isGood);
}

function complain(text: string): void {
  complaint = { text, until: performance.now() + attention };
  showProgress();
  setTimeout(showProgress, attention + 1);
}

function describe(program: Program): void {
  document.title = `${program.name} – Frob`;
  element("program").textContent = program.name;
  describeRun(program);
}

function describeRun(program: Program): void {
  const isSet = program.params.filter(({ value, first }) => value !== first);
  element("run").textContent = [
    program.recording,
    program.robot,
    `${program.instants} instants, ${formatNumber(program.end - program.start)} s`,
    ...isSet.map(({ name, value }) => `${name}=${value}`),
  ]
    .filter((part) => part !== "")
    .join("  ·  ");
}

let showAlignment: ((answer: Align) => void) | null = null;

/** The latest status message from the viewer. */
let progress: Program | Progress | Live | null = null;
/** The reason why the connection was closed permanently. */
let refusal = "";

function showProgress(): void {
  const program = store?.program;
  if (refusal !== "") {
    showState(refusal, false);
    return;
  }
  if (contact.isLost) showState(`no contact since ${contact.sinceWhen}`, false);
  else if (!program || !progress) return;
  else {
    const notes = progress.notes.trimEnd();
    element("notes").textContent = notes;
    element("notes").hidden = notes === "";
    const diverged = /^diverged at instant \d+/m.exec(notes);
    const isWhole = progress.replayed >= program.instants;
    if (diverged) showState(diverged[0], false);
    else if (!program.runs) showState("as recorded; the program does not match", false);
    else if (contact.silent === "instants")
      showState(`no new instant since ${contact.sinceWhen}`, false);
    else if (program.live && program.instants === 0) showState("no instant yet", true);
    else if (program.live) showState("live: outputs as computed", true);
    else if (!isWhole) showState("replaying …", true);
    else if (!program.compared) showState("replayed", true);
    else if (program.recording === "") showState("the replay has the same outputs", true);
    else showState("replayed: outputs as recorded", true);
  }
}

/** Explains why there is no run to show, and what the user can do. */
function say(title: string, text: string): void {
  const head = document.createElement("h2"),
    body = document.createElement("p");
  head.textContent = title;
  body.textContent = text;
  element("opening").replaceChildren(head, body);
}

/** Explains why the viewer refused the page, and what the user can do. */
function sayRefusal(why: string): void {
  if (token() === "")
    say(
      "This address is incomplete",
      "It must end in # and a token of 32 letters and digits. Copy the whole address that frobc " +
        "printed.",
    );
  else if (/token/.test(why))
    say(
      "The token in this address is wrong",
      "The address is incomplete, or it belongs to another viewer, which has ended. Open the address " +
        "that frobc printed last.",
    );
  else if (/too many pages/.test(why))
    say(
      "Too many pages are open",
      "The viewer serves at most four pages. Close one of the others, and this page will connect.",
    );
  else
    say(
      "The viewer does not answer",
      "This page keeps trying. If the viewer has ended, start it again (frobc view RUN.csv FILE, or " +
        "frobc run FILE --view) and open the address that it prints.",
    );
}

/** Hides the panels until there is an instant to show. */
function showOpening(): void {
  const isWaiting = !store || store.program.instants === 0;
  document.body.classList.toggle("opening", isWaiting);
  element("opening").hidden = !isWaiting;
  if (store && isWaiting)
    say(
      store.program.live ? "Waiting for the first instant" : "This recording has no instants",
      store.program.live
        ? "The program has not taken a step yet. With a robot, check that it is connected and turned on."
        : "Record a run with frobc run FILE --record RUN.csv.",
    );
}

/** Selects the panel to show on a screen that has room for only one. */
function choose(panel: string): void {
  document.body.dataset["panel"] = panel;
  for (const button of element("panels").querySelectorAll("button"))
    button.ariaPressed = String(button.dataset["panel"] === panel);
}

function startPanels(): void {
  for (const button of element("panels").querySelectorAll("button"))
    button.onclick = () => choose(button.dataset["panel"] ?? "map");
}

function start(program: Program): Store {
  const store = new Store(program, connection, contact, complain);
  const filter = element<HTMLInputElement>("filter");
  const help = element<HTMLDialogElement>("keys");
  describe(program);
  const kept = new Kept(program.name, program.kept, connection);
  restorePlots(store, kept);
  const why = startSource(store, element("source"));
  startPlots(store, element("plots"));
  startSignals(store, element("list"), filter);
  startClaims(store, element("claims"), element<HTMLButtonElement>("claimed"), filter);
  startCollisions(store, element<HTMLButtonElement>("collisions"));
  const view = startMap(store, element("map"));
  startCamera(store, element("camera"));
  startSearch(
    store,
    element<HTMLInputElement>("find"),
    element("found"),
    element<HTMLButtonElement>("before"),
    element<HTMLButtonElement>("after"),
  );
  startTimeline(store, element("timeline"));
  startKeys(
    store,
    new Player(store),
    filter,
    element<HTMLInputElement>("find"),
    why,
    help,
    startLive(store),
  );
  startConsole(store, element("console"));
  showAlignment = startComparison(store, element("compare"));
  startSaving(
    store,
    kept,
    element<HTMLButtonElement>("save"),
    element<HTMLDialogElement>("saving"),
  );
  element("help").onclick = () => {
    help.showModal();
    help.scrollTop = 0;
  };
  choose(view ? "map" : "plots");
  restore(store, kept, new Layout(), view);
  return store;
}

let store: Store | null = null;
/** The state of the run. It may arrive before there is a store. */
let run: Run | null = null;

/** Handles the program message on a new connection to the same viewer. */
function reconnected(store: Store, program: Program): void {
  if (program.live) store.program.live = true;
  store.grew({ ...program, is: "live" });
  store.askClaims();
}

function extend(extent: Program | Live): void {
  const newest = store?.newest;
  contact.extent(extent, (newest?.dt ?? 0) / (run?.speed ?? 1));
}

/** Returns the pause between frames, in ms. `speed` is the speed of the run relative to real time.
 * A fast run needs pauses because drawing competes with it for processor time. */
function pauseAt(speed: number): number {
  return speed > 100 ? 200 : speed > 20 ? 100 : 0;
}

function more(): void {
  connection.more();
  contact.expectInstants();
}

function answered(answer: Answer, question: string): void {
  contact.heard();
  switch (answer.is) {
    case "beat":
      contact.beat(answer);
      break;
    case "program":
      progress = answer;
      // Shows the panels first, because building the plots requires their sizes.
      if (answer.instants > 0) document.body.classList.remove("opening");
      if (store) reconnected(store, answer);
      else store = start(withRadians(answer));
      extend(answer);
      if (run) store.runsOn(run);
      showOpening();
      showProgress();
      break;
    case "progress":
      if (!store) break;
      progress = answer;
      showProgress();
      store.askClaims();
      break;
    case "live":
      // Requests the next instant after drawing this one.
      requestAnimationFrame(() => setTimeout(more, pauseAt(run?.speed ?? 1)));
      if (!store) break;
      store.grew(answer);
      extend(answer);
      describeRun(store.program);
      progress = answer;
      showOpening();
      showProgress();
      break;
    case "run":
      run = answer;
      contact.pause(run.paused);
      store?.runsOn(run);
      break;
    case "way":
      store?.wayReceived(answer);
      break;
    case "picture":
      store?.pictureReceived(answer);
      break;
    case "instant":
      store?.arrived(answer, question);
      break;
    case "series":
      store?.received(answer);
      break;
    case "path":
      store?.pathReceived(answer);
      break;
    case "why":
      store?.whyReceived(answer);
      break;
    case "found":
      store?.found(answer);
      break;
    case "claims":
      store?.claimsReceived(answer);
      break;
    case "contacts":
      store?.contactsReceived(answer);
      break;
    case "what-if":
      store?.whatIfReceived(answer);
      break;
    case "keep":
      break;
    case "align":
      showAlignment?.(answer);
      break;
    case "refused":
      if (answer.command && store) store.undone(answer.why);
      else if (!store?.refused(question)) complain(answer.why);
      break;
  }
}

let wasSilent = false;

function contactChanged(): void {
  const isSilent = contact.silent !== "nobody";
  if (isSilent && !wasSilent) complaint = null;
  const name = store ? `${store.program.name} – Frob` : "Frob";
  document.title = contact.isLost ? `⚠ no contact – ${name}` : name;
  showProgress();
  store?.changed("contact");
  if (wasSilent && !isSilent) store?.changed("resumed");
  wasSilent = isSilent;
}

/** Reports an error in the page itself, so that a broken page does not appear to work. */
function failed(what: string): void {
  // This is harmless: the browser handles the change of size in the next frame instead.
  if (what.startsWith("ResizeObserver loop")) return;
  element("failed").textContent =
    `This page has failed and may show wrong values: ${what}. ` +
    "Reload the page; the run continues without it.";
  element("failed").hidden = false;
}

window.addEventListener("error", (event) => failed(event.message));
window.addEventListener("unhandledrejection", (event) => failed(String(event.reason)));
// Reloads the page when the user opens the address of another viewer in this tab.
const openedWith = token();
window.addEventListener("hashchange", () => {
  if (token() !== openedWith) location.reload();
});
startTheme();
element("theme").onclick = toggleTheme;
startPanels();
const contact = new Contact(element("contact"), contactChanged);
const listener: Listener = {
  answered,
  closed: (why, isFinal) => {
    if (isFinal) refusal = why || "the viewer does not answer this page";
    else if (why !== "" && !store) complain(why);
    contact.closed(isFinal);
    if (!store) sayRefusal(why);
    showProgress();
  },
};
const saved = document.getElementById("saved")?.textContent;
document.body.classList.toggle("saved", saved !== undefined);
const connection: Link = saved ? new Saved(saved, listener) : new Connection(listener);

// The page: what there is, and the panels that show it.
import { startCamera } from "./camera/camera";
import { Connection } from "./connection";
import { startClaims } from "./signals/claims";
import { startConsole } from "./operate/console";
import { startKeys } from "./keys";
import { startLive } from "./operate/live";
import { Player } from "./time/player";
import { startMap } from "./map/map";
import { startPlots } from "./signals/plots";
import type { Answer, Live, Program, Progress, Run } from "./protocol";
import { startSearch } from "./time/search";
import { startSignals } from "./signals/signals";
import { startSource } from "./source/source";
import { Store } from "./store";
import { startTheme, toggleTheme } from "./theme";
import { startTimeline } from "./time/timeline";
import { formatNumber } from "./values";

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no ${id}`);
  return found as T;
}

function showState(text: string, isGood: boolean): void {
  element("state").textContent = text;
  element("state").classList.toggle("bad", !isGood);
}

function describe(program: Program): void {
  document.title = `${program.name} – Frob`;
  element("program").textContent = program.name;
  describeRun(program);
  showProgress(program, program);
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

function showProgress(program: Program, progress: Program | Progress | Live): void {
  const notes = progress.notes.trimEnd();
  element("notes").textContent = notes;
  element("notes").hidden = notes === "";
  const diverged = /^diverged at \d+/m.exec(notes);
  if (diverged) showState(diverged[0], false);
  else if (!program.runs) showState("as recorded; the program does not fit", false);
  else if (progress.replayed < program.instants && !program.live) showState("replaying …", true);
  else if (program.live) showState("live: outputs as computed", true);
  else showState(program.compared ? "replayed: outputs as recorded" : "replayed", true);
}

/** What to see at first: what the program puts out. */
function firstPlots(program: Program): number[] {
  const numbers = program.signals.map((_, number) => number);
  return numbers.filter((number) => program.signals[number]?.side === "output").slice(0, 4);
}

/** Of the panels, the one that is seen where there is room for one. */
function choose(panel: string): void {
  document.body.dataset["panel"] = panel;
  for (const button of element("panels").querySelectorAll("button"))
    button.ariaPressed = String(button.dataset["panel"] === panel);
}

function startPanels(): void {
  for (const button of element("panels").querySelectorAll("button"))
    button.onclick = () => choose(button.dataset["panel"] ?? "plots");
  choose("plots");
}

function start(program: Program): Store {
  const store = new Store(program, connection);
  const filter = element<HTMLInputElement>("filter");
  const help = element<HTMLDialogElement>("keys");
  describe(program);
  store.plotted = firstPlots(program);
  const why = startSource(store, element("source"));
  startPlots(store, element("plots"));
  startSignals(store, element("list"), filter);
  startClaims(store, element("claims"), element<HTMLButtonElement>("claimed"), filter);
  startMap(store, element("map"));
  startCamera(store, element("camera"));
  startSearch(
    store,
    element<HTMLInputElement>("find"),
    element("found"),
    element<HTMLButtonElement>("before"),
    element<HTMLButtonElement>("after"),
  );
  startTimeline(store, element("timeline"));
  startKeys(store, new Player(store), filter, element<HTMLInputElement>("find"), why, help);
  startLive(store);
  startConsole(store, element("console"));
  element("help").onclick = () => help.showModal();
  // Who drives looks where the robot goes.
  if (program.live && program.console.length > 0) choose("map");
  if (program.live) store.follow();
  else store.goToTime(program.at);
  return store;
}

let store: Store | null = null;
/** May be told before there is a store. */
let run: Run | null = null;

function answered(answer: Answer): void {
  switch (answer.is) {
    case "program":
      store = start(answer);
      if (run) store.runsOn(run);
      break;
    case "progress":
      if (!store) break;
      showProgress(store.program, answer);
      store.askClaims();
      break;
    case "live":
      // The next one when this has been drawn.
      requestAnimationFrame(() => connection.ask("more"));
      if (!store) break;
      store.grew(answer);
      describeRun(store.program);
      showProgress(store.program, answer);
      break;
    case "run":
      run = answer;
      store?.runsOn(run);
      break;
    case "way":
      store?.wayReceived(answer);
      break;
    case "picture":
      store?.pictureReceived(answer);
      break;
    case "instant":
      store?.arrived(answer);
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
    case "what-if":
      store?.whatIfReceived(answer);
      break;
    case "refused":
      showState(answer.why, false);
      break;
  }
}

startTheme();
element("theme").onclick = toggleTheme;
startPanels();
const connection = new Connection(answered, (why) => showState(why, false));

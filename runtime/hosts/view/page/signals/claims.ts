// The program's assertions: the result of each, and where it was violated. A click goes to a
// violation.
import type { Claim, Fate } from "../protocol";
import type { Store } from "../store";

/** Interval, in ms, at which the results of a live run are requested. */
const every = 500;

/** Returns the CSS class for the severity of a result. */
function kindOf(fate: Fate, isAssumed: boolean): string {
  if (fate.failed) return isAssumed ? "failed" : "violated";
  return fate.open || !fate.asked ? "undecided" : "held";
}

function counted(number: number, what: string): string {
  return `${number} ${what}${number === 1 ? "" : "s"}`;
}

/** Summarizes all results in one line. */
function inShort(claims: readonly Claim[], isLive: boolean): string {
  const asserted = claims.filter(({ assumed }) => !assumed);
  const violated = asserted.filter(({ fate }) => fate.failed).length;
  const failed = claims.filter(({ assumed, fate }) => assumed && fate.failed).length;
  const bad = [
    ...(violated > 0 ? [`${violated} of ${counted(asserted.length, "assertion")} violated`] : []),
    ...(failed > 0 ? [`${counted(failed, "assumption")} failed`] : []),
  ];
  if (bad.length > 0) return bad.join(", ");
  return `no assertion violated${isLive ? " so far" : ""}`;
}

/** Returns the first of `times` after the current time, or the last one before it. Wraps around at
 * the ends. */
function nextOf(times: readonly number[], now: number, isForward: boolean): number | undefined {
  const sorted = [...new Set(times)].sort((a, b) => a - b);
  return isForward
    ? (sorted.find((t) => t > now) ?? sorted[0])
    : (sorted.filter((t) => t < now).pop() ?? sorted[sorted.length - 1]);
}

const starts = ({ times }: Claim) => times.filter((_, i) => i % 2 === 0);

/** Goes to the next or previous start of a violation of any assertion or assumption. */
export function goToViolation(
  store: Store,
  isForward: boolean,
  claims: readonly Claim[] = store.claims,
): void {
  const to = nextOf(claims.flatMap(starts), store.instant?.time ?? 0, isForward);
  if (to !== undefined) store.goToTime(to);
}

interface Row {
  readonly row: HTMLButtonElement;
  readonly fate: HTMLElement;
  readonly now: HTMLElement;
}

export function startClaims(
  store: Store,
  host: HTMLElement,
  short: HTMLButtonElement,
  filter: HTMLInputElement,
): void {
  const rows: Row[] = [];
  let asked = 0;

  const made = (claim: Claim, at: number): Row => {
    const row = document.createElement("button");
    const now = document.createElement("i");
    const label = document.createElement("span");
    const fate = document.createElement("output");
    label.textContent = claim.assumed ? `assume ${claim.label}` : claim.label;
    row.append(now, label, fate);
    row.onclick = () => {
      const current = store.claims[at];
      if (!current) return;
      if (current.times.length > 0 && !store.asker) goToViolation(store, true, [current]);
      else if (current.signal >= 0) store.pick(current.signal);
    };
    return { row, fate, now };
  };

  /** Adds the edited program's result if it differs. */
  const textOf = ({ fate, other }: Claim): string => {
    const text = store.program.live
      ? fate.text.replace(" at the end", "").replace(/^held$/, "held so far")
      : fate.text;
    if (other === undefined) return text;
    const edited = other === null ? "removed" : other.text;
    return edited === text ? text : `${text} → ${edited}`;
  };

  /** Shows the verdicts at the current instant. */
  const showNow = () =>
    store.claims.forEach(({ signal }, at) => {
      const cell = store.instant?.cells[signal] ?? "";
      const { now } = rows[at] ?? {};
      if (!now || now.dataset["verdict"] === cell) return;
      now.dataset["verdict"] = cell;
      now.title = cell === "" ? "" : `now: ${cell}`;
    });

  const show = () => {
    const { claims } = store;
    if (rows.length === 0 && claims.length > 0) {
      const title = document.createElement("h2");
      title.textContent = "Assertions";
      rows.push(...claims.map(made));
      host.append(title, ...rows.map(({ row }) => row));
    }
    host.hidden = short.hidden = claims.length === 0;
    rows.forEach(({ row, fate }, at) => {
      const claim = claims[at];
      if (!claim) return;
      row.className = kindOf(claim.fate, claim.assumed);
      row.title = `${claim.column} (${claim.place})`;
      fate.textContent = textOf(claim);
    });
    short.textContent = inShort(claims, store.program.live);
    short.className = claims.some(({ fate }) => fate.failed) ? "violated" : "held";
    short.disabled = short.className === "held";
    showNow();
  };

  const ask = () => {
    asked = performance.now();
    store.askClaims();
  };

  short.onclick = () => goToViolation(store, true);
  filter.addEventListener("input", () => {
    const wanted = filter.value.trim().toLowerCase();
    rows.forEach(({ row }) => {
      row.hidden = !row.title.toLowerCase().includes(wanted);
    });
  });
  store.on("claims", show);
  store.on("instant", showNow);
  store.on("what-if", ask);
  store.on("extent", () => {
    if (performance.now() > asked + every || !store.program.live) ask();
  });
  ask();
}

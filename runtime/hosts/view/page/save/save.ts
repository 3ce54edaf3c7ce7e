// Saves the run together with the page as one file, which can be opened
// without a viewer.
import type { Kept } from "../kept";
import { spell } from "../plots/model";
import type { Instant } from "../protocol";
import type { Store } from "../store";
import { mostInstants, pack, type SavedRun } from "./format";

/** Number of instants in a request. */
const atOnce = 200;

/** Returns the instants of the run, or of the visible part of a long one. */
function wanted({ program, range }: Store): [number, number] {
  if (program.instants <= mostInstants) return [0, program.instants];
  const rate = (program.instants - 1) / Math.max(1e-9, program.end - program.start);
  const at = (seconds: number) =>
    Math.max(0, Math.min(program.instants, Math.round((seconds - program.start) * rate)));
  return [at(range[0]), Math.min(at(range[0]) + mostInstants, at(range[1]) + 1)];
}

async function collect(store: Store, kept: Kept, say: (text: string) => void): Promise<SavedRun> {
  const [first, end] = wanted(store);
  const signals = store.program.signals.map((): (number | string)[] => []);
  const others = store.program.signals.map((): (number | string | null)[] => []);
  const times: number[] = [],
    dts: number[] = [],
    truth: Instant["truth"][] = [],
    objects: (number | Instant["objects"])[] = [];
  for (let from = first; from < end; from += atOnce) {
    say(`Collecting the run: ${Math.round((100 * (from - first)) / (end - first))} %`);
    const some = await store.instants(from, Math.min(end, from + atOnce));
    for (const instant of some) {
      const k = times.length;
      times.push(instant.time);
      dts.push(instant.dt);
      if (instant.truth) truth.push(instant.truth);
      if (JSON.stringify(objects.at(-1)) !== JSON.stringify(instant.objects))
        objects.push(k, instant.objects);
      instant.cells.forEach((cell, i) => {
        const changes = signals[i];
        if (changes && changes.at(-1) !== cell) changes.push(k, cell);
      });
      instant.others?.forEach((cell, i) => {
        const changes = others[i];
        if (changes && (changes.length === 0 || changes.at(-1) !== cell)) changes.push(k, cell);
      });
    }
  }
  const { program } = store;
  return {
    program: {
      ...program,
      live: false,
      at: store.instant?.time ?? times[0] ?? 0,
      start: times[0] ?? 0,
      end: times.at(-1) ?? 0,
      instants: times.length,
      replayed: times.length,
      sees: false,
      console: [],
      kept: kept.text({ range: [...store.range], plots: spell(store.plots, program) }),
    },
    claims: { is: "claims", all: store.claims },
    contacts: store.contacts,
    times,
    dts,
    cells: signals,
    ...(store.hasOthers ? { others } : {}),
    ...(store.whatIf?.there ? { whatIf: store.whatIf } : {}),
    truth,
    objects,
  };
}

async function file(name: string): Promise<string> {
  return (await fetch(name)).text();
}

async function build(run: SavedRun): Promise<Blob> {
  const [page, css, js, icon, data] = await Promise.all([
    file("/"),
    file("page.css"),
    file("page.js"),
    file("icon.svg"),
    pack(run),
  ]);
  // The replacements are functions because `$` is special in replacement strings.
  const whole = page
    .replace(
      /<link rel="icon"[^>]*>/,
      () => `<link rel="icon" href="data:image/svg+xml,${encodeURIComponent(icon)}">`,
    )
    .replace(/<link rel="stylesheet"[^>]*>/, () => `<style>${css}</style>`)
    .replace(/<script src[^>]*><\/script>/, "")
    .replace(
      "</body>",
      () =>
        `<script type="text/plain" id="saved">${data}</script>\n` +
        `<script>${js.replaceAll("</script", "<\\/script")}</script>\n</body>`,
    );
  return new Blob([whole], { type: "text/html" });
}

function size(bytes: number): string {
  return bytes < 1e6 ? `${Math.round(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`;
}

export function startSaving(
  store: Store,
  kept: Kept,
  button: HTMLButtonElement,
  dialog: HTMLDialogElement,
): void {
  const text = document.createElement("p"),
    save = document.createElement("button"),
    cancel = document.createElement("button");
  const title = document.createElement("h2");
  title.textContent = "Save as one file";
  text.role = "status";
  save.textContent = "Save";
  cancel.textContent = "Cancel";
  cancel.onclick = () => dialog.close();
  dialog.replaceChildren(title, text, save, " ", cancel);
  const say = (what: string) => {
    text.textContent = what;
  };
  const offer = (content: Blob, run: SavedRun) => {
    const part = run.times.length < store.program.instants ? " in the time range of the plots" : "";
    say(
      `The program, its ${run.times.length} instants${part} and this page: ` +
        `${size(content.size)}. The file opens in a browser, without frobc, and shows this view. It ` +
        "cannot search, explain values, or run edited programs.",
    );
    save.hidden = false;
    save.onclick = () => {
      const link = document.createElement("a");
      link.href = URL.createObjectURL(content);
      link.download = `${store.program.name}.html`;
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
      dialog.close();
    };
  };
  button.onclick = () => {
    save.hidden = true;
    dialog.showModal();
    collect(store, kept, say)
      .then(async (run) => {
        offer(await build(run), run);
      })
      .catch((error: unknown) => {
        say(`The run cannot be saved: ${String(error)}`);
      });
  };
}

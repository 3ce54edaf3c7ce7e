// Answers what-if questions: runs the program with an edited text or other parameters, on the same
// inputs or again in the simulator.
import { ParamFields } from "./params";
import type { Store } from "../store";

/** Maximum length of the text; a request is limited to 64 kB. */
const longest = 60_000;

export interface Editor {
  /** `text`: an edited text to continue with; null for the program's own text. */
  begin(text: string | null): void;
  text(): string;
  end(): void;
}

export class WhatIfBar {
  /** The button that starts and ends editing. */
  readonly button = document.createElement("button");
  /** The actions and their result. */
  readonly element = document.createElement("section");
  private readonly said = document.createElement("pre");
  private readonly params: ParamFields;

  constructor(
    private readonly store: Store,
    private readonly editor: Editor,
  ) {
    this.button.textContent = "What if …";
    this.button.title = "Edit the program, and run it on the same inputs (e)";
    this.button.id = "what-if";
    this.button.onclick = () => (store.isEditing ? this.close() : this.begin());
    this.params = new ParamFields(store.program.params, () => this.run("what-if"));
    const press = (name: string, title: string, act: () => void) => {
      const button = document.createElement("button");
      button.textContent = name;
      button.title = title;
      button.onclick = act;
      return button;
    };
    const buttons = document.createElement("div");
    buttons.append(
      press("Run", "Run it on the same inputs (Ctrl Enter)", () => this.run("what-if")),
      press("Drive again", "Run it in the simulator, from the start (Ctrl Shift Enter)", () =>
        this.run("drive"),
      ),
      press("Discard", "Restore the original program", () => this.discard()),
    );
    const hint = document.createElement("p");
    hint.textContent =
      "Run: uses the recorded inputs; the world does not react. " +
      "Drive again: runs in the simulator, from the start.";
    this.element.className = "what-if";
    this.element.append(buttons, hint, this.params.element, this.said);
    this.element.hidden = true;
    this.said.setAttribute("role", "status");
    store.on("what-if", () => this.show());
  }

  /** Continues with a text that was edited before, or starts with the program's own. */
  begin(text: string | null = this.store.edited): void {
    this.store.isEditing = true;
    this.element.hidden = false;
    this.said.classList.remove("bad");
    this.said.textContent =
      text === null ? "" : "This is your edited program. Run it to compare its values.";
    this.params.reset();
    this.button.ariaPressed = "true";
    this.editor.begin(text);
  }

  run(how: "what-if" | "drive"): void {
    const text = this.editor.text();
    const settings = this.params.changed();
    if (new TextEncoder().encode(text).length > longest) {
      this.said.textContent = `The program is too long to send: the maximum is ${longest} bytes.`;
      return;
    }
    this.said.textContent = "compiling …";
    this.said.classList.remove("bad");
    this.store.askWhatIf(how, text, settings);
  }

  /** Ends editing, but keeps the edited text for the next time. */
  close(): void {
    this.store.isEditing = false;
    this.element.hidden = true;
    this.button.ariaPressed = "false";
    this.button.textContent = this.store.edited === null ? "What if …" : "What if … (edited)";
    this.editor.end();
    this.store.dropWhatIf();
  }

  discard(): void {
    this.store.edited = null;
    this.close();
  }

  private show(): void {
    const { whatIf } = this.store;
    if (!whatIf) return;
    const { there, drives, why, first, signal } = whatIf;
    this.said.classList.toggle("bad", why !== undefined);
    const where = drives ? "The edited program ran in the simulator. " : "";
    if (why !== undefined) this.said.textContent = why.trim();
    else if (!there) this.said.textContent = "";
    else if (first === undefined)
      this.said.textContent = `${where}Its outputs are the same at all instants.`;
    else {
      const go = document.createElement("button");
      go.textContent = "Go there";
      go.onclick = () => this.store.goTo(first);
      this.said.replaceChildren(
        `${where}Its outputs differ from instant ${first} on, first in ${signal ?? ""}. `,
        go,
      );
    }
  }
}

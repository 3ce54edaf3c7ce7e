// Undoes and redoes changes to the edited program. Changes in quick succession form one
// step.
import { Transaction, type ChangeSet, type Extension } from "@codemirror/state";
import { EditorView, type KeyBinding } from "@codemirror/view";

/** Maximum time, in ms, between two changes that are undone in one step. */
const soon = 500;

/** An undo step: the inverses of its changes, newest first. */
type Step = ChangeSet[];

export function undoing(): { extension: Extension; keys: KeyBinding[] } {
  let done: Step[] = [],
    undone: Step[] = [];
  let last = -Infinity;
  let isOurs = false;

  const move = (view: EditorView, from: Step[], to: Step[]): boolean => {
    const step = from.pop();
    if (!step) return true;
    const inverse: Step = [];
    isOurs = true;
    for (const changes of step) {
      inverse.unshift(changes.invert(view.state.doc));
      view.dispatch({ changes, annotations: Transaction.addToHistory.of(false) });
    }
    isOurs = false;
    last = -Infinity;
    to.push(inverse);
    return true;
  };
  const extension = EditorView.updateListener.of((update) => {
    if (!update.docChanged || isOurs) return;
    const now = performance.now();
    const back = update.changes.invert(update.startState.doc);
    const step = done.at(-1);
    if (step && now - last < soon) step.unshift(back);
    else done.push([back]);
    undone = [];
    last = now;
  });
  return {
    extension,
    keys: [
      { key: "Mod-z", run: (view) => move(view, done, undone), preventDefault: true },
      { key: "Mod-y", mac: "Mod-Shift-z", run: (view) => move(view, undone, done) },
      { key: "Ctrl-Shift-z", run: (view) => move(view, undone, done) },
      // A new line is indented like the one before it.
      {
        key: "Enter",
        run: ({ state, dispatch }) => {
          const { from } = state.selection.main;
          const indent = /^\s*/.exec(state.doc.lineAt(from).text)?.[0] ?? "";
          dispatch(state.replaceSelection(`\n${indent}`));
          return true;
        },
      },
    ],
  };
}

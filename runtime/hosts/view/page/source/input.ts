// Deletes and replaces text in the editor. The browser's own editing would add styles to the page's
// elements, which the page's security policy rejects.
import { findClusterBreak } from "@codemirror/state";
import { EditorView } from "@codemirror/view";

/** For each kind of deletion, returns where the deletion ends if it starts at position `at` and
 * nothing is selected. */
const ends: Readonly<Record<string, (text: string, at: number) => number>> = {
  deleteContentBackward: (text, at) => findClusterBreak(text, at, false),
  deleteContentForward: (text, at) => findClusterBreak(text, at, true),
  deleteWordBackward: (text, at) =>
    at - (/(?:\w+|[^\w]?)\s*$/.exec(text.slice(0, at))?.[0] ?? "").length,
  deleteWordForward: (text, at) =>
    at + (/^\s*(?:\w+|[^\w]?)/.exec(text.slice(at))?.[0] ?? "").length,
};

function insert(view: EditorView, text: string): void {
  view.dispatch(view.state.replaceSelection(text), { scrollIntoView: true });
}

/** Deletes the selection or, if there is none, the text that this kind of deletion covers; may join
 * two lines. */
function erase(view: EditorView, kind: string): void {
  const { main } = view.state.selection;
  const { doc } = view.state;
  if (!main.empty) {
    insert(view, "");
    return;
  }
  const line = doc.lineAt(main.head),
    at = main.head - line.from;
  const isBack = kind.endsWith("Backward");
  const isAtEnd = isBack ? at === 0 : at === line.length;
  const to = isAtEnd
    ? main.head + (isBack ? -1 : 1)
    : line.from + (ends[kind]?.(line.text, at) ?? at);
  const from = Math.max(0, Math.min(main.head, to)),
    end = Math.min(doc.length, Math.max(main.head, to));
  if (from < end) view.dispatch({ changes: { from, to: end }, scrollIntoView: true });
}

export const input = EditorView.domEventHandlers({
  beforeinput(event, view) {
    if (view.state.readOnly || event.isComposing) return false;
    const { inputType, data } = event;
    if (inputType === "insertText" && data !== null && !view.state.selection.main.empty)
      insert(view, data);
    else if (ends[inputType]) erase(view, inputType);
    else return false;
    event.preventDefault();
    return true;
  },
});

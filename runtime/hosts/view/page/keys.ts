// Keyboard shortcuts for all actions. The page's help dialog lists them.
import type { Player } from "./time/player";
import type { Stop } from "./operate/stop";
import type { Store } from "./store";
import { goToViolation } from "./signals/claims";
import { toggleTheme } from "./theme";
import type { WhyPanel } from "./source/why";

export function startKeys(
  store: Store,
  player: Player,
  filter: HTMLInputElement,
  find: HTMLInputElement,
  why: WhyPanel,
  help: HTMLDialogElement,
  stop: Stop,
): void {
  const act = (event: KeyboardEvent): boolean => {
    const { instant } = store;
    switch (event.key) {
      case "ArrowLeft":
        store.stepBy(event.shiftKey ? -10 : -1);
        break;
      case "ArrowRight":
        store.stepBy(event.shiftKey ? 10 : 1);
        break;
      case "PageUp":
        store.stepSeconds(-1);
        break;
      case "PageDown":
        store.stepSeconds(1);
        break;
      case "Home":
        store.goTo(0);
        break;
      case "End":
      case "l":
        player.toEnd();
        break;
      case "X":
        stop.press();
        break;
      case "p":
        if (store.run?.paces) store.command(store.run.paused ? "go" : "pause");
        break;
      case "n":
        if (store.run?.paused) store.command("step");
        break;
      case " ":
        player.toggle();
        break;
      case "+":
      case "=":
        player.faster(1);
        break;
      case "-":
        player.faster(-1);
        break;
      case "m":
        store.setMark(store.mark ? null : instant);
        break;
      case "i":
        store.zoom(0.5);
        break;
      case "o":
        store.zoom(2);
        break;
      case "z":
        store.showAll();
        break;
      case "t":
        toggleTheme();
        break;
      case "/":
        filter.closest("section")?.scrollIntoView();
        filter.focus();
        break;
      case "f":
        find.focus();
        find.select();
        break;
      case "w":
        why.toggle();
        break;
      case "Backspace":
        why.back();
        break;
      case "v":
      case "V":
        goToViolation(store, event.key === "v");
        break;
      case "e":
        document.getElementById("what-if")?.click();
        break;
      case "?":
        help.showModal();
        break;
      default:
        return false;
    }
    return true;
  };
  const moves = new Set(["ArrowLeft", "ArrowRight", "PageUp", "PageDown", "Home", "End", "v", "V"]);
  document.addEventListener("keydown", (event) => {
    const target = event.target instanceof Element ? event.target : null;
    // A saved page has no viewer that could execute these commands.
    if (document.body.classList.contains("saved") && "fwe".includes(event.key)) return;
    if (event.ctrlKey || event.altKey || event.metaKey || help.open) return;
    if (target?.closest("input, select") || (store.isEditing && target?.closest("#source"))) return;
    // The space bar presses a focused button.
    if (event.key === " " && target?.closest("button")) return;
    if (moves.has(event.key)) player.pause();
    if (act(event)) event.preventDefault();
  });
}

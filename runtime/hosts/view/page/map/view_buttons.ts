// The buttons on the map: zoom, show everything, follow the robot.
import { zoomStep } from "./gestures";
import type { View } from "./view";

const icons = {
  in: "M8 3v10M3 8h10",
  out: "M3 8h10",
  all: "M2 6V2h4M10 2h4v4M14 10v4h-4M6 14H2v-4",
  follow: "M8 1v4M8 11v4M1 8h4M11 8h4M8 5a3 3 0 1 0 0 6 3 3 0 0 0 0-6",
};

/** Adds the buttons to the map. Returns a function that highlights the active mode. */
export function viewButtons(host: HTMLElement, view: View, changed: () => void): () => void {
  const bar = document.createElement("div");
  bar.className = "view-buttons";
  const button = (icon: keyof typeof icons, title: string, act: () => void) => {
    const made = document.createElement("button");
    const ns = "http://www.w3.org/2000/svg";
    const svg = document.createElementNS(ns, "svg"),
      path = document.createElementNS(ns, "path");
    svg.setAttribute("viewBox", "0 0 16 16");
    path.setAttribute("d", icons[icon]);
    svg.append(path);
    made.title = made.ariaLabel = title;
    made.dataset["view"] = icon;
    made.append(svg);
    made.onclick = () => {
      act();
      changed();
    };
    bar.append(made);
    return made;
  };
  const zoom = (factor: number) => () => view.zoom(factor, [view.width / 2, view.height / 2]);
  button("in", "Zoom in", zoom(zoomStep));
  button("out", "Zoom out", zoom(1 / zoomStep));
  const all = button("all", "Show the whole map", () => view.showAll());
  const follow = button("follow", "Follow the robot", () =>
    view.mode === "robot" ? view.showAll() : view.follow(),
  );
  host.append(bar);
  const show = () => {
    all.ariaPressed = String(view.mode === "all");
    follow.ariaPressed = String(view.mode === "robot");
  };
  show();
  return show;
}

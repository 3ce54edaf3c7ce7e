// The lines that show the current instant and the mark on a plot. They are separate elements that
// move over the plot, so the plot is not redrawn at each instant.
import type uPlot from "uplot";
import type { Store } from "../store";

export class Lines {
  private readonly now = document.createElement("i");
  private readonly mark = document.createElement("i");

  constructor(private readonly store: Store) {
    this.now.className = "now-line";
    this.mark.className = "mark-line";
  }

  /** Adds the lines to a newly built plot. */
  addTo(plot: uPlot): void {
    plot.over.append(this.mark, this.now);
  }

  move(plot: uPlot): void {
    const { instant, mark } = this.store;
    const { min = 0, max = 1 } = plot.scales["x"] ?? {};
    const width = plot.over.clientWidth;
    const place = (line: HTMLElement, seconds: number | undefined) => {
      const isThere = seconds !== undefined && seconds >= min && seconds <= max;
      line.hidden = !isThere;
      if (!isThere) return;
      const x = max > min ? ((seconds - min) / (max - min)) * width : 0;
      line.style.transform = `translateX(${x.toFixed(1)}px)`;
    };
    place(this.now, instant?.time);
    place(this.mark, mark?.time);
  }
}

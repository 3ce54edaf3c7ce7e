// Lets the user drag signals from the list or the source onto a plot.

const kind = "application/x-frob-signal";

export function canBeDragged(element: HTMLElement, signal: number): void {
  element.draggable = true;
  element.addEventListener("dragstart", (event) => {
    event.dataTransfer?.setData(kind, String(signal));
    if (event.dataTransfer) event.dataTransfer.effectAllowed = "copy";
  });
}

export function takesSignals(element: HTMLElement, then: (signal: number) => void): void {
  const isSignal = (event: DragEvent) => event.dataTransfer?.types.includes(kind) ?? false;
  element.addEventListener("dragover", (event) => {
    if (!isSignal(event)) return;
    event.preventDefault();
    event.stopPropagation();
    element.classList.add("dropping");
  });
  element.addEventListener("dragleave", () => element.classList.remove("dropping"));
  element.addEventListener("drop", (event) => {
    element.classList.remove("dropping");
    if (!isSignal(event)) return;
    event.preventDefault();
    event.stopPropagation();
    then(Number(event.dataTransfer?.getData(kind)));
  });
}

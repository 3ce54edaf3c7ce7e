// A list of buttons that is a single tab stop. The up and down arrow keys move between
// the buttons.

/** Returns the buttons of a list that are visible, in order. */
function visible(list: HTMLElement): HTMLElement[] {
  return [...list.querySelectorAll<HTMLElement>("button")].filter(
    (button) => button.offsetParent !== null,
  );
}

export function startRoving(list: HTMLElement): void {
  let current: HTMLElement | null = null;
  const select = (button: HTMLElement | null | undefined) => {
    if (!button) return;
    if (current) current.tabIndex = -1;
    current = button;
    button.tabIndex = 0;
  };
  /** Ensures that exactly one button is a tab stop, even after buttons are added or hidden. */
  const tidy = () => {
    for (const button of list.querySelectorAll<HTMLElement>("button"))
      if (button !== current) button.tabIndex = -1;
    if (!current?.isConnected || current.offsetParent === null) select(visible(list)[0]);
  };
  list.addEventListener("focusin", ({ target }) => {
    if (target instanceof Element) select(target.closest<HTMLElement>("button"));
  });
  list.addEventListener("keydown", (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    const all = visible(list);
    const to = all[all.indexOf(current ?? list) + by];
    event.preventDefault();
    to?.focus();
    to?.scrollIntoView({ block: "nearest" });
  });
  new MutationObserver(tidy).observe(list, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ["hidden"],
  });
  tidy();
}

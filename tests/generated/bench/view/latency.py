"""usage: latency.py FROBC FOLDER COUNT

Measures the time from an instant until the page shows it: the host publishes it, the viewer replays
it and sends it, and a headless browser draws it. Then measures the time from pressing a key on the
page until the page shows the program's reaction: the same, preceded by the way to the host and the
wait for its next instant (20 ms)."""

import sys

from figures import Clock, example, figure, quantile

import viewer
from journey import Page, start

# Calls `then` when the page has redrawn a cell in the list of signals.
watch = """
const drawn = (name, then) => {
  const row = [...document.querySelectorAll("#list section > button")]
    .find((button) => button.title === name);
  const output = row.querySelector("output");
  const seen = new MutationObserver(() => requestAnimationFrame(() => {
    const next = new MessageChannel();
    next.port1.onmessage = () => then(seen);
    next.port2.postMessage(null);
  }));
  // Of the cell itself, its title, which has all digits.
  seen.observe(output, { childList: true, characterData: true, subtree: true, attributes: true });
  return output;
};
"""

instants = (
    watch
    + """
const [count, done] = arguments;
const took = [];
let last = "";
const output = drawn("in.1", (seen) => {
  if (output.title === last) return;
  last = output.title;
  took.push(performance.timeOrigin + performance.now() - Number(last));
  if (took.length < count) return;
  seen.disconnect();
  done(took);
});
"""
)

press = (
    watch
    + """
const [key, done] = arguments;
const field = document.getElementById("type");
const before = performance.now();
drawn("out.turn", (seen) => {
  seen.disconnect();
  done(performance.now() - before);
});
field.value = key;
field.oninput();
"""
)


def tell(program, measure, took):
    for name, share, aim in (("median", 0.5, 50), ("99 %", 0.99, 100)):
        figure(program, f"{measure}, {name}", quantile(took, share), aim, "ms")


def main():
    frobc, folder, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
    clock = Clock(frobc, folder)
    run = viewer.Process(clock.command(50 * 60, 20000, 0))
    driver = start(1280, 720)
    driver.set_script_timeout(60)
    try:
        page = Page(driver, run.address)
        page.wait(lambda: page.text("#follow") == "Live" and page.instant() > 50)
        tell("clock", "instant to pixel", driver.execute_async_script(instants, count))
        run.kill()
        run = viewer.Run(frobc, ["--robot", "pioneer", example("safe_stick")])
        page = Page(driver, run.address)
        page.wait(lambda: page.text("#follow") == "Live" and page.instant() > 50)
        tell(
            "safe_stick",
            "key to pixel",
            [driver.execute_async_script(press, "ax"[i % 2]) for i in range(count)],
        )
        page.all("#stop")[0].click()
        run.kill()  # otherwise it keeps running for the page
    finally:
        driver.quit()


main()

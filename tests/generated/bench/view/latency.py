"""usage: latency.py FROBC COUNT

From a key that is pressed on the page of a run until what the program makes of it is drawn
there: to the host, into the next instant (of 20 ms), published, run again by the viewer, and on
the screen of a browser without one. All of it on the page's clock."""

import os
import sys

here = os.path.dirname(os.path.abspath(__file__))
root = os.path.join(here, "..", "..", "..", "..")
sys.path.insert(0, os.path.join(root, "tests", "users", "view"))

import viewer  # noqa: E402
from journey import Page, start  # noqa: E402

press = """
const [key, done] = arguments;
const field = document.getElementById("type");
const row = [...document.querySelectorAll("#list section > button")]
  .find((button) => button.title === "out.turn");
const output = row.querySelector("output");
const before = performance.now();
const seen = new MutationObserver(() => {
  seen.disconnect();
  requestAnimationFrame(() => {
    const drawn = new MessageChannel();
    drawn.port1.onmessage = () => done(performance.now() - before);
    drawn.port2.postMessage(null);
  });
});
seen.observe(output, { childList: true, characterData: true, subtree: true });
field.value = key;
field.oninput();
"""


def main():
    frobc, count = sys.argv[1], int(sys.argv[2])
    program = os.path.join(root, "examples", "safe_stick", "safe_stick.frob")
    run = viewer.Run(frobc, ["--robot", "pioneer", program])
    driver = start(1280, 720)
    try:
        page = Page(driver, run.address)
        page.wait(lambda: page.text("#follow") == "Live")
        page.wait(lambda: page.instant() > 50)
        driver.set_script_timeout(10)
        took = sorted(driver.execute_async_script(press, "ax"[i % 2]) for i in range(count))
        page.all("#stop")[0].click()
        run.process.wait(10)
    finally:
        driver.quit()
    for name, share in (("median", 0.5), ("99 %", 0.99)):
        value = took[min(count - 1, int(share * count))]
        print('{"program": "safe_stick", "measure": "key to pixel, %s", "compiler": "", '
              '"value": %.1f, "reference": 100, "ratio": %.2f, "unit": "ms"}'
              % (name, value, value / 100))


main()

"""usage: speed.py FROBC

Measures a simulated run that a page shows: how often the page shows a new instant, at 1 and at 10
times real time; the speed of the run at full speed, relative to a run without a page; and the
processor time that it takes, which does not depend on the machine's other work."""

import re
import subprocess
import sys
import time

from figures import example, figure, processor_time
from selenium.webdriver.support.ui import Select

import viewer
from journey import Page, start

SECONDS = 5

updates = """
const [milliseconds, done] = arguments;
let count = 0;
const seen = new MutationObserver(() => count++);
seen.observe(document.getElementById("now"),
             { childList: true, characterData: true, subtree: true });
setTimeout(() => { seen.disconnect(); done(count); }, milliseconds);"""


def alone(frobc, program):
    """Simulated seconds per second without a page."""
    summary = subprocess.run(
        [frobc, "run", program, "--for", "2000s"], check=True, stdout=subprocess.PIPE, text=True
    ).stdout
    return float(re.search(r"simulated seconds per second: (\S+)", summary)[1])


def simulated(page):
    return float(page.text("#now").split("·")[1].split()[0])


def main():
    frobc = sys.argv[1]
    driver = start(1280, 720)
    driver.set_script_timeout(60)
    try:
        for name in "bug", "wall_follow":
            program = example(name)
            speed = alone(frobc, program)
            run = viewer.Run(frobc, [program])
            page = Page(driver, run.address)
            page.wait(lambda: page.text("#follow") == "Live" and page.instant() > 50)
            for times in "1", "10":
                Select(page.all("#run-speed")[0]).select_by_value(times)
                time.sleep(1)
                count = driver.execute_async_script(updates, 1000 * SECONDS)
                figure(name, f"pictures per second at {times} x", count / SECONDS, 30, "1/s")
            Select(page.all("#run-speed")[0]).select_by_visible_text("full")
            time.sleep(1)
            before, at = time.monotonic(), simulated(page)
            spent = [processor_time(pid) for pid in (run.viewer, run.host_process)]
            time.sleep(SECONDS)
            passed = simulated(page) - at
            figure(
                name, "full speed with a page", passed / (time.monotonic() - before), speed, "s/s"
            )
            viewer_took, host_took = (
                1e6 * (processor_time(pid) - first) / passed
                for pid, first in zip((run.viewer, run.host_process), spent)
            )
            figure(
                name,
                "processor time of the viewer per simulated second; of the simulator",
                viewer_took,
                host_took,
                "us",
            )
            driver.get("about:blank")
            run.kill()
    finally:
        driver.quit()


main()

"""usage: journey_access.py FROBC RUN.csv FILE ROBOT

Uses the page without a mouse, checks the sizes of targets on a phone, and lets axe-core search the
page for barriers."""

import os
import shutil
import subprocess
import sys
import tempfile

from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, start
from viewer import check

teleop = "../../../examples/teleop/teleop.frob"
sizes = {"phone": (390, 844), "laptop": (1280, 720), "desk": (1920, 1080), "200 %": (640, 360)}


def axe():
    """Returns the source text of axe-core, or None if npm cannot provide it."""
    if not shutil.which("npm"):
        return None
    with tempfile.TemporaryDirectory() as folder:
        for name in "package.json", "package-lock.json":
            shutil.copy(os.path.join("axe", name), folder)
        got = subprocess.run(
            ["npm", "ci", "--silent", "--no-audit", "--no-fund"],
            cwd=folder,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        if got.returncode != 0:
            return None
        with open(os.path.join(folder, "node_modules/axe-core/axe.min.js")) as file:
            return file.read()


violations = """
axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"] })
  .then(({ violations }) => arguments[0](violations.flatMap(({ id, nodes }) =>
    nodes.map(({ target, any }) => `${id} ${target} ${any[0]?.message ?? ""}`))))"""

small = """
const least = 43.5; // 44 pixels, rounded
return [...document.querySelectorAll("button, select, input, a")]
  .filter((each) => each.getClientRects().length > 0 && each.type !== "checkbox")
  .filter((each) => {
    const { width, height } = each.getBoundingClientRect();
    return width < least || height < least;
  })
  .map((each) => each.id || each.title || each.textContent)"""


def show(driver, size, theme):
    width, height = sizes[size]
    driver.execute_cdp_cmd(
        "Emulation.setDeviceMetricsOverride",
        {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500},
    )
    driver.execute_cdp_cmd(
        "Emulation.setEmulatedMedia",
        {"features": [{"name": "prefers-color-scheme", "value": theme}]},
    )


def choose(page, panel):
    page.driver.execute_script(f"document.querySelector('#panels [data-panel={panel}]').click()")


def open_everything(page):
    """Opens the tools, and the panels that open on demand."""
    page.driver.execute_script("""
        for (const id of ["why", "what-if"]) document.getElementById(id).click();
        document.querySelector("#plots [aria-expanded]")?.click();
        document.querySelector("#list h2 button")?.click();""")
    page.wait(lambda: page.all(".what-if")[0].is_displayed())


def barriers(page, searcher, name):
    """Checks each panel, at each size, in both themes."""
    for size in sizes:
        for theme in "light", "dark":
            show(page.driver, size, theme)
            panels = (
                ["map", "plots", "source", "signals"] if size in ("phone", "200 %") else ["map"]
            )
            for panel in panels:
                choose(page, panel)
                page.driver.execute_async_script(
                    "requestAnimationFrame(() => requestAnimationFrame(arguments[0]))"
                )
                page.driver.execute_script(searcher)
                found = page.driver.execute_async_script(violations)
                check(f"{name}, {size}, {theme}, {panel}: no barriers", found == [])
                for each in found:
                    print(each)


# Returns whether the buttons of the map cover a part of the list of the program's numbers.
covered = """
const [list, buttons] = ["#readings", ".view-buttons"].map((selector) =>
  document.querySelector(selector).getBoundingClientRect());
return list.width > 0 && list.left < buttons.right && buttons.left < list.right &&
  list.top < buttons.bottom && buttons.top < list.bottom;
"""


def targets(page, name):
    show(page.driver, "phone", "light")
    for panel in "map", "plots", "source", "signals":
        choose(page, panel)
        found = page.driver.execute_script(small)
        check(f"{name}: on a phone, the targets of the {panel} are large", found == [])
        print(*found, sep="\n", end="")
    choose(page, "map")
    check(f"{name}: the map's buttons cover no numbers", not page.driver.execute_script(covered))


def keys(page):
    show(page.driver, "laptop", "light")
    page.at(0)
    focused = "return document.activeElement.id || document.activeElement.title"
    page.driver.execute_script("document.activeElement.blur()")
    page.press(*[Keys.TAB] * 5)
    check("Play is reached with five tabs", page.driver.execute_script(focused) == "play")
    page.press(*[Keys.PAGE_DOWN] * 5)
    page.at(250)
    check("PageDown pressed five times moves five seconds", True)
    page.press(*[Keys.PAGE_UP] * 5)
    page.at(0)
    page.press("/", Keys.ARROW_DOWN)
    first = page.driver.execute_script(focused)
    page.press(Keys.ARROW_DOWN)
    check(
        "arrows move through the signals",
        (first, page.driver.execute_script(focused)) == ("out.forward", "out.turn"),
    )
    before = len(page.all("#plots article"))
    page.press(Keys.ENTER)
    page.wait(lambda: len(page.all("#plots article")) == before - 1)
    stops = (
        "return [...document.querySelectorAll('#list button')].filter(b => b.tabIndex === 0).length"
    )
    check("the list is one tab stop", page.driver.execute_script(stops) == 1)
    page.press(Keys.ENTER)
    page.press("i")
    page.wait(lambda: "range=0..5" in page.driver.current_url)
    page.press("z")
    page.wait(lambda: "range" not in page.driver.current_url)
    check("plots are zoomed with keys", True)


def fingers(page):
    """Zooms a plot with two fingers, and the map."""
    show(page.driver, "phone", "light")
    page.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True})

    def touch(kind, *places):
        page.driver.execute_cdp_cmd(
            "Input.dispatchTouchEvent",
            {
                "type": kind,
                "touchPoints": [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)],
            },
        )

    def spread(selector):
        box = page.all(selector)[0].rect
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        touch("touchStart", (x - 20, y), (x + 20, y))
        for apart in 30, 40, 60, 80:
            touch("touchMove", (x - apart, y), (x + apart, y))
        touch("touchEnd")

    choose(page, "plots")
    page.wait(lambda: page.all("#plots .u-over")[0].is_displayed())
    spread("#plots .u-over")
    page.wait(lambda: "range=" in page.driver.current_url)
    check("two fingers zoom a plot", True)
    page.press("z")
    choose(page, "map")
    page.wait(lambda: page.all("#map canvas")[0].is_displayed())
    spread("#map canvas")
    whole = "[data-view=all]"
    page.wait(lambda: page.all(whole)[0].get_attribute("aria-pressed") == "false")
    check("and the map", True)
    page.all(whole)[0].click()
    page.driver.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})


def fits(page):
    """Everything can be reached by scrolling down, but nothing to the side."""
    show(page.driver, "200 %", "light")
    across = page.driver.execute_script(
        "return [document.documentElement.scrollWidth, document.documentElement.clientWidth]"
    )
    check("at 200 % nothing is cut off at the side", across[0] <= across[1])
    page.driver.execute_script("document.getElementById('play').scrollIntoView()")
    check("and Play can be scrolled to", page.all("#play")[0].is_displayed())


def main():
    frobc, recording, program, _ = sys.argv[1:]
    searcher = axe()
    if searcher is None:
        print("skipped: npm does not have axe-core")
    v = viewer.Viewer(frobc, recording, program)
    run = viewer.Run(frobc, ["--robot", "pioneer", teleop])
    driver = start(1280, 720)
    driver.set_script_timeout(120)
    try:
        page = Page(driver, v.address)
        page.at(0)
        keys(page)
        fits(page)
        fingers(page)
        targets(page, "bug")
        open_everything(page)
        if searcher is not None:
            barriers(page, searcher, "bug")
        driver.get("about:blank")
        page = Page(driver, run.address)
        page.wait(lambda: page.text("#follow") == "Live")
        targets(page, "teleop")
        if searcher is not None:
            barriers(page, searcher, "teleop")
        driver.get("about:blank")
        v.end()
    finally:
        driver.quit()
    run.kill()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)

"""usage: journey_kept.py FROBC RUN.csv FILE ROBOT

Changes the plots, the map and the layout of a page, and checks that it opens in the same way: after a
reload, from its address, and for the next viewer of the program."""

import os
import sys

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, has_focus, start
from viewer import check

# Returns the file that a click on a button saves: the text of a table, or the size of a picture.
saved = """
const [selector, title, done] = arguments;
const make = URL.createObjectURL;
URL.createObjectURL = (blob) => {
  URL.createObjectURL = make;
  if (blob.type === "text/csv") blob.text().then(done);
  else createImageBitmap(blob).then(({ width, height }) => done([width, height]));
  return make.call(URL, blob);
};
HTMLAnchorElement.prototype.click = () => undefined;
[...document.querySelectorAll(selector)].find((each) => each.textContent === title).click();
"""


def names(page):
    """The signals of each plot."""
    return [
        [name.text for name in plot.find_elements("css selector", ".name")]
        for plot in page.all("#plots article")
    ]


def row(page, name):
    return next(r for r in page.all("#list section > button") if r.get_attribute("title") == name)


def press(page, title, inside="main"):
    page.driver.execute_script(
        "[...document.querySelectorAll(arguments[1] + ' button')]"
        ".find((each) => each.title === arguments[0] || each.textContent === arguments[0]).click()",
        title,
        inside,
    )


def pick(page, *signals):
    for signal in signals:
        page.driver.execute_script("arguments[0].click()", row(page, signal))


def plots(page, rows):
    check("a page plots the outputs first", names(page)[0] == ["out.forward"])
    press(page, "Click signals to add them to this plot")
    pick(page, "in.battery")
    page.wait(lambda: names(page)[0] == ["out.forward", "in.battery"])
    check("a signal is added to a plot, with an axis of its own", True)
    pick(page, "in.odometry.heading")
    page.wait(lambda: "at most two axes" in page.text("#state"))
    check("a third unit gets a plot of its own", ["in.odometry.heading"] in names(page))
    pick(page, "in.odometry.heading")
    press(page, "Click signals to add them to this plot")
    press(page, "Range, XY plot, export")
    page.driver.set_script_timeout(30)
    table = page.driver.execute_async_script(saved, "#plots .plot-tools button", "CSV").split("\n")
    check(
        "a plot's values are saved as a table",
        table[0] == "time,out.forward [m/s],in.battery [V]"
        and len(table) == len(rows) + 2
        and [float(cell) for cell in table[50].split(",")]
        == [float(rows[49][name]) for name in ("time", "out.forward", "in.battery")],
    )
    width, height = page.driver.execute_async_script(saved, "#plots .plot-tools button", "PNG")
    check("and as a picture", width > 200 and height > 80)
    fields = page.all("#plots .plot-tools input")
    fields[0].send_keys("-1")
    fields[1].send_keys("2", Keys.ENTER)
    page.wait(lambda: "out.forward,in.battery@-1..2" in page.driver.current_url)
    check("a range is fixed, and in the address", True)
    pick(page, "in.odometry.position.x")
    last = "#plots article:last-of-type"
    press(page, "Click signals to add them to this plot", last)
    pick(page, "in.odometry.position.y")
    press(page, "Range, XY plot, export", last)
    press(page, "XY", last)
    page.wait(lambda: len(page.all("#plots .xy canvas")) == 1)
    check("a signal is plotted over another one", True)


def zooms(page):
    press(page, "Follow the robot")
    check(
        "the map follows the robot",
        page.all("[data-view=follow]")[0].get_attribute("aria-pressed") == "true",
    )
    press(page, "Show the whole map")
    canvas = page.all("#map canvas")[0]
    picture = "return document.querySelector('#map canvas').toDataURL()"
    whole = page.driver.execute_script(picture)
    ActionChains(page.driver).move_to_element(canvas).click_and_hold().move_by_offset(
        60, 20
    ).release().perform()
    page.wait(lambda: page.driver.execute_script(picture) != whole)
    check("the map is moved", True)
    press(page, "Zoom in")


def edits(page, start):
    """Edits the program, whose first line is `start`, and undoes that."""
    lines = """
        const root = document.querySelector("#source > div").shadowRoot;
        return [...root.querySelectorAll(".cm-line")].slice(0, 3).map((line) => line.textContent)"""

    def first(*wanted):
        shown = page.driver.execute_script(lines)
        return all(line == part for line, part in zip(shown, wanted))

    def controlled(key, *before):
        keys = ActionChains(page.driver).send_keys(*before)
        return keys.key_down(Keys.CONTROL).send_keys(key).key_up(Keys.CONTROL)

    def control(key):
        controlled(key).perform()

    controlled(Keys.HOME, "e").send_keys("at once ").perform()
    page.wait(lambda: first("at once " + start))
    check("keys that follow e at once are not lost", True)
    page.press(*[Keys.BACKSPACE] * 8)
    page.wait(lambda: first(start))
    page.press(Keys.ESCAPE)
    page.edit()
    control(Keys.HOME)
    # The editor draws the lines at its top some time after it has moved there.
    page.wait(lambda: first(start))
    page.press("  x = 1", Keys.ENTER, "y", Keys.ENTER)
    page.wait(lambda: first("  x = 1", "  y", "  " + start))
    check("a new line is indented", True)
    page.press(*[Keys.BACKSPACE] * 4)
    page.press(Keys.ARROW_UP, Keys.HOME, Keys.DELETE)
    page.wait(lambda: first(" x = 1", "  " + start))
    check("text is deleted, also across lines", True)
    control("a")
    page.press("z")
    page.wait(lambda: first("z"))
    for _ in range(20):
        control("z")
    page.wait(lambda: first(start))
    check("all of it is undone", True)
    control("y")
    page.wait(lambda: not first(start))
    check("and done again", True)
    page.press(Keys.ESCAPE)
    page.wait(lambda: first(start))


def shape(page):
    """The visible state of a page: theme, plots, sizes and the view of the map."""
    return page.driver.execute_script("""
        const style = (name) => document.documentElement.style.getPropertyValue(name);
        return [document.documentElement.dataset.theme, style("--source"), style("--middle"),
                [...document.querySelectorAll("#map [aria-pressed=true]")].length]""")


def main():
    frobc, recording, program, robot = sys.argv[1:]
    rows = viewer.trace(frobc, recording, program, robot)
    v = viewer.Viewer(frobc, recording, program)
    driver = start(1280, 900)
    try:
        page = Page(driver, v.address)
        page.at(0)
        plots(page, rows)
        zooms(page)
        with open(program) as file:
            edits(page, file.readline().rstrip("\n"))
        page.press("t")
        bar = page.all("[data-split=source]")[0]
        width = page.all("#source")[0].size["width"]
        bar.send_keys(Keys.ARROW_LEFT, Keys.ARROW_LEFT)
        page.wait(lambda: page.all("#source")[0].size["width"] < width - 20)
        check("a panel is resized with keys", True)
        driver.execute_script("document.activeElement.blur()")
        page.press(Keys.HOME, *[Keys.ARROW_RIGHT] * 30)
        page.at(30)
        page.edit()
        page.press("-- edited ")
        # Wait until the viewer has kept the state.
        kept = os.path.join(os.environ["XDG_STATE_HOME"], "frobc", "view")

        def is_kept():
            if not os.path.isdir(kept):
                return False
            texts = [open(os.path.join(kept, name)).read() for name in os.listdir(kept)]
            return any("-- edited " in text for text in texts)

        page.wait(lambda: is_kept() and "at=0.6" in driver.current_url)
        before = shape(page), names(page)
        driver.refresh()
        page.at(30)
        page.wait(lambda: driver.execute_script(has_focus))
        page.wait(lambda: (shape(page), names(page)) == before)
        check("a reload changes nothing", before[0][3] == 0)
        edited = (
            "return document.querySelector('#source > div').shadowRoot"
            ".querySelector('.cm-content').innerText.startsWith('-- edited ')"
        )
        page.wait(lambda: driver.execute_script(edited))
        check("nor the edited text", True)
        link = driver.current_url.split("&", 1)[1]
        driver.get("about:blank")
        v.end()
        driver.switch_to.new_window("tab")
        v = viewer.Viewer(frobc, recording, program)
        page = Page(driver, v.address)
        page.at(0)
        page.wait(lambda: (shape(page), names(page)) == before)
        check("the next viewer opens the program's page as it was", True)
        page = Page(driver, f"{v.address}&at=0.1&range=0..2&plots=out.turn")
        page.at(5)
        check("an address opens its own view", names(page) == [["out.turn"]])
        page = Page(driver, f"{v.address}&{link}")
        page.at(30)
        page.wait(lambda: names(page) == before[1])
        check("and a link that of another page", True)
        messages = [entry["message"] for entry in driver.get_log("browser")]
        check("the browser has nothing to complain of", messages == [])
        for message in messages:
            print(message)
        v.end()
    finally:
        driver.quit()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)

"""usage: journey.py FROBC RUN.csv FILE ROBOT

Visits the page in a browser: opens it, looks, plots, scrubs, marks, plays."""

import atexit
import os
import sys

from selenium import webdriver
from selenium.common.exceptions import StaleElementReferenceException as stale
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

import viewer
from viewer import check


def start(width, height):
    options = Options()
    options.add_argument("--headless=new")
    options.add_argument(f"--window-size={width},{height}")
    if os.geteuid() == 0:
        options.add_argument("--no-sandbox")  # Chromium has no sandbox for root
    options.binary_location = "/usr/bin/chromium"
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = Service("/usr/bin/chromedriver", popen_kw={"start_new_session": True})
    driver = webdriver.Chrome(service=service, options=options)
    atexit.register(viewer.dismiss, viewer.guard(service.process.pid))
    return driver


# Returns whether typed keys edit the program.
has_focus = """
const { shadowRoot } = document.querySelector("#source > div");
return Boolean(shadowRoot.activeElement?.isContentEditable && shadowRoot.querySelector(".editing"));
"""


class Page:
    def __init__(self, driver, address):
        self.driver = driver
        driver.get(address)

    def all(self, selector):
        return self.driver.find_elements(By.CSS_SELECTOR, selector)

    def text(self, selector):
        return next((element.text for element in self.all(selector)), "")

    def wait(self, condition):
        return WebDriverWait(self.driver, 60, ignored_exceptions=[stale]).until(
            lambda _: condition()
        )

    def press(self, *keys):
        ActionChains(self.driver).send_keys(*keys).perform()

    def edit(self):
        """Starts to edit the program, and waits until the editor has the focus."""
        self.press("e")
        self.wait(lambda: self.driver.execute_script(has_focus))

    def at(self, k):
        return self.wait(lambda: self.text("#now").startswith(f"instant {k} "))

    def instant(self):
        return int(self.text("#now").split()[1])

    def cells(self):
        """Returns the full text of each signal in the list."""
        return dict(
            self.driver.execute_script(
                "return [...document.querySelectorAll('#list section > button')]"
                ".map(row => [row.title, row.querySelector('output').title])"
            )
        )


def origin(page, name):
    def found():
        return next(
            (
                b
                for b in page.all(".why li button")
                if b.find_element(By.CSS_SELECTOR, ".name").text == name
            ),
            None,
        )

    return page.wait(found)


def visit(page, rows):
    last = len(rows) - 1
    page.at(0)
    check("the replay is as recorded", page.text("#state") == "replayed: outputs as recorded")
    page.press(Keys.END)
    page.at(last)
    page.press(Keys.ARROW_LEFT)
    page.at(last - 1)
    page.wait(
        lambda: all(page.cells().get(name, cell) == cell for name, cell in rows[last - 1].items())
    )
    check("the list shows what is traced", True)
    turn = next(r for r in page.all("#list button") if r.get_attribute("title") == "out.turn")
    check("a turn rate is in radians", turn.text.endswith("[rad/s]"))
    omegas = [
        r.get_attribute("textContent")
        for r in page.all("#list button")
        if r.get_attribute("title").endswith(".wallFollow1.omega")
    ]
    check(
        "also one whose type is that of a function's result",
        any(text.endswith("[rad/s]") for text in omegas),
    )

    away = float(rows[last - 1]["probe.draw[2]"].split('"')[2])
    page.wait(lambda: page.text("#readings dd").endswith("[m]"))
    check(
        "what the program draws is beside the map, with its unit",
        page.text("#readings dt") == "to the goal"
        and abs(float(page.text("#readings dd")[:-3]) - away) < 1e-4 * away,
    )

    before = len(page.all("#plots article"))
    page.press("/", "heading", Keys.ENTER)
    page.wait(lambda: len(page.all("#plots article")) == before + 1)
    page.wait(lambda: len(page.all("#plots article:last-of-type canvas")) == 1)
    check("a signal that is found is plotted", True)
    page.press(Keys.ESCAPE)

    page.press("m", Keys.HOME)
    page.at(0)
    page.wait(lambda: page.text("#apart").startswith(f"Δ {1 - last} instants"))
    check("a mark shows what lies between", "Δ" in page.text("#plots article .apart"))
    page.press("m")

    page.press("f", "mode.bug == withSF", Keys.ENTER)
    found = next(k for k, row in enumerate(rows) if row["mode.bug"] == "withSF")
    page.at(found)
    check("a condition is found", page.text("#found") == "once")
    page.press(Keys.ESCAPE)

    timeline = page.all("#timeline canvas")[0]
    ActionChains(page.driver).move_to_element(timeline).click().perform()
    page.wait(lambda: abs(page.instant() - last / 2) <= last / 50)
    check("the time line goes where it is clicked", True)

    at = page.instant()
    page.press(Keys.SPACE)
    page.wait(lambda: page.instant() > at + 5)
    page.press(Keys.SPACE)
    check("it plays", True)

    plot = page.all("#plots article .u-over")[0]
    ActionChains(page.driver).move_to_element_with_offset(
        plot, -50, 0
    ).click_and_hold().move_by_offset(100, 0).release().perform()
    page.press(Keys.HOME)
    page.at(0)
    ActionChains(page.driver).move_to_element(plot).click().perform()
    page.wait(lambda: abs(page.instant() - last / 2) <= last / 20)
    check("a plot shows what was dragged over, and goes where it is clicked", True)

    source = page.driver.execute_script(
        "return document.querySelector('#source > div').shadowRoot"
        ".querySelector('.cm-content').innerText"
    )
    check("the source is there", "main" in source)
    page.press(Keys.HOME, *[Keys.ARROW_RIGHT] * 30)
    page.at(30)
    check("each of many key strokes counts", True)
    pill = next(b for b in page.all(".modes button") if b.text == "withSF")
    pill.click()
    page.at(found)
    page.wait(lambda: "running" in pill.get_attribute("class"))
    check("a mode that is clicked is gone to", True)
    diagram = next(each for each in page.all(".modes") if "driveTo" in each.text)
    check(
        "the modes of a machine are drawn with what leads from one to the other",
        [b.text for b in diagram.find_elements(By.CSS_SELECTOR, "button")]
        == ["driveTo", "withSF", "circleTo", "ended"]
        and len(diagram.find_elements(By.CSS_SELECTOR, "path.edge")) == 2 * 6
        and "closestPlace" in diagram.text,
    )

    line = page.driver.execute_script("""
        const root = document.querySelector('#source > div').shadowRoot;
        const chip = [...root.querySelectorAll('.values button')]
            .find(button => button.textContent.startsWith('goal.x'));
        const text = chip.closest('.cm-line').textContent + chip.textContent;
        chip.click();
        return text""")
    check(
        "values stand on the lines of their signals",
        line.startswith("bug goal = do") and line.endswith("13[m]"),
    )
    page.wait(lambda: any(".goal.x" in h.text for h in page.all("#plots h2")))
    check("a value that is clicked is plotted", True)
    page.press("w")
    page.wait(lambda: page.text(".why .name") == "out.forward")
    asked = found + 20
    page.press(Keys.HOME)
    page.at(0)
    pill.click()
    page.at(found)
    page.press(*[Keys.ARROW_RIGHT] * 20)
    page.at(asked)
    origin(page, "bug.mode").click()
    page.wait(lambda: page.text(".why .name") == "bug.mode")
    page.wait(lambda: page.text(".why .switch p").startswith("driveTo → withSF"))
    origin(page, "driveTo.blocked").click()
    page.at(found - 1)
    page.wait(lambda: page.text(".why .name") == "driveTo.blocked")
    check(
        "each value leads to those it came from, and to their instants",
        "blocked" in page.text(".why pre"),
    )
    page.press(Keys.BACKSPACE)
    page.at(asked)
    page.wait(lambda: page.text(".why .name") == "bug.mode")
    page.all(".why .since")[0].click()
    page.at(found)
    check("there is a way back, and one to where a value became so", True)
    page.press("w")
    page.wait(lambda: not page.all(".why")[0].is_displayed())
    page.edit()
    page.press("wrong ")
    ActionChains(page.driver).key_down(Keys.CONTROL).send_keys(Keys.ENTER).key_up(
        Keys.CONTROL
    ).perform()
    page.wait(lambda: "error" in page.text(".what-if pre"))
    check("an edited program that is wrong is told", True)
    page.press(Keys.ESCAPE)
    page.wait(lambda: not page.all(".what-if pre")[0].is_displayed())
    page.edit()
    page.wait(lambda: "your edited program" in page.text(".what-if pre"))
    check("the edited text is kept when the editor is closed", True)
    next(b for b in page.all(".what-if button") if b.text == "Discard").click()
    page.wait(lambda: not page.all(".what-if pre")[0].is_displayed())
    page.edit()
    next(b for b in page.all(".what-if button") if b.text == "Drive again").click()
    page.wait(lambda: "ran in the simulator" in page.text(".what-if pre"))
    check(
        "the program drives again in the simulator",
        page.text(".what-if pre").endswith("Its outputs are the same at all instants."),
    )
    check("the page says which curve is dashed", "Dashed: the edited" in page.text("#compared"))
    next(b for b in page.all(".what-if button") if b.text == "Discard").click()
    page.wait(lambda: not page.all("#compare")[0].is_displayed())

    messages = [entry["message"] for entry in page.driver.get_log("browser")]
    check("the browser has nothing to complain of", messages == [])
    for message in messages:
        print(message)


def main():
    frobc, recording, program, robot = sys.argv[1:]
    v = viewer.Viewer(frobc, recording, program)
    driver = start(1280, 720)
    try:
        visit(Page(driver, v.address), viewer.trace(frobc, recording, program, robot))
        driver.get("about:blank")
        stranger = Page(driver, v.address[:-1] + ("0" if v.address[-1] != "0" else "1"))
        stranger.wait(lambda: "the token is wrong" in stranger.text("#state"))
        check("a page with another token shows nothing", stranger.text("#list") == "")
        check("but what to do", "address that frobc printed" in stranger.text("#opening"))
        page = Page(driver, v.address)
        page.at(0)
        v.end()
        page.wait(lambda: "cannot reach the viewer" in page.text("#contact"))
        v = viewer.Viewer(frobc, recording, program, "--port", str(v.port))
        page.wait(lambda: "Another viewer answers" in page.text("#contact"))
        check("a page finds out that there is another viewer in the place of its own", True)
        Page(driver, v.address).at(0)
        check("whose address opens it in the same tab", True)
        v.end()
    finally:
        driver.quit()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)

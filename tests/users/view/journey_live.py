"""usage: journey_live.py FROBC RUN.csv FILE ROBOT

Visits the page of a live run: watches the robot move, pauses the run, scrubs, returns, presses a
key, and stops the run."""

import sys
import tempfile

from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

import viewer
from journey import Page, start
from viewer import check

stick = "../../../examples/safe_stick/safe_stick.frob"


def cell(page, name):
    return page.cells()[name]


def visit(page):
    page.wait(lambda: page.text("#follow") == "Live")
    check("it is live", page.text("#state") == "live: outputs as computed")
    first = page.instant()
    page.wait(lambda: page.instant() > first + 10)
    check("its newest instant is shown", True)

    page.all("#type")[0].send_keys("w")
    page.wait(lambda: float(cell(page, "out.forward")) > 0.2)
    check("the program reacts to a key", True)
    before = float(cell(page, "in.odometry.position.x"))
    page.wait(lambda: float(cell(page, "in.odometry.position.x")) > before + 0.1)
    check("the robot is seen to move", True)
    page.press(Keys.ESCAPE)

    page.all("#hold")[0].click()
    page.wait(lambda: page.text("#hold") == "Continue")
    at = page.wait(lambda: stands(page))
    page.all("#single")[0].click()
    page.wait(lambda: page.instant() == at + 1)
    check("a run that is paused takes one instant", True)

    page.press(Keys.HOME)
    page.at(0)
    page.press("p")
    page.wait(lambda: page.text("#hold") == "Pause")
    page.wait(lambda: extent(page) > at + 20)
    check(
        "what was before is shown while it goes on",
        page.text("#follow") == "Back to live" and page.instant() == 0,
    )
    page.press("l")
    page.wait(lambda: page.text("#follow") == "Live" and page.instant() > at + 20)
    check("and back to the newest instant", True)

    Select(page.all("#run-speed")[0]).select_by_value("5")
    page.press(Keys.HOME)
    page.wait(lambda: page.text("#follow") == "Back to live")
    page.all("#follow")[0].click()
    page.wait(lambda: page.text("#follow") == "Live")

    page.all("#stop")[0].click()
    page.wait(lambda: page.text("#follow") == "The run is over")
    check("it is stopped", not page.all("#stop")[0].is_displayed())
    page.wait(lambda: page.text("#state") == "the replay has the same outputs")
    page.press(Keys.HOME)
    page.at(0)
    check("and can be looked at afterwards", True)
    messages = [entry["message"] for entry in page.driver.get_log("browser")]
    check("the browser has nothing to complain of", messages == [])
    for message in messages:
        print(message)


pusher = """import Robot

main :: (HasSonar i, DiffDrive o) => Program i o
main = reactimateRobot (proc _ -> roMake (setVelTR 0.3[m/s] 0))
"""
world = """[start]
x = 0
y = 0

[[box]]
center = [0.8, 0]
size = [0.3, 0.3]
mass = 2

[[ball]]
center = [1, 1]

[[wall]]
points = [[4, -1], [4, 1]]
"""
# Returns the mean column of the pixels that have a box's colour.
column = """
const canvas = document.querySelector("#map canvas");
const { width, height } = canvas;
const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
const probe = document.createElement("canvas").getContext("2d");
probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--box");
probe.fillRect(0, 0, 1, 1);
const box = probe.getImageData(0, 0, 1, 1).data;
let sum = 0, count = 0;
for (let i = 0; i < data.length; i += 4)
  if ([0, 1, 2].every((c) => Math.abs(data[i + c] - box[c]) < 3)) {
    sum += (i / 4) % width;
    count++;
  }
return count > 20 ? sum / count : null;
"""

# Returns how far the curves of the timeline reach, as a part of its width. Its cursor has another
# colour.
reach = """
const canvas = document.querySelector("#timeline canvas");
const { width, height } = canvas;
const { data } = canvas.getContext("2d").getImageData(0, 0, width, height);
const probe = document.createElement("canvas").getContext("2d");
probe.fillStyle = getComputedStyle(document.documentElement).getPropertyValue("--accent");
probe.fillRect(0, 0, 1, 1);
const line = probe.getImageData(0, 0, 1, 1).data;
let most = 0;
for (let i = 0; i < data.length; i += 4)
  if ([0, 1, 2].every((c) => Math.abs(data[i + c] - line[c]) < 40))
    most = Math.max(most, (i / 4) % width);
return most / width;
"""


def visit_box(page):
    """The robot pushes a box."""
    page.wait(lambda: page.text("#follow") == "Live")
    Select(page.all("#run-speed")[0]).select_by_value("10")
    page.wait(lambda: float(cell(page, "in.odometry.position.x")) > 1.5)
    page.all("#hold")[0].click()
    page.wait(lambda: page.text("#hold") == "Continue")
    page.wait(lambda: stands(page))
    page.wait(lambda: page.driver.execute_script(reach) > 0.97)
    check("the timeline shows the last instants before a pause", True)
    pushed = page.driver.execute_script(column)
    page.press(Keys.HOME)
    page.at(0)
    at_start = page.driver.execute_script(column)
    check("a box that the robot pushes moves on the map", at_start and pushed > at_start + 20)
    page.all("#stop")[0].click()
    page.wait(lambda: page.text("#follow") == "The run is over")


def stands(page):
    """Returns the instant shown, once it has not changed for a while."""
    at = page.instant()
    page.driver.execute_async_script("setTimeout(arguments[0], 300)")
    return at if page.instant() == at else None


def extent(page):
    """Returns the number of instants."""
    return int(page.text("#run").split(" instants")[0].split()[-1])


def main():
    frobc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        run = viewer.Run(frobc, ["--robot", "pioneer", "--record", f"{folder}/run.csv", stick])
        driver = start(1280, 720)
        try:
            visit(Page(driver, run.address))
        finally:
            driver.quit()
        check("the run has ended well", run.process.wait(10) == 0)
        for name, text in ("pusher.frob", pusher), ("world.toml", world):
            with open(f"{folder}/{name}", "w") as file:
                file.write(text)
        run = viewer.Run(frobc, ["--robot", "pioneer", f"{folder}/pusher.frob"])
        driver = start(1280, 720)
        try:
            visit_box(Page(driver, run.address))
        finally:
            driver.quit()


main()
sys.exit(viewer.failures > 0)

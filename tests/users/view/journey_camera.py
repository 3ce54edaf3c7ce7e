"""usage: journey_camera.py FROBC RUN.csv FILE ROBOT

Visits the page of a program with a camera: checks the image that it shows, live, at any earlier
instant, on a phone, and when a frame is missing."""

import glob
import os
import subprocess
import sys
import tempfile

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, start
from viewer import check

poster = "../../../examples/track_poster/track_poster.frob"


def colours(page):
    """Counts pixels in the camera's panel: those that belong to the image (approximately, pixels
    that are neither grey nor clear), and those in the colour #00c08b of a marked object."""
    return page.driver.execute_script("""
        const canvas = document.querySelector("#camera canvas"), copy = new OffscreenCanvas(
            canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
        copy.drawImage(canvas, 0, 0);
        const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
        let filled = 0, seen = 0;
        for (let i = 0; i < data.length; i += 4) {
            filled += data[i + 3] === 255 ? 1 : 0;
            seen += data[i] < 30 && Math.abs(data[i + 1] - 192) < 12 &&
                    Math.abs(data[i + 2] - 139) < 12 ? 1 : 0;
        }
        return [filled, seen];""")


def frame(page):
    words = page.text("#camera p").split()
    return int(words[1].rstrip(",")) if words[:1] == ["frame"] else None


def complaints(page):
    messages = [entry["message"] for entry in page.driver.get_log("browser")]
    check("the browser has nothing to complain of", messages == [])
    for message in messages:
        print(message)


def visit_live(page):
    page.wait(lambda: page.text("#follow") == "Live" and frame(page))
    first = page.wait(lambda: frame(page))
    page.wait(lambda: frame(page) > first + 10)
    check("frames are seen as they come", True)
    page.wait(lambda: colours(page)[1] > 50)
    check("with what the program draws on them", colours(page)[0] > 10000)
    page.press(Keys.HOME)
    page.at(0)
    page.wait(lambda: frame(page) is None)
    check("what was before is seen while it goes on", True)
    page.all("#stop")[0].click()
    page.wait(lambda: page.text("#follow") == "The run is over")


def visit(page):
    page.at(0)
    check("before the first frame there is none", frame(page) is None)
    page.press(Keys.PAGE_DOWN)
    page.at(50)
    page.wait(lambda: frame(page) == 29)
    filled, seen = colours(page)
    check(
        "the frame of the instant is seen, and the poster's outline", filled > 10000 and seen > 50
    )
    canvas = page.all("#camera canvas")[0]
    ActionChains(page.driver).move_to_element(canvas).perform()
    page.wait(lambda: page.text("#camera p").startswith("x 1"))
    check("below the pointer its colour is read out", "hue" in page.text("#camera p"))
    page.press("t")
    page.wait(lambda: colours(page)[1] > 50)
    check("in the dark too", True)
    complaints(page)


def visit_phone(page):
    page.at(0)
    check("a phone has a button for it", not page.all("#camera")[0].is_displayed())
    page.all("#panels [data-panel=camera]")[0].click()
    page.press(Keys.PAGE_DOWN)
    page.wait(lambda: frame(page) == 29 and colours(page)[1] > 50)
    check("and there it is", True)


def visit_missing(page):
    page.at(0)
    page.press(Keys.PAGE_DOWN)
    page.at(50)
    check(
        "a frame that is missing is told",
        "frame 29 at instant 50 is not available" in page.wait(lambda: page.text("#notes")),
    )
    page.wait(lambda: colours(page)[1] == 0)
    check("and no other is shown for it", frame(page) is None)


def main():
    frobc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        path = f"{folder}/run.csv"
        subprocess.run(
            [frobc, "run", "--robot", "pioneer", "--for", "2s", "--record", path, poster],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        driver = start(1280, 720)
        try:
            run = viewer.Run(
                frobc, ["--robot", "pioneer", "--record", f"{folder}/live.csv", poster]
            )
            visit_live(Page(driver, run.address))
            visit(Page(driver, viewer.Viewer(frobc, path, poster).address))
            driver.set_window_size(390, 780)
            visit_phone(Page(driver, viewer.Viewer(frobc, path, poster).address))
            driver.set_window_size(1280, 720)
            os.remove(glob.glob(f"{folder}/run.frames/000029-*.ppm")[0])
            visit_missing(Page(driver, viewer.Viewer(frobc, path, poster).address))
        finally:
            driver.quit()


main()
sys.exit(viewer.failures > 0)

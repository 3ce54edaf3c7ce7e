"""usage: page_pictures.py FROBC ROOT TO

Takes screenshots of `frobc view` for the documentation: runs the wall follower and programs that
use a camera, captures the page at selected instants, and saves the images in TO/docs."""

import base64
import os
import subprocess
import sys
import tempfile
import time

frobc, root, to = map(os.path.abspath, sys.argv[1:])
sys.path.insert(0, os.path.join(root, "tests/users/view"))

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, start

# JavaScript that returns the image in the camera pane, including the marks on it.
pane = """
const canvas = document.querySelector("#camera canvas");
const { width, height } = canvas, copy = new OffscreenCanvas(width, height).getContext("2d");
copy.drawImage(canvas, 0, 0);
const { data } = copy.getImageData(0, 0, width, height);
let left = width, right = 0, top = height, bottom = 0;
for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
        if (data[4 * (y * width + x) + 3] === 255) {
            left = Math.min(left, x); right = Math.max(right, x + 1);
            top = Math.min(top, y); bottom = Math.max(bottom, y + 1);
        }
const out = document.createElement("canvas");
out.width = right - left;
out.height = bottom - top;
out.getContext("2d").drawImage(canvas, -left, -top);
return out.toDataURL("image/png").split(",")[1];"""


class Run:
    """A recorded run of an example, opened in `frobc view`."""

    def __init__(self, driver, folder, example, seconds, shown=""):
        program = os.path.join(root, f"examples/{example}/{example}.frob")
        recording = os.path.join(folder, f"{example}.csv")
        subprocess.run(
            [
                frobc,
                "run",
                "--robot",
                "pioneer",
                "--for",
                f"{seconds}s",
                "--record",
                recording,
                program,
            ],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        self.page = Page(driver, viewer.Viewer(frobc, recording, program).address + shown)
        self.page.at(0)

    def go(self, instant):
        """Presses the page's keys to reach the instant, in steps of 50 and then 10 instants."""
        self.page.press(Keys.HOME)
        self.page.at(0)
        for k in range(50, instant + 1, 50):
            self.page.press(Keys.PAGE_DOWN)
            self.page.at(k)
        for k in range(instant // 50 * 50 + 10, instant + 1, 10):
            ActionChains(self.page.driver).key_down(Keys.SHIFT).send_keys(Keys.ARROW_RIGHT).key_up(
                Keys.SHIFT
            ).perform()
            self.page.at(k)
        time.sleep(0.5)  # allows time for the frame to arrive

    def seen(self, instant, path):
        self.go(instant)
        with open(path, "wb") as file:
            file.write(base64.b64decode(self.page.driver.execute_script(pane)))


def smaller(inputs, output, *how):
    subprocess.run(
        [
            "convert",
            *inputs,
            *how,
            "-dither",
            "None",
            "-colors",
            "128",
            "-strip",
            f"PNG8:{os.path.join(to, 'docs', output)}",
        ],
        check=True,
    )
    print(f"docs/{output}")


def main():
    with tempfile.TemporaryDirectory() as folder:

        def path(name):
            return os.path.join(folder, f"{name}.png")

        driver = start(1280, 1100)
        try:
            driver.set_window_size(1280, 863)  # leaves 1280×720 pixels for the page
            plots = "&plots=out.forward;out.turn;probe.wallFollow.s"
            follower = Run(driver, folder, "wall_follow", 60, plots)
            follower.page.press("f", "out.forward < 0.2[m/s]", Keys.ENTER)
            follower.page.wait(lambda: follower.page.text("#found") == "6 times")
            driver.execute_script("document.activeElement.blur()")
            follower.go(1010)
            driver.save_screenshot(path("view"))
            smaller([path("view")], "view.png")
            driver.set_window_size(1280, 1100)
            poster = Run(driver, folder, "track_poster", 6)
            instants = {"seen": 100, "predicted": 200, "lost": 220}
            for name, instant in instants.items():
                poster.seen(instant, path(name))
            smaller([path(name) for name in instants], "track_poster_seen.png", "+append")
            driver.set_window_size(1280, 860)
            poster.go(200)
            driver.save_screenshot(path("page"))
            smaller([path("page")], "view_camera.png")
            driver.set_window_size(1280, 1100)
            Run(driver, folder, "follow_ball", 7).seen(300, path("ball"))
            smaller([path("ball")], "follow_ball_seen.png")
        finally:
            driver.quit()


main()

"""usage: journey_saved.py FROBC RUN.csv FILE ROBOT

Saves a run as one HTML file, and opens it without a viewer."""

import base64
import os
import re
import sys
import tempfile

from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, start
from viewer import check

# The file that the button Save offers.
content = """
const done = arguments[0];
const make = URL.createObjectURL;
URL.createObjectURL = (blob) => {
  URL.createObjectURL = make;
  const reader = new FileReader();
  reader.onload = () => done(reader.result.split(",")[1]);
  reader.readAsDataURL(blob);
  return make.call(URL, blob);
};
HTMLAnchorElement.prototype.click = () => undefined;
[...document.querySelectorAll("#saving button")].find((each) => each.textContent === "Save").click();
"""


def main():
    frobc, recording, program, robot = sys.argv[1:]
    rows = viewer.trace(frobc, recording, program, robot)
    v = viewer.Viewer(frobc, recording, program)
    driver = start(1280, 720)
    driver.set_script_timeout(60)
    try:
        page = Page(driver, v.address)
        page.at(0)
        page.wait(lambda: page.text("#state") == "replayed: outputs as recorded")
        page.all("#save")[0].click()
        page.wait(lambda: page.all("#saving button")[0].is_displayed())
        told = re.search(r"this page: (\S+) (kB|MB)", page.text("#saving"))
        data = base64.b64decode(driver.execute_async_script(content))
        check(
            "its size is told first",
            told and abs(float(told[1]) * (1e3 if told[2] == "kB" else 1e6) - len(data)) < 1e5,
        )
        driver.get("about:blank")
        v.end()
        driver.get_log("browser")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bug.html")
            with open(path, "wb") as file:
                file.write(data)
            page = Page(driver, f"file://{path}")
            page.at(0)
            for k in 10, len(rows) - 1:
                page.press(*([Keys.END] if k > 10 else [Keys.ARROW_RIGHT] * 10))
                page.at(k)
                page.wait(
                    lambda: all(
                        page.cells().get(name, cell) == cell for name, cell in rows[k].items()
                    )
                )
            check("the file shows what is traced, without a viewer", True)
            check(
                "it has the source, plots and the map",
                driver.execute_script("""
                    const root = document.querySelector("#source > div").shadowRoot;
                    return root.querySelector(".cm-content").innerText.includes("main")
                        && document.querySelectorAll("#plots canvas").length > 1
                        && document.querySelector("#map canvas").width > 100"""),
            )
            check("it is not silent", not page.all("#contact")[0].is_displayed())
            messages = [entry["message"] for entry in driver.get_log("browser")]
            check("the browser has nothing to complain of", messages == [])
            for message in messages:
                print(message)
    finally:
        driver.quit()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)

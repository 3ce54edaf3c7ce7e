"""usage: journey_claims.py FROBC RUN.csv FILE ROBOT

Visits the page of a run in which assertions were violated: steps from one violation to the next, by
clicks and by keys."""

import sys
import tempfile

from selenium.webdriver.common.by import By

import viewer
from claims import make_run, violated
from journey import Page, start
from viewer import check


def row_of(page, label):
    return next(
        row
        for row in page.all("#claims button")
        if row.find_element(By.CSS_SELECTOR, "span").text == label
    )


def time_of(page):
    now = page.text("#now").split()
    return float(now[3]) if len(now) > 3 else float("nan")


def red(page):
    """Returns how much of the timeline is marked, at the height of the strip of violations."""
    return page.driver.execute_script("""
        const canvas = document.querySelector("#timeline canvas");
        const { width, height } = canvas;
        const y = height - Math.round(22 * devicePixelRatio);
        const data = canvas.getContext("2d").getImageData(0, y, width, 1).data;
        let marked = 0;
        for (let i = 0; i < data.length; i += 4) if (data[i] > data[i + 2] + 60) marked++;
        return marked / width;""")


def visit(page, rows, summary):
    slow = violated(rows, "main.assert is slow", None)
    room = violated(rows, "main.assert has room", None)
    page.wait(lambda: abs(time_of(page) - 15.9) < 1e-9)
    page.wait(lambda: "violated" in row_of(page, "is slow").get_attribute("class"))
    check("it begins at the instant that it was told", True)
    check(
        "each assertion says what became of it",
        all(
            row_of(page, shown).text.endswith(summary[label])
            for shown, label in [
                ("is slow", "is slow"),
                ("assume is early", "is early"),
                ("moves on", "moves on"),
            ]
        ),
    )
    check(
        "all in short", page.text("#claimed") == "2 of 5 assertions violated, 1 assumption failed"
    )
    row_of(page, "has room").click()
    after = next((t for t in room[::2] if t > 15.9), room[0])
    page.wait(lambda: time_of(page) == round(after, 3))
    page.wait(
        lambda: row_of(page, "has room")
        .find_element(By.CSS_SELECTOR, "i")
        .get_attribute("data-verdict")
        == "Fails"
    )
    check("a click goes to where it is next violated", True)
    page.driver.find_element(By.ID, "start").click()
    page.at(0)
    starts = sorted({*slow[::2], *room[::2]})
    for expected in starts[:3]:
        page.press("v")
        page.wait(lambda: time_of(page) == round(expected, 3))
    page.press("V")
    page.wait(lambda: time_of(page) == round(starts[1], 3))
    check("keys go from one violation to the next, and back", True)
    before = len(page.all("#plots article"))
    row_of(page, "moves on").click()
    page.wait(lambda: len(page.all("#plots article")) == before + 1)
    check("the verdict of one that held is plotted", True)
    bad = sum(
        row["probe.main.assert is slow"] == "Fails"
        or row["probe.main.assert has room"] == "Fails"
        or row["probe.main.assume is early"] == "Fails"
        for row in rows
    ) / len(rows)
    check("the time line is marked where one is violated", abs(red(page) - bad) < 0.05)


def main():
    frobc = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        program, recording, summary = make_run(frobc, folder)
        v = viewer.Viewer(frobc, recording, program, "--robot", "pioneer", "--at", "15.9s")
        rows = viewer.trace(frobc, recording, program, "pioneer")
        driver = start(1400, 900)
        try:
            visit(Page(driver, v.address), rows, summary)
            check("the page has no errors", driver.get_log("browser") == [])
        finally:
            driver.quit()
        v.end()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)

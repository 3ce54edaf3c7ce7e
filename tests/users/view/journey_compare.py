"""usage: journey_compare.py FROBC RUN.csv FILE ROBOT

Compares recordings: of another seed, and of another version of the program; aligned by the start, and
by a condition."""

import asyncio
import base64
import os
import shutil
import subprocess
import sys
import tempfile

from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, start
from journey_kept import press
from journey_saved import content
from protocol import ask, connect, greet
from viewer import check

condition = "mode.bug == withSF"


def record(frobc, program, path, *options):
    subprocess.run(
        [frobc, "run", "--for", "10s", "--record", path, *options, program],
        check=True,
        stdout=subprocess.DEVNULL,
    )


def first(rows):
    return next(k for k, row in enumerate(rows) if row["mode.bug"] == "withSF")


async def answers(v, rows, others):
    """Compares the answers with traces of both recordings."""
    async with connect(v) as client:
        program = await greet(v, client)
        names = [signal["name"] for signal in program["signals"]]
        outputs = [name for name in names if name.startswith("out.")]
        differs = next(
            k for k in range(len(rows)) if any(rows[k][n] != others[k][n] for n in outputs)
        )
        check("the first difference is found", program["other"]["first"] == differs)
        instant = await ask(client, "instant 250")
        check(
            "the values of both are there",
            instant["others"] == [others[250].get(name) for name in names],
        )
        shift = first(others) - first(rows)
        answer = await ask(client, f"align {condition}")
        check(
            "they are aligned by a condition",
            abs(answer["other"]["shift"] - shift / 50) < 1e-9 and shift != 0,
        )
        k = first(rows)
        instant = await ask(client, f"instant {k}")
        check(
            "then both values are of the same time",
            instant["others"] == [others[k + shift].get(name) for name in names],
        )
        at = names.index("out.turn")
        series = await ask(client, f"series {at} {rows[k]['time']} {rows[k + 5]['time']} 1000")
        check(
            "also in plots",
            series["others"][:5] == [float(others[k + shift + i]["out.turn"]) for i in range(5)],
        )
        answer = await ask(client, "align out.forward > 100[m/s]")
        check("a condition that never holds is told", "never true in" in answer["why"])
        answer = await ask(client, "align")
        check("the starts are aligned again", answer["other"]["shift"] == 0)


def visit(page, rows):
    page.at(0)
    page.wait(lambda: "Dashed: other.csv." in page.text("#compared"))
    check("the page names the other recording", "first in out." in page.text("#compared"))
    page.press(Keys.END)
    page.wait(lambda: any(e.text.startswith("other: ") for e in page.all("#plots .other")))
    check("and shows its values", True)
    page.all("#align")[0].send_keys(condition, Keys.ENTER)
    page.wait(lambda: "shifted by" in page.text("#compared"))
    check("it is aligned on the page", True)
    page.all("#align")[0].send_keys(" &&", Keys.ENTER)
    page.wait(lambda: "incomplete" in page.text("#align-said"))
    check("an error in a condition is told", True)
    press(page, "Range, XY plot, export")
    tool(page, "Largest difference").click()
    page.wait(lambda: "root mean square" in page.text(".plot-tools span output"))
    page.wait(lambda: page.instant() != len(rows) - 1)
    check("the largest difference is found", True)
    table = base64.b64decode(page.driver.execute_async_script(table_content)).decode()
    check("a table has both recordings", " of other.csv" in table.split("\n")[0])


def keep(page, path):
    """Saves the comparison as a file, and opens that."""
    at = page.instant()
    page.all("#save")[0].click()
    page.wait(lambda: page.all("#saving button")[0].is_displayed())
    with open(path, "wb") as file:
        file.write(base64.b64decode(page.driver.execute_async_script(content)))
    shown = page.text("#plots .other")
    page = Page(page.driver, f"file://{path}")
    page.at(at)
    page.wait(lambda: "Dashed: other.csv" in page.text("#compared"))
    page.wait(lambda: page.text("#plots .other") == shown != "")
    check("a saved page has both recordings, at the same instant", True)


def tool(page, name):
    return next(b for b in page.all(".plot-tools button") if b.text == name)


# The table that the button CSV offers.
table_content = content.replace("#saving button", ".plot-tools button").replace('"Save"', '"CSV"')


def main():
    frobc, _, program, robot = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        path = lambda name: os.path.join(folder, name)
        world = os.path.join(os.path.dirname(program), "world.toml")
        record(frobc, program, path("run.csv"))
        # By itself, the noise of another seed hardly changes the time at which the obstacle is
        # seen.
        with open(world) as file, open(path("near.toml"), "w") as near:
            near.write(file.read().replace("x = 0.8", "x = 1.3"))
        record(frobc, program, path("other.csv"), "--world", path("near.toml"), "--seed", "2")
        shutil.copytree(os.path.dirname(program), path("edited"))
        edited = path("edited/" + os.path.basename(program))
        with open(edited) as file:
            text = file.read()
        with open(edited, "w") as file:
            file.write(text.replace("13[m]", "12[m]"))
        record(frobc, edited, path("edited.csv"))
        rows, others = (
            viewer.trace(frobc, path(name), program, robot) for name in ("run.csv", "other.csv")
        )
        v = viewer.Viewer(frobc, path("run.csv"), program, "--compare", path("other.csv"))
        asyncio.run(answers(v, rows, others))
        driver = start(1280, 720)
        try:
            driver.set_script_timeout(60)
            page = Page(driver, v.address)
            visit(page, rows)
            keep(page, path("saved.html"))
            driver.get("about:blank")
            v.end()
            v = viewer.Viewer(frobc, path("run.csv"), program, "--compare", path("edited.csv"))
            page = Page(driver, v.address)
            page.at(0)
            page.wait(lambda: "from another version" in page.text("#compared"))
            check("a recording of another version is compared, too", True)
            messages = [entry["message"] for entry in driver.get_log("browser")]
            check("the browser has nothing to complain of", messages == [])
            for message in messages:
                print(message)
        finally:
            driver.quit()
        v.end()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)

"""usage: journey_examples.py FROBC RUN.csv FILE ROBOT

Opens the page of every example, for a live run and for its recording, and checks that the page has
no errors; also checks that it would detect an error."""

import os
import re
import subprocess
import sys
import tempfile

import viewer
from journey import Page, start
from viewer import check

root = "../../../examples"


def path(name):
    return os.path.join(root, name)


# Additional options for programs that need them.
pioneer = ["--robot", "pioneer"]
options = {
    "bug/clicked": pioneer,
    "safe_stick/safe_stick": pioneer,
    "teleop/go_there": pioneer,
    "teleop/teleop": pioneer,
    "light_seek/light_seek": [
        "--robot",
        path("light_seek/Moth.frob"),
        "--with",
        path("light_seek/moth_body.c"),
    ],
    "opencv_foreign/opencv_foreign": ["--with", path("opencv_foreign/camshift.cc")],
    "blob_tracker/blob_tracker": ["--with", path("blob_tracker/blob.c")],
}
# The input columns of programs that are not for a robot.
inputs = {
    "blob_tracker/blob_tracker": [f"in[{i}]" for i in range(96)],
    "chasing_cars/chasing_cars": ["in.throttle", "in.brake"],
    "from_c/wheel": ["in.wanted", "in.measured"],
}
# Modules that programs import.
modules = {"light_seek/Moth", "own_robot/Rover"}


def examples():
    names = sorted(
        f"{folder}/{file.removesuffix('.frob')}"
        for folder in os.listdir(root)
        if os.path.isdir(path(folder))
        for file in os.listdir(path(folder))
        if file.endswith(".frob") and not file.endswith(".test.frob")
    )
    return [name for name in names if name not in modules]


def lacks(frobc, name):
    """Why an example cannot be run here; empty if it can."""
    if name == "opencv_foreign/opencv_foreign":
        found = subprocess.run(
            ["sh", path("opencv_foreign/libraries.sh")], text=True, stdout=subprocess.PIPE
        )
        options[name] += found.stdout.split()
        return "" if found.returncode == 0 else "OpenCV is not installed"
    if name == "dock_tag/dock_tag":
        built = subprocess.run(
            [frobc, "run", "--only-build", path(f"{name}.frob")],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.PIPE,
            text=True,
        )
        return "libapriltag is not installed" if "apriltag" in built.stderr else ""
    return ""


def begin(frobc, folder, name):
    """Starts a viewer of a run, or of a recording if the program is not for a robot."""
    program, recording = path(f"{name}.frob"), os.path.join(folder, name.replace("/", "-") + ".csv")
    how = options.get(name, [])
    if name in inputs:
        with open(recording, "w") as file:
            print("time", *inputs[name], sep=",", file=file)
            for k in range(20):
                print(k / 10, *[k % 2] * len(inputs[name]), sep=",", file=file)
        return None, lambda: viewer.Viewer(frobc, recording, program, *how)
    return (
        viewer.Run(frobc, [*how, "--record", recording, program]),
        lambda: viewer.Viewer(frobc, recording, program, *how),
    )


def faults(page):
    """The errors that the page or the browser reports."""
    own = [page.text("#failed")] if page.all("#failed")[0].is_displayed() else []
    return own + [entry["message"] for entry in page.driver.get_log("browser")]


def is_whole(page):
    """Checks that no panel is empty, and that the page knows each of its controls."""
    return page.driver.execute_script("""
        const has = (selector) => document.querySelector(selector) !== null;
        return has("#list section > button") && has("#plots canvas") && has("#timeline canvas")
            && document.querySelector("#source > div").shadowRoot.querySelector(".cm-line") !== null
            && !document.body.textContent.includes("this page does not support");""")


def told(name, what, found):
    check(f"{name}: {what}", found == [])
    for fault in found:
        print(fault)


def visit(driver, name, run, view):
    if run is not None:
        page = Page(driver, run.address)
        page.wait(lambda: page.text("#now").startswith("instant ") or faults(page))
        page.wait(lambda: is_whole(page) or faults(page))
        told(name, "its run is shown", faults(page))
        page.driver.execute_script("document.getElementById('stop').click()")
        page.wait(lambda: page.text("#fate") == "Stopped." or faults(page))
    v = view()
    page = Page(driver, v.address)
    page.wait(lambda: page.text("#state").startswith("replayed") or faults(page))
    page.wait(lambda: page.text("#now").startswith("instant 0 ") or faults(page))
    page.wait(lambda: is_whole(page) or faults(page))
    told(name, "its recording is shown", faults(page))
    modes = [mode.get_attribute("textContent") for mode in page.all(".modes button")]
    told(
        name, "no mode has a name such as timeOut.2", [m for m in modes if re.search(r"\.\d+$", m)]
    )
    driver.get("about:blank")
    v.end()


# Simulates a viewer with a kind of control that the page does not know.
newer = """
const parse = JSON.parse;
JSON.parse = (text) => parse(text.replaceAll('"kind":"knob"', '"kind":"lever"'));
"""


def unknown(driver, frobc):
    run = viewer.Run(frobc, [*pioneer, path("teleop/teleop.frob")])
    script = driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": newer})
    page = Page(driver, run.address)
    page.wait(lambda: "does not support “lever”" in page.text("#console"))
    check(
        "a control of a kind that the page does not know is named, and the others are there",
        len(page.all("#console button")) == 3 and faults(page) == [],
    )
    driver.execute_cdp_cmd("Page.removeScriptToEvaluateOnNewDocument", script)
    driver.execute_script("setTimeout(() => { throw new Error('made up'); })")
    page.wait(lambda: "This page has failed" in page.text("#failed"))
    check("a fault of the page is shown on it", page.all("#failed")[0].is_displayed())
    driver.get("about:blank")
    driver.get_log("browser")
    run.kill()


def main():
    frobc = sys.argv[1]
    names = examples()
    driver = start(1280, 720)
    with tempfile.TemporaryDirectory() as folder:
        try:
            unknown(driver, frobc)
            for name in names:
                if reason := lacks(frobc, name):
                    print(f"skipped: {name}: {reason}")
                else:
                    visit(driver, name, *begin(frobc, folder, name))
        finally:
            driver.quit()


if __name__ == "__main__":
    main()
    sys.exit(viewer.failures > 0)

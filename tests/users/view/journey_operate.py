"""usage: journey_operate.py FROBC RUN.csv FILE ROBOT

Visits the page of a run as an operator with a phone held upright: holds a button and sees the robot
drive, turns a knob, switches something off, clicks on the map."""

import sys

from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

import viewer
from journey import Page, start
from live import Robot
from viewer import check

teleop = "../../../examples/teleop/teleop.frob"
go_there = "../../../examples/teleop/go_there.frob"


def cell(page, name):
    return page.cells()[name]


def control(page, label):
    return next(found for found in page.all("#console > *") if found.text.startswith(label))


def drive(page):
    page.wait(lambda: page.text("#follow") == "Live")
    labels = [found.text.split("\n")[0] for found in page.all("#console > *")]
    check(
        "the page has what the program asks for",
        labels == ["drive", "back", "speed", "turn", "careful"],
    )
    check(
        "large enough for thumbs",
        all(
            found.size["height"] >= 48 and found.size["width"] >= 48
            for found in page.all("#console button, #console input")
        ),
    )
    check("knobs show their units", "0.25[m/s]" in control(page, "speed").text)
    button = control(page, "drive")
    ActionChains(page.driver).click_and_hold(button).perform()
    page.wait(lambda: float(cell(page, "in.odometry.position.x")) > 0.1)
    check("the robot drives while a button is held", cell(page, "in.console.drive") == "true")
    ActionChains(page.driver).release(button).perform()
    page.wait(lambda: cell(page, "in.console.drive") == "false")
    check("and no longer", True)
    slider = control(page, "speed").find_element("css selector", "input")
    slider.send_keys(Keys.END)
    page.wait(lambda: cell(page, "in.console.speed") == "0.5")
    check("a knob is turned", "0.5[m/s]" in control(page, "speed").text)
    control(page, "careful").click()
    page.wait(lambda: cell(page, "in.console.careful") == "false")
    check("a toggle is switched", control(page, "careful").get_attribute("aria-checked") == "false")
    page.driver.execute_script("arguments[0].focus()", button)
    ActionChains(page.driver).key_down(Keys.SPACE).perform()
    page.wait(lambda: cell(page, "in.console.drive") == "true")
    page.driver.execute_script("arguments[0].blur()", button)
    page.wait(lambda: cell(page, "in.console.drive") == "false")
    check("a key holds a button, as long as it has the focus", True)
    ActionChains(page.driver).key_up(Keys.SPACE).perform()
    finish(page)


def click(page):
    page.wait(lambda: page.text("#follow") == "Live")
    page.driver.execute_script("document.querySelector('#panels [data-panel=map]').click()")
    canvas = page.wait(lambda: next((c for c in page.all("#map canvas") if c.is_displayed()), None))
    ActionChains(page.driver).move_to_element_with_offset(canvas, 20, 0).click().perform()
    page.wait(
        lambda: abs(float(cell(page, "in.odometry.heading"))) > 0.01
        or float(cell(page, "in.odometry.position.x")) > 0.02
    )
    check("the robot sets off for a click on the map", page.text("#follow") == "Live")
    finish(page)


def finish(page):
    page.all("#stop")[0].click()
    page.wait(lambda: page.text("#follow") == "The run is over")
    check("when it is over there is nothing to operate", not page.all("#console")[0].is_displayed())
    for entry in page.driver.get_log("browser"):
        check(entry["message"], False)


def look(page):
    page.wait(lambda: page.text("#follow") == "Live")
    page.wait(lambda: "--view=control" in page.text("#console"))
    check(
        "of a robot that is only looked at the page says so, and how to operate it",
        not any(found.is_displayed() for found in page.all("#console button, #console input")),
    )
    finish(page)


def main():
    frobc = sys.argv[1]
    for program, visit in (teleop, drive), (go_there, click):
        run = viewer.Run(frobc, ["--robot", "pioneer", program])
        driver = start(412, 915)
        try:
            visit(Page(driver, run.address))
        finally:
            driver.quit()
        check("and the run ends well", run.process.wait(20) == 0)
    with Robot(frobc) as device:
        run = viewer.Run(frobc, [*device, teleop])
        driver = start(412, 915)
        try:
            look(Page(driver, run.address))
        finally:
            driver.quit()
        run.process.wait(20)


main()
sys.exit(viewer.failures > 0)

"""Tests cameras against rclpy. usage: cameras.py FROBC FOLDER"""

import ctypes
import os
import time

import nodes
from peer import Base
from rclpy.qos import qos_profile_sensor_data as SENSOR_DATA
from sensor_msgs.msg import CompressedImage, Image

# Drives at 0.2 m/s if it sees only red, and slower otherwise.
RED = """import Robot
import Vision

red :: ColourRange
red = ColourRange
    { hueFrom = -10[deg], hueTo = 10[deg], saturationFrom = 0.8, saturationTo = 1
    , valueFrom = 0.5, valueTo = 1
    }

main :: (HasCamera i, DiffDrive o) => Program i o
main = reactimateRobot (proc i -> roMake (setVelTR (hold 0 (mapE speed (camera i))) 0))

speed :: Frame -> Velocity
speed f = if (findBlob f.image (everywhere f.image) red).pixels > 1100 then 0.2[m/s] else 0.1[m/s]
"""

WIDTH, HEIGHT = 40, 30


def picture(encoding, pixel, padding=0):
    message = Image(width=WIDTH, height=HEIGHT, encoding=encoding)
    message.step = WIDTH * len(pixel) + padding
    message.data = (bytes(pixel) * WIDTH + bytes(padding)) * HEIGHT
    return message


def red_jpeg():
    """The red picture as JPEG."""
    turbo = ctypes.CDLL("libturbojpeg.so.0")
    turbo.tjInitCompress.restype = ctypes.c_void_p
    handle = ctypes.c_void_p(turbo.tjInitCompress())
    result, size = ctypes.c_void_p(), ctypes.c_ulong()
    pixels = bytes([250, 0, 0]) * (WIDTH * HEIGHT)
    # Pixels of the format 0 are red, green and blue.
    status = turbo.tjCompress2(
        *[handle, pixels, WIDTH, 0, HEIGHT, 0],
        *[ctypes.byref(result), ctypes.byref(size), 0, 95, 0],
    )
    assert status == 0
    return ctypes.string_at(result.value, size.value)


def drives_at(base, publisher, make, speed):
    """Publishes images until the robot drives at this speed."""

    def holds():
        message = make()
        message.header.stamp = base.now().to_msg()
        publisher.publish(message)
        time.sleep(0.05)
        return base.v == speed

    base.until(holds, f"the robot drives at {speed} m/s", 30)


def reports(base, run, text):
    """Waits until the run prints a text."""

    def holds():
        with open(run.errors.name, encoding="utf-8") as file:
            return text in file.read()

    base.until(holds, f"the run reports: {text}", 30)


def test_image():
    """A program sees the images of a topic in all encodings that it supports."""
    nodes.write("red.frob", RED)
    base = nodes.robot()
    publisher = base.node.create_publisher(Image, "front/image", SENSOR_DATA)
    run = nodes.Run("--camera", "ros:front/image", program="red.frob")
    drives_at(base, publisher, lambda: picture("rgb8", [250, 0, 0]), 0.2)
    drives_at(base, publisher, lambda: picture("bgr8", [250, 0, 0], 6), 0.1)
    drives_at(base, publisher, lambda: picture("bgr8", [0, 0, 250], 6), 0.2)
    publisher.publish(picture("yuv422", [1, 2]))
    reports(base, run, "its encoding is not rgb8, bgr8 or mono8, but yuv422")
    run.end()
    base.close()


def test_grey():
    """A program sees grey images."""
    nodes.write("red.frob", RED)
    base = nodes.robot()
    publisher = base.node.create_publisher(Image, "image_raw", SENSOR_DATA)
    run = nodes.Run(program="red.frob")
    drives_at(base, publisher, lambda: picture("mono8", [250]), 0.1)
    output, _ = run.end()
    assert "camera: 40 x 30, grey" in output, output
    base.close()


def test_default_topic():
    """Without --camera, the topic is image_raw; a reliable publisher matches too."""
    nodes.write("red.frob", RED)
    base = nodes.robot()
    publisher = base.node.create_publisher(Image, "eye/image_raw", 10)
    run = nodes.Run(
        "--ros-args", "-r", "image_raw:=eye/image_raw", "-r", "__node:=seer", program="red.frob"
    )
    drives_at(base, publisher, lambda: picture("rgb8", [250, 0, 0]), 0.2)
    names = base.node.get_node_names()
    assert "seer" in names and "seer_camera" in names, names
    _, errors = run.end()
    assert "another node" not in errors, errors
    base.close()


def test_compressed():
    """A topic with JPEG images is shown, and other formats are refused by name."""
    nodes.write("red.frob", RED)
    jpeg = red_jpeg()
    base = nodes.robot()
    publisher = base.node.create_publisher(CompressedImage, "eye/compressed", SENSOR_DATA)
    run = nodes.Run("--camera", "ros:eye/compressed", program="red.frob")
    drives_at(base, publisher, lambda: CompressedImage(format="jpeg", data=jpeg), 0.2)
    publisher.publish(CompressedImage(format="png", data=b"\x89PNG"))
    reports(base, run, "it is not a JPEG; its format is png")
    run.end()
    base.close()


def test_silence():
    """A topic without images, or with another type, is reported, and the robot is not stopped."""
    nodes.write("red.frob", RED)
    base = nodes.robot()
    base.node.create_publisher(CompressedImage, "odd", 10)
    run = nodes.Run("--camera", "ros:odd", program="red.frob")
    reports(base, run, "publishes sensor_msgs/msg/CompressedImage on /odd")
    run.end()
    run = nodes.Run(program="red.frob")
    reports(base, run, "no node publishes /image_raw (sensor_msgs/msg/Image)")
    run.end()
    base.close()


def test_simulator():
    """The simulated robot publishes the images of the world's camera."""
    nodes.write("seen.toml", "[start]\nx = 1\ny = 1\n[camera]\nwidth = 160\nheight = 120\n")
    served = nodes.Served("--world", os.path.join(nodes.FOLDER, "seen.toml"))
    base = Base(name="observer", odom="unused_odom", cmd_vel="unused_cmd_vel")
    nodes.OPEN.append(base.close)
    images = []
    base.node.create_subscription(Image, "image_raw", images.append, SENSOR_DATA)
    base.until(lambda: len(images) > 3, "images arrive", 30)
    _, errors = served.end()
    image = images[-1]
    assert (image.width, image.height, image.encoding) == (160, 120, "rgb8"), image.encoding
    assert len(image.data) == 160 * 120 * 3 and len(set(image.data)) > 3
    assert image.header.frame_id == "camera_link" and errors == "", errors
    base.close()


def test_ends():
    """The process of the camera ends with the run, even after a kill."""
    nodes.write("red.frob", RED)
    base = nodes.robot()
    publisher = base.node.create_publisher(Image, "image_raw", SENSOR_DATA)
    run = nodes.Run(program="red.frob")
    drives_at(base, publisher, lambda: picture("rgb8", [250, 0, 0]), 0.2)
    run.process.kill()
    base.until(
        lambda: "red_camera" not in base.node.get_node_names(), "the camera's node is gone", 60
    )
    base.close()


if __name__ == "__main__":
    nodes.run_tests(globals())

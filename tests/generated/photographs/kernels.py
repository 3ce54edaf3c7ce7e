"""Calls the vision kernels (runtime/vision) and the tag detector from Python, with a shared library
and the structs of <frob/image.h>, <frob/lens.h> and <frob/vision.h>. Also prints rows of the table.
"""

import ctypes
import json
import sys

import numpy as np

C, Double, Int = ctypes, ctypes.c_double, ctypes.c_int32


def struct(name, *fields):
    return type(name, (C.Structure,), {"_fields_": list(fields)})


def doubles(names):
    return [(name, Double) for name in names.split()]


Camera = struct(
    "Camera", *doubles("focal_x focal_y centre_x centre_y k1 k2 k3 p1 p2 x y z yaw pitch roll")
)
Image = struct(
    "Image",
    ("width", Int),
    ("height", Int),
    ("stride", Int),
    ("format", C.c_int),
    ("pixels", C.c_void_p),
    ("captured_ns", C.c_int64),
    ("number", C.c_uint32),
    ("camera", Camera),
)
Lens = struct(
    "Lens",
    *doubles(
        "width height focal_x focal_y centre_x centre_y k1 k2 k3 p1 p2 ahead left up yaw pitch roll"
    ),
)
Region = struct("Region", *doubles("x y width height"))
Vec2 = struct("Vec2", *doubles("x y"))
Vec3 = struct("Vec3", *doubles("x y z"))
Corner = struct("Corner", *doubles("x y score"))
Stereo = struct("Stereo", ("roi", Region), ("disparities", Int), ("window", Int))
Tag = struct("Tag", ("id", Int), ("middle", Vec2), ("corners", Vec2 * 4), ("margin", Double))
Tags = struct("Tags", ("count", C.c_size_t), ("each", Tag * 8))
TagPlace = struct(
    "TagPlace", ("middle", Vec3), ("facing", Vec3), ("residual", Double), ("ambiguity", Double)
)
Finder = struct(
    "Finder",
    ("detector", C.c_void_p),
    ("family", C.c_void_p),
    ("grey", C.c_void_p),
    ("room", C.c_size_t),
)


class Kernels:
    """The kernels for grey images, given as byte arrays with rows first."""

    def __init__(self, library):
        self.library = C.CDLL(library)
        self.library.frob_stereo_room.restype = C.c_size_t
        self.library.frob_match_stereo.restype = C.c_bool
        self.library.tag_finder_open.restype = C.c_bool
        self.library.tag_finder_find.restype = C.c_bool
        self.finder = None

    def image(self, pixels):
        height, width = pixels.shape
        return Image(width, height, width, 0, pixels.ctypes.data, 0, 0, Camera(1, 1))

    def disparities(self, left, right, most, window):
        """Disparities in 1/16 pixel; -1 if unknown."""
        height, width = left.shape
        how = Stereo(Region(0, 0, width, height), most, window)
        size = self.library.frob_stereo_room(width, C.byref(how))
        room = np.zeros(size // 2 + 1, np.uint16)
        found = np.empty((height, width), np.int16)
        assert self.library.frob_match_stereo(
            C.byref(self.image(left)),
            C.byref(self.image(right)),
            C.byref(how),
            C.c_void_p(room.ctypes.data),
            C.c_size_t(size),
            C.c_void_p(found.ctypes.data),
            width,
        )
        return found

    def corner(self, pixels, x, y, reach):
        """The most corner-like place in a square of whole pixels around a place."""
        side = 2 * reach + 1
        found = Corner()
        self.library.frob_find_corner(
            C.byref(self.image(pixels)),
            C.byref(Region(x - reach, y - reach, side, side)),
            C.byref(found),
        )
        return found.x, found.y

    def bent(self, straighten, points, matrix, distortion, size):
        """Applies a lens's distortion to points, or removes it; `distortion` contains five
        numbers in OpenCV's order.
        """
        k1, k2, p1, p2, k3 = distortion
        image = Image(
            size[0],
            size[1],
            size[0],
            0,
            None,
            0,
            0,
            Camera(matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2], k1, k2, k3, p1, p2),
        )
        call = self.library.frob_undistort_point if straighten else self.library.frob_distort_point
        found = []
        for x, y in points:
            to = Vec2()
            call(C.byref(image), C.byref(Vec2(x, y)), C.byref(to))
            found.append((to.x, to.y))
        return np.array(found)

    def tags(self, pixels):
        """The eight largest tags: maps their numbers to the results."""
        if self.finder is None:
            self.finder = Finder()
            assert self.library.tag_finder_open(C.byref(self.finder))
        found = Tags()
        assert self.library.tag_finder_find(
            C.byref(self.finder), C.byref(self.image(pixels)), C.byref(found)
        )
        return {tag.id: tag for tag in found.each[: found.count]}

    def tag_place(self, tag, size, matrix, image_size):
        lens = Lens(
            image_size[0], image_size[1], matrix[0, 0], matrix[1, 1], matrix[0, 2], matrix[1, 2]
        )
        found = TagPlace()
        self.library.frob_find_tag_place(C.byref(lens), Double(size), C.byref(tag), C.byref(found))
        return found


failed = []


def row(measure, value, reference, unit, most=None):
    """Prints a figure and its reference. The test fails if the figure exceeds `most` times the
    reference.
    """
    if most is not None and not value <= most * reference:
        failed.append(f"{measure}: {value:.4g} {unit}, and not {most:g} times {reference:.4g}")
    print(
        json.dumps(
            {
                "program": "photographs",
                "measure": measure,
                "compiler": "gcc -O3",
                "value": round(float(value), 4),
                "reference": round(float(reference), 4),
                "ratio": round(float(value / reference), 3),
                "unit": unit,
            }
        ),
        flush=True,
    )


def end():
    for line in failed:
        print("too much: " + line, file=sys.stderr)
    sys.exit(1 if failed else 0)

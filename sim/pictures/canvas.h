// An SVG or PNG file to draw on. Units are pixels, with x to the right and y down.
#pragma once

#include <string>
#include <vector>

#include "geometry.h"

namespace frob::sim {

struct Colour {
    int red, green, blue;
    double opacity = 1.0;
};

// How a shape looks: filled, stroked, or both.
struct Paint {
    Colour fill{0, 0, 0, 0.0};
    Colour stroke{0, 0, 0, 0.0};
    double width = 1.0;
    std::vector<double> dash; // lengths of strokes and gaps
};

inline Paint filled(Colour colour) { return {colour, {0, 0, 0, 0.0}, 1.0, {}}; }
inline Paint stroked(Colour colour, double width, std::vector<double> dash = {}) {
    return {{0, 0, 0, 0.0}, colour, width, std::move(dash)};
}

enum class Anchor { start, middle, end };

struct TextStyle {
    double size = 12.0;
    Colour colour{40, 44, 52};
    Anchor anchor = Anchor::start;
    bool bold = false;
};

class Canvas {
  public:
    virtual ~Canvas() = default;

    // Joins and ends of lines are round.
    virtual void path(const std::vector<Vec> &points, bool closed, const Paint &paint) = 0;
    virtual void circle(Vec center, double radius, const Paint &paint) = 0;
    // `at` is on the text's baseline.
    virtual void text(Vec at, const std::string &text, const TextStyle &style) = 0;

    // Draws an image with its upper left corner at `corner`. Rows start at the top, with three
    // bytes per pixel.
    virtual void image(Vec corner, Vec size, int width, int height,
                       const std::vector<unsigned char> &rgb) = 0;

    // Clips all drawing to this rectangle until `unclip`.
    virtual void clip(Vec corner, Vec size) = 0;
    virtual void unclip() = 0;

    // Writes the file. Throws std::runtime_error on failure.
    virtual void save(const std::string &file) = 0;
};

} // namespace frob::sim

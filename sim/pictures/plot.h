// A plot of signals over time.
#pragma once

#include <string>
#include <vector>

#include "canvas.h"

namespace frob::sim {

struct Series {
    enum class Style { line, thin_line, dashes, dots };
    std::string name;
    Colour colour;
    Style style;
    std::vector<Vec> points; // (time in s, value); a non-finite value leaves a gap
};

struct Plot {
    std::string title; // includes the unit
    double low, high;  // visible range of values; the rest is clipped
    double end_s;      // end of the time axis, which starts at 0
    std::vector<Series> series;
    bool time_axis = false; // whether to label the time axis below the plot
};

// Draws the plot into the rectangle. The labels of the axes go to its left and below it, and the
// title and legend above it.
void draw_plot(Canvas &canvas, const Plot &plot, Vec corner, Vec size);

// The distance between ticks that divides the range into approximately `count` parts: 1, 2 or 5
// times a power of ten.
double tick_step(double range, int count);

// Formats the number at a tick with as many decimal places as the step needs.
std::string tick_label(double value, double step);

} // namespace frob::sim

// A plot of signals over time.
#pragma once

#include <string>
#include <vector>

#include "canvas.h"

namespace frob::sim
{

struct Series {
    enum class Style { line, thin_line, dashes, dots };
    std::string name;
    Colour colour;
    Style style;
    std::vector<Vec> points; // (time in s, value); what is not finite is a gap
};

struct Plot {
    std::string title; // with the unit
    double low, high;  // values that are shown; beyond them is cut off
    double end_s;      // time goes from 0 to this
    std::vector<Series> series;
    bool time_axis = false; // labelled below
};

// Draws it into the rectangle; labels stand left of and below it.
void draw_plot(Canvas &canvas, const Plot &plot, Vec corner, Vec size);

// The distance between ticks, 1, 2 or 5 times a power of ten, for which about
// `count` fit into the range.
double tick_step(double range, int count);

// A number at a tick, with as many decimals as the step needs.
std::string tick_label(double value, double step);

} // namespace frob::sim

#include "plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "palette.h"

namespace frob::sim {
namespace {

constexpr double label_size = 11.0;

// Estimates the width of a string, because a canvas cannot measure text before drawing it. The
// estimate is accurate to within a few per cent for DejaVu Sans.
double text_width(const std::string &text, double size) {
    double widths = 0.0;
    for (const char c : text) {
        if (std::string("ijl' ").find(c) != std::string::npos)
            widths += 0.31;
        else if (std::string("frt").find(c) != std::string::npos)
            widths += 0.38;
        else if (std::string("mw").find(c) != std::string::npos)
            widths += 0.9;
        else
            widths += 0.61;
    }
    return widths * size;
}

// Thins out the points, because many samples fall into the same column of pixels. Keeps the first,
// lowest, highest and last point of each column, so that no peak is lost.
std::vector<std::vector<Vec>> thinned(const std::vector<Vec> &points) {
    std::vector<std::vector<Vec>> pieces(1);
    for (std::size_t i = 0; i < points.size();) {
        if (!std::isfinite(points[i].y)) {
            if (!pieces.back().empty()) pieces.emplace_back();
            ++i;
            continue;
        }
        std::size_t low = i, high = i, last = i;
        std::size_t j = i;
        for (; j < points.size() && std::isfinite(points[j].y) &&
               std::floor(points[j].x) == std::floor(points[i].x);
             ++j) {
            if (points[j].y < points[low].y) low = j;
            if (points[j].y > points[high].y) high = j;
            last = j;
        }
        std::vector<std::size_t> kept = {i, low, high, last};
        std::sort(kept.begin(), kept.end());
        kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
        for (const std::size_t k : kept) pieces.back().push_back(points[k]);
        i = j;
    }
    return pieces;
}

void draw_series(Canvas &canvas, const Series &series, const std::vector<Vec> &points) {
    if (series.style == Series::Style::dots) {
        for (const Vec &p : points)
            if (std::isfinite(p.y))
                canvas.circle(p, 1.4, filled(palette::faded(series.colour, 0.6)));
        return;
    }
    const double width = series.style == Series::Style::line ? 1.6 : 1.1;
    const std::vector<double> dash = series.style == Series::Style::dashes
                                         ? std::vector<double>{4.0, 4.0}
                                         : std::vector<double>();
    for (const std::vector<Vec> &piece : thinned(points))
        canvas.path(piece, false, stroked(series.colour, width, dash));
}

// Draws the legend above the plot, from right to left.
void draw_legend(Canvas &canvas, const std::vector<Series> &series, Vec right_end) {
    double x = right_end.x;
    for (auto s = series.rbegin(); s != series.rend(); ++s) {
        if (s->name.empty()) continue;
        canvas.text({x, right_end.y}, s->name, {label_size, palette::ink, Anchor::end, false});
        x -= text_width(s->name, label_size) + 7.0;
        const double y = right_end.y - 4.0;
        if (s->style == Series::Style::dots) {
            for (const double dx : {2.0, 8.0, 14.0})
                canvas.circle({x - dx, y}, 1.8, filled(s->colour));
        } else {
            draw_series(canvas, *s, {{x - 16.0, y}, {x, y}});
        }
        x -= 36.0;
    }
}

} // namespace

double tick_step(double range, int count) {
    const double rough = range / count;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= rough * (1 - 1e-9)) return factor * power;
    return 10.0 * power;
}

std::string tick_label(double value, double step) {
    const int decimals = step >= 1.0 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, std::abs(value) < step / 2 ? 0.0 : value);
    // U+2212 is a minus sign as wide as a plus sign.
    return text[0] == '-' ? "\u2212" + std::string(text + 1) : std::string(text);
}

void draw_plot(Canvas &canvas, const Plot &plot, Vec corner, Vec size) {
    const auto place = [&](Vec p) {
        return Vec{corner.x + p.x / plot.end_s * size.x,
                   corner.y + (plot.high - p.y) / (plot.high - plot.low) * size.y};
    };
    const std::vector<Vec> outline = {
        corner, {corner.x + size.x, corner.y}, corner + size, {corner.x, corner.y + size.y}};
    canvas.path(outline, true, filled(palette::floor));

    const double value_step = tick_step(plot.high - plot.low, 5);
    for (double n = std::ceil(plot.low / value_step - 1e-9);
         n * value_step <= plot.high + 1e-9 * value_step; ++n) {
        const Vec at = place({0.0, n * value_step});
        const Colour colour = n == 0.0 ? palette::frame : palette::grid;
        canvas.path({at, {corner.x + size.x, at.y}}, false, stroked(colour, 1.0));
        canvas.text({corner.x - 8.0, at.y + 4.0}, tick_label(n * value_step, value_step),
                    {label_size, palette::faint_ink, Anchor::end, false});
    }
    const double time_step = tick_step(plot.end_s, 10);
    for (double n = 0.0; n * time_step <= plot.end_s * (1 + 1e-9); ++n) {
        const Vec at = place({n * time_step, plot.low});
        canvas.path({at, {at.x, corner.y}}, false, stroked(palette::grid, 1.0));
        if (plot.time_axis)
            canvas.text({at.x, at.y + 17.0}, tick_label(n * time_step, time_step),
                        {label_size, palette::faint_ink, Anchor::middle, false});
    }
    if (plot.time_axis)
        canvas.text({corner.x + size.x / 2, corner.y + size.y + 34.0}, "time [s]",
                    {label_size + 1.0, palette::ink, Anchor::middle, false});

    canvas.clip(corner, size);
    for (const Series &series : plot.series) {
        std::vector<Vec> points;
        points.reserve(series.points.size());
        for (const Vec &p : series.points) points.push_back(place(p));
        draw_series(canvas, series, points);
    }
    canvas.unclip();
    canvas.path(outline, true, stroked(palette::frame, 1.0));
    canvas.text({corner.x, corner.y - 7.0}, plot.title,
                {label_size + 1.0, palette::ink, Anchor::start, true});
    draw_legend(canvas, plot.series, {corner.x + size.x, corner.y - 7.0});
}

} // namespace frob::sim

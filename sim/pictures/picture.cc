#include "picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "palette.h"
#include "plot.h"
#include "png_canvas.h"
#include "scene_view.h"
#include "svg_canvas.h"

namespace frob::sim {
namespace {

constexpr double width = 900.0;
constexpr double left = 58.0, right = 24.0; // margins on both sides of the drawing
constexpr double head = 58.0;               // space for the title
constexpr double most_scene_height = 640.0;
constexpr double frame_height = 180.0, frame_room = 52.0; // size of a camera's picture
constexpr double plot_height = 96.0, plot_gap = 34.0, time_labels = 46.0;

double seconds(std::int64_t time_ns) { return static_cast<double>(time_ns) * 1e-9; }

Series line(const Simulation &simulation, const std::string &name, Colour colour,
            Series::Style style, double Sample::*value) {
    Series series{name, colour, style, {}};
    for (const Sample &s : simulation.recorder().samples())
        series.points.push_back({seconds(s.time_ns), s.*value});
    return series;
}

void add_echoes(const Simulation &simulation, std::size_t transducer, Series &series) {
    for (const Echo &echo : simulation.robot().echoes())
        if (echo.transducer == transducer)
            series.points.push_back({seconds(echo.time_ns), echo.distance});
}

// Sets the range of the plot so that it covers `low` to `high` and the whole last series, plus a
// margin. The other series are clipped if they exceed it, so that a single outlier among the echoes
// or commands does not flatten the rest.
void fit(Plot &plot, double low, double high) {
    const Series &series = plot.series.back();
    for (const Vec &p : series.points)
        if (std::isfinite(p.y)) low = std::min(low, p.y), high = std::max(high, p.y);
    const double room = 0.08 * std::max(high - low, 0.1);
    plot.low = low < 0.0 ? low - room : low;
    plot.high = high + room;
}

Plot wall_plot(const Simulation &simulation, double end_s) {
    Plot plot{"distance to the wall [m]", 0.0, 0.0, end_s, {}};
    const std::optional<MeasureSettings> &measure = simulation.scene().measure;
    const bool on_left = !measure || measure->side == MeasureSettings::Side::left;
    const RangeFinders &finders = simulation.robot().chassis().range_finders;
    const std::string side = on_left ? "left " : "right ";
    Series echoes{"echoes of the " + side + finders.noun, palette::sonar, Series::Style::dots, {}};
    add_echoes(simulation, on_left ? finders.left : finders.right, echoes);
    if (!measure) {
        plot.title = side + finders.noun + " [m]";
        plot.series = {echoes};
        fit(plot, 0.0, 0.5);
        return plot;
    }
    plot.series = {
        echoes,
        {"target",
         palette::target,
         Series::Style::dashes,
         {{0.0, measure->distance}, {end_s, measure->distance}}},
        line(simulation, "truth", palette::truth, Series::Style::line, &Sample::measured_distance)};
    fit(plot, 0.0, 1.5 * measure->distance);
    return plot;
}

Plot tape_plot(const Simulation &simulation, double end_s) {
    Plot plot{"distance from the middle of the tape [m]",
              0.0,
              0.0,
              end_s,
              {line(simulation, "truth", palette::truth, Series::Style::line,
                    &Sample::measured_distance)}};
    fit(plot, 0.0, 0.05);
    return plot;
}

Plot ball_plot(const Simulation &simulation, double end_s) {
    const double distance = simulation.scene().measure->distance;
    Plot plot{
        "distance to the ball [m]",
        0.0,
        0.0,
        end_s,
        {{"target", palette::target, Series::Style::dashes, {{0.0, distance}, {end_s, distance}}},
         line(simulation, "truth", palette::truth, Series::Style::line,
              &Sample::measured_distance)}};
    fit(plot, 0.0, 1.5 * distance);
    return plot;
}

// Plots the distance that the world file selects for measurement.
Plot distance_plot(const Simulation &simulation, double end_s) {
    const std::optional<MeasureSettings> &measure = simulation.scene().measure;
    if (measure && measure->what == MeasureSettings::What::tape)
        return tape_plot(simulation, end_s);
    if (measure && measure->what == MeasureSettings::What::ball)
        return ball_plot(simulation, end_s);
    return wall_plot(simulation, end_s);
}

Plot front_plot(const Simulation &simulation, double end_s) {
    Series echoes{"echoes", palette::sonar, Series::Style::dots, {}};
    const RangeFinders &finders = simulation.robot().chassis().range_finders;
    for (const std::size_t transducer : finders.front) add_echoes(simulation, transducer, echoes);
    Plot plot{std::string("front ") + finders.noun + "s [m]", 0.0, 0.0, end_s, {echoes}};
    fit(plot, 0.0, 1.0);
    return plot;
}

Plot speed_plot(const Simulation &simulation, double end_s) {
    Plot plot{"v [m/s]",
              0.0,
              0.0,
              end_s,
              {line(simulation, "commanded", palette::command, Series::Style::thin_line,
                    &Sample::commanded_forward),
               line(simulation, "driven", palette::truth, Series::Style::line, &Sample::forward)}};
    fit(plot, 0.0, 0.1);
    return plot;
}

Plot turn_plot(const Simulation &simulation, double end_s) {
    Plot plot{"\u03c9 [rad/s]",
              0.0,
              0.0,
              end_s,
              {line(simulation, "commanded", palette::command, Series::Style::thin_line,
                    &Sample::commanded_turn),
               line(simulation, "driven", palette::truth, Series::Style::line, &Sample::turn)}};
    fit(plot, -0.5, 0.5);
    plot.time_axis = true;
    return plot;
}

std::string subtitle(const Simulation &simulation) {
    int collisions = 0;
    double driven = 0.0;
    for (std::size_t k = 0; k < simulation.robots(); ++k) {
        collisions += simulation.robot(k).contacts().collisions();
        driven += simulation.recorder(k).distance_driven();
    }
    char text[160];
    const int length_so_far = std::snprintf(
        text, sizeof text, "%.4g s, %.2f m driven, %d collision%s, ", seconds(simulation.time_ns()),
        driven, collisions, collisions == 1 ? "" : "s");
    const auto rest = static_cast<std::size_t>(length_so_far);
    if (simulation.robots() > 1)
        std::snprintf(text + rest, sizeof text - rest, "%zu robots; the plots show the first one",
                      simulation.robots());
    else
        std::snprintf(text + rest, sizeof text - rest, "odometry (dotted) off by %.2f m",
                      length(simulation.believed().position - simulation.body().pose().position));
    return text;
}

bool ends_in(const std::string &name, const std::string &end) {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
}

std::unique_ptr<Canvas> canvas_for(const std::string &file, double height) {
    if (ends_in(file, ".svg")) return std::make_unique<SvgCanvas>(width, height);
    if (ends_in(file, ".png")) return std::make_unique<PngCanvas>(width, height);
    throw std::runtime_error("the picture " + file + " must have a name that ends in .svg or .png");
}

// Draws the last frame of the first robot's camera.
void draw_frame(Canvas &canvas, const frob_image &frame, Vec corner) {
    const int bytes = frob_image_pixel_size(frame.format);
    std::vector<unsigned char> rgb;
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x)
            for (int part = 0; part < 3; ++part)
                rgb.push_back(frob_image_row(&frame, y)[bytes * x + (bytes == 3 ? part : 0)]);
    canvas.image(corner, {frame_height * frame.width / frame.height, frame_height}, frame.width,
                 frame.height, rgb);
    char text[64];
    std::snprintf(text, sizeof text, "camera frame at %.4g s", seconds(frame.captured_ns));
    canvas.text(corner + Vec{0.0, -8.0}, text, {12.0, palette::ink, Anchor::start, true});
}

} // namespace

void draw_picture(const Simulation &simulation, const std::string &file) {
    const Extent shown = extent(simulation);
    const Vec metres = shown.high - shown.low;
    const double scale = std::min((width - left - right) / metres.x, most_scene_height / metres.y);
    const Vec scene_size = scale * metres;
    const Vec scene_corner = {left + (width - left - right - scene_size.x) / 2, head};
    const double end_s = std::max(seconds(simulation.time_ns()), 0.1);
    const std::vector<Plot> plots = {distance_plot(simulation, end_s),
                                     front_plot(simulation, end_s), speed_plot(simulation, end_s),
                                     turn_plot(simulation, end_s)};
    const frob_image *frame = simulation.last_frame();
    const double frame_top = head + scene_size.y + frame_room;
    const double plots_top =
        head + scene_size.y + 34.0 + (frame != nullptr ? frame_height + frame_room : 0.0);
    const double height =
        plots_top + static_cast<double>(plots.size()) * (plot_gap + plot_height) + time_labels;

    const std::unique_ptr<Canvas> canvas = canvas_for(file, height);
    canvas->path({{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}}, true,
                 filled(palette::paper));
    const std::string &name = simulation.scene().name;
    canvas->text({left, 28.0}, name.empty() ? simulation.robot().chassis().title : name,
                 {17.0, palette::ink, Anchor::start, true});
    canvas->text({left, 46.0}, subtitle(simulation),
                 {12.0, palette::faint_ink, Anchor::start, false});
    draw_scene(*canvas, simulation, shown, scene_corner, scene_size);
    if (frame != nullptr) draw_frame(*canvas, *frame, {left, frame_top});
    for (std::size_t i = 0; i < plots.size(); ++i)
        draw_plot(*canvas, plots[i],
                  {left, plots_top + static_cast<double>(i) * (plot_gap + plot_height) + plot_gap},
                  {width - left - right, plot_height});
    canvas->save(file);
}

} // namespace frob::sim

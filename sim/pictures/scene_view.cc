#include "scene_view.h"

#include <algorithm>
#include <cmath>

#include "palette.h"
#include "plot.h"

namespace frob::sim {
namespace {

constexpr double margin = 0.25;                    // m, margin around everything
constexpr std::int64_t ray_lasts_ns = 400'000'000; // one round of all transducers takes 320 ms
constexpr std::size_t path_pieces = 64;            // number of pieces of the path, each in a
                                                   // different colour

void include(Extent &extent, Vec p, double around) {
    extent.low = {std::min(extent.low.x, p.x - around), std::min(extent.low.y, p.y - around)};
    extent.high = {std::max(extent.high.x, p.x + around), std::max(extent.high.y, p.y + around)};
}

Colour blend(Colour a, Colour b, double share) {
    const auto mix = [&](int from, int to) {
        return static_cast<int>(std::lround(from + share * (to - from)));
    };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

// Draws in world coordinates, in metres.
class View {
  public:
    View(Canvas &canvas, const Extent &extent, Vec corner, Vec size)
        : canvas_(canvas), extent_(extent), corner_(corner),
          scale_(size.x / (extent.high.x - extent.low.x)) {}

    Vec place(Vec p) const {
        return {corner_.x + scale_ * (p.x - extent_.low.x),
                corner_.y + scale_ * (extent_.high.y - p.y)};
    }

    void path(const std::vector<Vec> &points, bool closed, const Paint &paint) {
        std::vector<Vec> placed;
        for (const Vec &p : points) {
            const Vec q = place(p);
            // Movements of less than half a pixel are invisible.
            if (placed.empty() || length(q - placed.back()) >= 0.5) placed.push_back(q);
        }
        canvas_.path(placed, closed, paint);
    }

    void circle(Vec center, double radius_m, const Paint &paint) {
        canvas_.circle(place(center), scale_ * radius_m, paint);
    }

    Canvas &canvas() { return canvas_; }
    double scale() const { return scale_; }

  private:
    Canvas &canvas_;
    Extent extent_;
    Vec corner_;
    double scale_;
};

void draw_grid(Canvas &canvas, const View &view, const Extent &extent, Vec corner, Vec size) {
    const double step = std::max(tick_step(60.0 / view.scale(), 1), 0.1);
    const auto each = [&](double low, double high, const auto &draw) {
        for (double n = std::ceil(low / step); n * step <= high; ++n) draw(n * step);
    };
    each(extent.low.x, extent.high.x, [&](double x) {
        const double px = view.place({x, 0.0}).x;
        canvas.path({{px, corner.y}, {px, corner.y + size.y}}, false, stroked(palette::grid, 1.0));
        canvas.text({px, corner.y + size.y + 16.0}, tick_label(x, step),
                    {11.0, palette::faint_ink, Anchor::middle, false});
    });
    each(extent.low.y, extent.high.y, [&](double y) {
        const double py = view.place({0.0, y}).y;
        canvas.path({{corner.x, py}, {corner.x + size.x, py}}, false, stroked(palette::grid, 1.0));
        canvas.text({corner.x - 8.0, py + 4.0}, tick_label(y, step),
                    {11.0, palette::faint_ink, Anchor::end, false});
    });
    canvas.text({corner.x + size.x, corner.y + size.y + 32.0}, "x, y [m]",
                {11.0, palette::faint_ink, Anchor::end, false});
}

// The colour of a floor with this reflectance. A floor that reflects all light is drawn in
// `palette::floor`.
Colour shade(double reflectance) {
    return blend(palette::black_floor, palette::floor, reflectance);
}

void draw_floor(View &view, const Scene &scene) {
    for (const Patch &patch : scene.patches)
        view.path(patch.points, true, filled(shade(patch.reflectance)));
    for (const Tape &tape : scene.tapes)
        view.path(tape.points, tape.closed,
                  stroked(shade(tape.reflectance), view.scale() * tape.width));
}

void draw_solids(View &view, const Scene &scene) {
    for (const Hole &hole : scene.holes)
        view.path(hole.points, true, {palette::hole, palette::hole_edge, 1.2, {3.0, 3.0}});
    for (const Wall &wall : scene.walls)
        view.path(wall.points, wall.closed, stroked(palette::solid, view.scale() * wall.thickness));
    for (const Polygon &polygon : scene.polygons)
        view.path(polygon.points, true, filled(palette::solid));
    for (const Circle &circle : scene.circles)
        view.circle(circle.center, circle.radius, filled(palette::solid));
}

Colour colour_of(Tint tint) {
    const auto level = [](double part) { return static_cast<int>(std::lround(255.0 * part)); };
    return {level(tint.red), level(tint.green), level(tint.blue)};
}

// Draws the balls at their current places, with dashed lines along their paths.
void draw_balls(View &view, const Simulation &simulation) {
    const std::vector<Vec> now = simulation.world().ball_places();
    for (std::size_t i = 0; i < now.size(); ++i) {
        const Ball &ball = simulation.scene().balls[i];
        view.path(ball.way, ball.closed,
                  stroked(palette::faded(palette::box_edge, 0.6), 1.0, {3.0, 4.0}));
        view.circle(now[i], ball.radius, {colour_of(ball.tint), palette::box_edge, 1.2, {}});
    }
}

void draw_cones(View &view, const Scene &scene) {
    for (const Cone &cone : scene.cones) {
        view.circle(cone.center, cone.radius,
                    {colour_of(cone.look.tint), palette::box_edge, 1.2, {}});
        view.circle(cone.center, 0.3 * cone.radius, filled(palette::paper));
    }
}

// Draws a poster as a line, with a tick on the side that it faces.
void draw_posters(View &view, const Scene &scene) {
    for (const Poster &poster : scene.posters) {
        const Vec facing = direction(poster.pose.heading), side = {-facing.y, facing.x};
        const Vec at = poster.pose.position, end = (poster.size.x / 2) * side;
        view.path({at - end, at + end}, false, stroked(palette::believed, 3.0));
        view.path({at, at + 0.08 * facing}, false, stroked(palette::believed, 1.6));
    }
}

// Draws each lamp as a disc with rays, as on maps. This symbol is not to scale.
void draw_lamps(View &view, const Scene &scene) {
    for (const Lamp &lamp : scene.lamps) {
        const Vec at = view.place(lamp.position);
        for (int k = 0; k < 8; ++k) {
            const Vec u = direction(radians(45.0 * k));
            view.canvas().path({at + 8.0 * u, at + 12.0 * u}, false,
                               stroked(palette::lamp_edge, 1.4));
        }
        view.canvas().circle(at, 5.5, {palette::lamp, palette::lamp_edge, 1.4, {}});
    }
}

std::vector<Vec> corners(const Pose &pose, Vec size) {
    const Vec h = 0.5 * size;
    std::vector<Vec> result;
    for (const Vec &c : {Vec{-h.x, -h.y}, Vec{h.x, -h.y}, Vec{h.x, h.y}, Vec{-h.x, h.y}})
        result.push_back(from_frame(pose, c));
    return result;
}

// Draws the boxes at their current places, with dashed outlines at their initial places.
void draw_boxes(View &view, const Simulation &simulation) {
    const std::vector<Box> &boxes = simulation.scene().boxes;
    const std::vector<Pose> now = simulation.world().box_poses();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (length(now[i].position - boxes[i].pose.position) > 0.01)
            view.path(corners(boxes[i].pose, boxes[i].size), true,
                      stroked(palette::faded(palette::box_edge, 0.6), 1.0, {3.0, 4.0}));
        view.path(corners(now[i], boxes[i].size), true, {palette::box, palette::box_edge, 1.2, {}});
    }
}

// Draws the true path, in a colour that changes from light at the start to dark at the end, and
// the path according to odometry.
void draw_path(View &view, const std::vector<Sample> &samples) {
    std::vector<Vec> believed;
    double error = 0.0;
    for (const Sample &s : samples) {
        believed.push_back(s.believed.position);
        error = std::max(error, length(s.believed.position - s.pose.position));
    }
    if (error > 0.03)
        view.path(believed, false,
                  stroked(palette::faded(palette::believed, 0.55), 1.3, {1.0, 5.0}));
    for (std::size_t piece = 0; piece < path_pieces; ++piece) {
        const std::size_t first = piece * samples.size() / path_pieces;
        const std::size_t last =
            std::min((piece + 1) * samples.size() / path_pieces + 1, samples.size());
        std::vector<Vec> points;
        for (std::size_t i = first; i < last; ++i) points.push_back(samples[i].pose.position);
        view.path(points, false,
                  stroked(blend(palette::early, palette::late,
                                static_cast<double>(piece) / (path_pieces - 1)),
                          2.6));
    }
}

// Marks the path with a dot every few seconds, and writes the time next to each dot.
void draw_times(View &view, const std::vector<Sample> &samples) {
    const double step = tick_step(static_cast<double>(samples.back().time_ns) * 1e-9, 6);
    double next = step;
    for (const Sample &s : samples) {
        const double t = static_cast<double>(s.time_ns) * 1e-9;
        if (t < next - 1e-9) continue;
        const std::string label = tick_label(next, step) + " s";
        next += step;
        // The robot would cover this dot.
        if (length(s.pose.position - samples.back().pose.position) < 0.5) continue;
        const Vec at = view.place(s.pose.position);
        // Puts the label on the right of the path, away from a wall that the robot follows on
        // its left.
        const Vec right = {std::sin(s.pose.heading), std::cos(s.pose.heading)};
        view.canvas().circle(at, 3.2, {palette::paper, palette::late, 1.6, {}});
        view.canvas().text(at + Vec{16.0 * right.x, 14.0 * right.y + 4.0}, label,
                           {10.5, palette::late, Anchor::middle, false});
    }
}

std::vector<Vec> outline_at(const Chassis &chassis, const Pose &pose) {
    std::vector<Vec> outline = outline_of(chassis);
    for (Vec &corner : outline) corner = from_frame(pose, corner);
    return outline;
}

void draw_start(View &view, const Chassis &chassis, const Pose &start) {
    view.path(outline_at(chassis, start), true,
              stroked(palette::faded(palette::robot_edge, 0.5), 1.2, {2.0, 4.0}));
}

// Draws the last echo of each transducer: its cone, and an arc at the measured distance.
void draw_rays(View &view, const Simulation &simulation, std::size_t robot) {
    const RangeFinders &finders = simulation.robot(robot).chassis().range_finders;
    std::vector<const Echo *> last(finders.seats.size());
    for (const Echo &echo : simulation.robot(robot).echoes())
        if (echo.time_ns > simulation.time_ns() - ray_lasts_ns) last[echo.transducer] = &echo;
    for (const Echo *echo : last) {
        if (echo == nullptr) continue;
        std::vector<Vec> arc;
        for (int i = -6; i <= 6; ++i)
            arc.push_back(echo->from.position +
                          echo->distance *
                              direction(echo->from.heading + finders.half_angle * i / 6.0));
        std::vector<Vec> cone = arc;
        cone.push_back(echo->from.position);
        view.path(cone, true, filled(palette::faded(palette::sonar, 0.13)));
        view.path(arc, false, stroked(palette::sonar, 1.8));
    }
}

void draw_robot(View &view, const Chassis &chassis, const Pose &pose) {
    view.path(outline_at(chassis, pose), true, {palette::robot, palette::robot_edge, 1.4, {}});
    for (const double side : {-1.0, 1.0}) {
        const double apart = 0.462 * chassis.wheel_separation;
        const Pose wheel = {from_frame(pose, Vec{0.0, side * apart}), pose.heading};
        view.path(corners(wheel, {2 * chassis.wheel_radius, 0.14 * chassis.wheel_separation}), true,
                  filled(palette::robot_edge));
    }
    const double ahead = chassis.range_finders.seats[chassis.range_finders.front[0]].position.x;
    view.path({from_frame(pose, Vec{ahead, 0.0}), from_frame(pose, Vec{0.36 * ahead, 0.42 * ahead}),
               from_frame(pose, Vec{0.36 * ahead, -0.42 * ahead})},
              true, filled(palette::paper));
}

} // namespace

Extent extent(const Simulation &simulation) {
    const Scene &scene = simulation.scene();
    Extent result{scene.starts.front().pose.position, scene.starts.front().pose.position};
    for (const Wall &wall : scene.walls)
        for (const Vec &p : wall.points) include(result, p, margin + wall.thickness / 2);
    for (const Polygon &polygon : scene.polygons)
        for (const Vec &p : polygon.points) include(result, p, margin);
    for (const Patch &patch : scene.patches)
        for (const Vec &p : patch.points) include(result, p, margin);
    for (const Tape &tape : scene.tapes)
        for (const Vec &p : tape.points) include(result, p, margin + tape.width / 2);
    for (const Hole &hole : scene.holes)
        for (const Vec &p : hole.points) include(result, p, margin);
    for (const Lamp &lamp : scene.lamps) include(result, lamp.position, margin);
    for (const Ball &ball : scene.balls)
        for (const Vec &p : ball.way) include(result, p, margin + ball.radius);
    for (const Cone &cone : scene.cones) include(result, cone.center, margin + cone.radius);
    for (const Circle &circle : scene.circles)
        include(result, circle.center, margin + circle.radius);
    for (std::size_t i = 0; i < scene.boxes.size(); ++i)
        for (const Pose &pose : {scene.boxes[i].pose, simulation.world().box_poses()[i]})
            include(result, pose.position, margin + length(scene.boxes[i].size) / 2);
    for (std::size_t k = 0; k < simulation.robots(); ++k)
        for (const Sample &sample : simulation.recorder(k).samples())
            include(result, sample.pose.position, 0.5);
    return result;
}

void draw_scene(Canvas &canvas, const Simulation &simulation, const Extent &extent, Vec corner,
                Vec size) {
    const Chassis &chassis = simulation.robot().chassis();
    const std::size_t robots = simulation.robots();
    View view(canvas, extent, corner, size);
    const std::vector<Vec> outline = {
        corner, {corner.x + size.x, corner.y}, corner + size, {corner.x, corner.y + size.y}};
    canvas.path(outline, true, filled(shade(simulation.scene().floor.reflectance)));
    draw_grid(canvas, view, extent, corner, size);
    canvas.clip(corner, size);
    draw_floor(view, simulation.scene());
    for (std::size_t k = 0; k < robots; ++k) draw_rays(view, simulation, k);
    draw_solids(view, simulation.scene());
    draw_cones(view, simulation.scene());
    draw_posters(view, simulation.scene());
    draw_boxes(view, simulation);
    draw_balls(view, simulation);
    for (const Start &start : simulation.scene().starts) draw_start(view, chassis, start.pose);
    for (std::size_t k = 0; k < robots; ++k) {
        const std::vector<Sample> &samples = simulation.recorder(k).samples();
        if (samples.empty()) continue;
        draw_path(view, samples);
        if (robots == 1) draw_times(view, samples);
    }
    for (std::size_t k = 0; k < robots; ++k) draw_robot(view, chassis, simulation.body(k).pose());
    draw_lamps(view, simulation.scene());
    canvas.unclip();
    canvas.path(outline, true, stroked(palette::frame, 1.0));
}

} // namespace frob::sim

#include "raster.h"

#include <algorithm>
#include <cmath>

#include "wide.h"

namespace frob::sim {
namespace {

constexpr double nearest = 0.01;    // m: near clipping plane
constexpr float farthest = 1000.0f; // m: maximum depth at which textures are accurate
constexpr double brightest = 1e3;   // maximum light, where 1 is white
constexpr float below = 0.9999f;    // reduces 1 / depth by more than its rounding error

// A value that changes linearly along a row.
struct Even {
    float start, step;
};

FROB_WIDE void cover_run(float *__restrict inverses, std::int32_t *__restrict numbers, int count,
                         Even inverse, float share, std::int32_t number) {
    constexpr float most = static_cast<float>(1.0 / nearest);
    for (int i = 0; i < count; ++i) {
        const float at = inverse.start + static_cast<float>(i) * inverse.step;
        const bool is_seen = (at * share > inverses[i]) & (at <= most);
        inverses[i] = is_seen ? at : inverses[i];
        numbers[i] = is_seen ? number : numbers[i];
    }
}

// Finds the texture coordinates of a run of pixels.
FROB_WIDE void find_places(const float *inverses, int count, float focal, Even along, float u_start,
                           Even across, float v_start, float *__restrict u, float *__restrict v,
                           float *__restrict per_metre) {
    for (int i = 0; i < count; ++i) {
        const float x = static_cast<float>(i);
        const float way = 1.0f / inverses[i], depth = way < farthest ? way : farthest;
        u[i] = u_start + depth * (along.start + x * along.step);
        v[i] = v_start + depth * (across.start + x * across.step);
        per_metre[i] = inverses[i] * focal;
    }
}

FROB_WIDE void tint_run(const float *brightness, float red, float green, float blue,
                        float *__restrict to, int count) {
    for (int i = 0; i < count; ++i) {
        to[3 * i] = brightness[i] * red;
        to[3 * i + 1] = brightness[i] * green;
        to[3 * i + 2] = brightness[i] * blue;
    }
}

FROB_WIDE void fill_run(float red, float green, float blue, float *__restrict to, int count) {
    for (int i = 0; i < count; ++i) {
        to[3 * i] = red;
        to[3 * i + 1] = green;
        to[3 * i + 2] = blue;
    }
}

// Computes the tangents of the angles to the two sides of a disc at (across, ahead) from the
// camera. A side that is not in front of the camera gets ±1e9. Returns false if the whole disc is
// behind it.
bool tangents(double across, double ahead, double radius, double &low, double &high) {
    const double squared = across * across + ahead * ahead - radius * radius;
    low = -1e9, high = 1e9;
    if (squared <= 0.0) return ahead > -radius;
    if (ahead <= -radius) return false;
    const double way = std::sqrt(squared);
    // tan(a ± b) with tan a = across / ahead and tan b = radius / way
    const double left = ahead * way + across * radius, right = ahead * way - across * radius;
    if (left > 0.0) low = (across * way - ahead * radius) / left;
    if (right > 0.0) high = (across * way + ahead * radius) / right;
    return true;
}

int clamped(double pixel, int count) {
    return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(count)));
}

} // namespace

double light_on(Point normal) {
    static const Point sun = unit({0.45, 0.30, 0.84});
    constexpr double shadow = 0.62; // the light on surfaces that face away from the sun
    return shadow + (1.0 - shadow) * std::max(0.0, dot(normal, sun));
}

Raster::Raster(int longest_row)
    : numbers_(static_cast<std::size_t>(longest_row)), inverses_(numbers_.size()),
      u_(numbers_.size()), v_(numbers_.size()), per_metre_(numbers_.size()),
      brightness_(numbers_.size()), patterns_(longest_row) {}

void Raster::start(const Pinhole &eye) {
    eye_ = eye;
    corner_ = eye.ray(0.0, 0.0);
    right_ = (1.0 / eye.focal) * eye.right;
    down_ = (1.0 / eye.focal) * eye.down;
    surfaces_.clear();
    balls_.clear();
    edges_.clear();
    order_.clear();
    active_.clear();
    begun_ = 0;
    is_sorted_ = false;
}

// Clips the polygon at the near plane, edge by edge (Sutherland-Hodgman).
void Raster::find_outline(const std::vector<Point> &corners) {
    outline_.clear();
    const auto seen = [&](Point corner) {
        const Point p = corner - eye_.origin;
        return Point{dot(p, eye_.right), dot(p, eye_.down), dot(p, eye_.ahead)};
    };
    const auto add = [&](Point p) {
        outline_.push_back({eye_.cx + eye_.focal * p.x / p.z, eye_.cy + eye_.focal * p.y / p.z});
    };
    Point a = seen(corners.back());
    for (const Point &corner : corners) {
        const Point b = seen(corner);
        if ((a.z >= nearest) != (b.z >= nearest)) add(a + (nearest - a.z) / (b.z - a.z) * (b - a));
        if (b.z >= nearest) add(b);
        a = b;
    }
}

void Raster::add(const std::vector<Point> &corners, const Chart &chart, const Finish &finish,
                 bool lies_below, Surface surface) {
    // The point at `depth` satisfies dot(normal, origin + depth ray - corner) = 0.
    const Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double distance = dot(normal, corners[0] - eye_.origin);
    if (distance == 0.0) return;
    surface.lies_below = lies_below;
    surface.inverse = planar((1.0 / distance) * normal);
    surface.u = planar(chart.along);
    surface.v = planar(chart.across);
    surface.u_start = dot(eye_.origin - chart.origin, chart.along);
    surface.v_start = dot(eye_.origin - chart.origin, chart.across);
    surface.finish = finish;
    surface.normal = (distance < 0.0 ? 1.0 : -1.0) * unit(normal);
    surface.thing = thing_;
    order_.push_back(surfaces_.size());
    surfaces_.push_back(surface);
}

void Raster::polygon(const std::vector<Point> &corners, const Chart &chart, const Finish &finish,
                     bool lies_below) {
    find_outline(corners);
    if (outline_.size() < 3) return;
    double top = outline_[0].y, bottom = top, left = outline_[0].x, right = left;
    for (const Vec &p : outline_) {
        top = std::min(top, p.y), bottom = std::max(bottom, p.y);
        left = std::min(left, p.x), right = std::max(right, p.x);
    }
    if (left > eye_.width - 1.0 || right < 0.0) return;
    Surface surface{};
    surface.first = static_cast<int>(std::ceil(std::clamp(top, 0.0, eye_.height * 1.0)));
    surface.last = static_cast<int>(std::clamp(std::floor(bottom), -1.0, eye_.height - 1.0));
    if (surface.first > surface.last) return;
    // The corners are counter-clockwise, so the left side runs down from the highest corner. Level
    // edges are skipped: the edges next to them end at the same rows.
    const std::size_t n = outline_.size();
    const auto highest = static_cast<std::size_t>(
        std::min_element(outline_.begin(), outline_.end(),
                         [](const Vec &a, const Vec &b) { return a.y < b.y; }) -
        outline_.begin());
    const auto add_edge = [&](const Vec &high, const Vec &low) {
        if (high.y < low.y)
            edges_.push_back({high.y, low.y, high.x, (low.x - high.x) / (low.y - high.y)});
    };
    surface.left = edges_.size();
    for (std::size_t i = highest; i < highest + n; ++i)
        add_edge(outline_[i % n], outline_[(i + 1) % n]);
    surface.left_end = surface.right = edges_.size();
    for (std::size_t i = highest + n; i > highest; --i)
        add_edge(outline_[i % n], outline_[(i - 1) % n]);
    surface.right_end = edges_.size();
    if (surface.left != surface.left_end && surface.right != surface.right_end)
        add(corners, chart, finish, lies_below, surface);
}

void Raster::floor(const Finish &finish) {
    if (eye_.origin.z <= 0.0) return;
    Surface surface{};
    surface.last = eye_.height - 1;
    add({{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}},
        {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, finish, true, surface);
}

bool Raster::find_bounds(Ball &ball) const {
    const Point p = ball.middle - eye_.origin;
    const double ahead = dot(p, eye_.ahead);
    double left, right, top, bottom;
    if (!tangents(dot(p, eye_.right), ahead, ball.radius, left, right) ||
        !tangents(dot(p, eye_.down), ahead, ball.radius, top, bottom))
        return false;
    ball.left = std::max(0, clamped(std::floor(eye_.cx + eye_.focal * left), eye_.width));
    ball.right =
        std::min(eye_.width - 1, clamped(std::ceil(eye_.cx + eye_.focal * right), eye_.width));
    ball.first = std::max(0, clamped(std::floor(eye_.cy + eye_.focal * top), eye_.height));
    ball.last =
        std::min(eye_.height - 1, clamped(std::ceil(eye_.cy + eye_.focal * bottom), eye_.height));
    return ball.left <= ball.right;
}

void Raster::ball(Point middle, double radius, Tint tint) {
    Ball ball{0, 0, 0, 0, middle, radius, tint, thing_};
    if (find_bounds(ball)) balls_.push_back(ball);
}

// Returns the column at which the outline crosses row y. Advances `edge` to the edge at that row.
double Raster::crossing(std::size_t &edge, std::size_t end, int y) const {
    while (edges_[edge].bottom < y && edge + 1 < end) ++edge;
    return edges_[edge].start + (y - edges_[edge].top) * edges_[edge].slope;
}

void Raster::cover(Surface &surface, std::int32_t number, int y) {
    double left = 0.0, right = eye_.width - 1.0;
    if (surface.left != surface.left_end) {
        left = std::max(left, crossing(surface.left, surface.left_end, y));
        right = std::min(right, crossing(surface.right, surface.right_end, y));
        if (left > right) return;
    } else if (surface.inverse.at(left, y) <= 0.0 && surface.inverse.at(right, y) <= 0.0) {
        return; // above the horizon
    }
    const int from = static_cast<int>(left) + (left > static_cast<int>(left) ? 1 : 0);
    const int count = static_cast<int>(right) + 1 - from;
    if (count <= 0) return;
    const Even inverse = {static_cast<float>(surface.inverse.at(from, y)),
                          static_cast<float>(surface.inverse.right)};
    cover_run(inverses_.data() + from, numbers_.data() + from, count, inverse,
              surface.lies_below ? below : 1.0f, number);
}

// Solves |origin + t ray - middle| = radius.
void Raster::cover(const Ball &ball, std::int32_t number, int y) {
    const Point way = eye_.origin - ball.middle;
    const double c = dot(way, way) - ball.radius * ball.radius;
    const Point first = corner_ + static_cast<double>(y) * down_;
    for (int x = ball.left; x <= ball.right; ++x) {
        const Point ray = first + static_cast<double>(x) * right_;
        const double a = dot(ray, ray), b = dot(ray, way), squared = b * b - a * c;
        if (squared < 0.0) continue;
        const double t = (-b - std::sqrt(squared)) / a;
        const float inverse = static_cast<float>(1.0 / t);
        const auto at = static_cast<std::size_t>(x);
        if (!(t >= nearest && inverse > inverses_[at])) continue;
        inverses_[at] = inverse;
        numbers_[at] = number;
    }
}

void Raster::paint(const Surface &surface, int y, int from, int count, float *to) {
    const Finish &finish = surface.finish;
    const auto red = static_cast<float>(finish.tint.red);
    const auto green = static_cast<float>(finish.tint.green);
    const auto blue = static_cast<float>(finish.tint.blue);
    if (finish.texture == Texture::plain && finish.print == nullptr)
        return fill_run(red, green, blue, to, count);
    const auto even = [&](const Planar &p) {
        return Even{static_cast<float>(p.at(from, y)), static_cast<float>(p.right)};
    };
    find_places(inverses_.data() + from, count, static_cast<float>(eye_.focal * finish.width),
                even(surface.u), static_cast<float>(surface.u_start), even(surface.v),
                static_cast<float>(surface.v_start), u_.data(), v_.data(), per_metre_.data());
    if (finish.print != nullptr)
        return finish.print->colours(count, u_.data(), v_.data(), per_metre_.data(),
                                     static_cast<float>(finish.light), to);
    patterns_.brightness(finish.texture, {count, u_.data(), v_.data(), per_metre_.data()},
                         brightness_.data());
    tint_run(brightness_.data(), red, green, blue, to, count);
}

void Raster::paint(const Ball &ball, int y, int from, int count, float *to) {
    const Point first = corner_ + static_cast<double>(y) * down_;
    for (int i = 0; i < count; ++i) {
        const double depth =
            1.0 / static_cast<double>(inverses_[static_cast<std::size_t>(from + i)]);
        const Point place = eye_.origin + depth * (first + static_cast<double>(from + i) * right_);
        brightness_[static_cast<std::size_t>(i)] =
            static_cast<float>(light_on((1.0 / ball.radius) * (place - ball.middle)));
    }
    tint_run(brightness_.data(), static_cast<float>(ball.tint.red),
             static_cast<float>(ball.tint.green), static_cast<float>(ball.tint.blue), to, count);
}

// A lamp's light is its intensity times the cosine of the angle between the normal and the
// direction to the lamp, divided by the squared distance.
float Raster::relight(Point place, Point normal) const {
    double lamps = 0.0;
    for (const Shine &lamp : *lamps_) {
        const Point way = lamp.place - place;
        const double squared = dot(way, way), facing = dot(way, normal);
        if (facing > 0.0) lamps += lamp.light * facing / (squared * std::sqrt(squared));
    }
    return static_cast<float>(std::min(brightest, even_ + lamps / light_on(normal)));
}

void Raster::relight(std::int32_t number, int y, int from, int count, float *to) const {
    const Point first = corner_ + static_cast<double>(y) * down_;
    for (int x = from; x < from + count; ++x) {
        const Point place = eye_.origin + depth(x) * (first + static_cast<double>(x) * right_);
        float share;
        if (number > 0) {
            share = relight(place, surfaces_[static_cast<std::size_t>(number - 1)].normal);
        } else {
            const Ball &ball = balls_[static_cast<std::size_t>(-1 - number)];
            share = relight(place, (1.0 / ball.radius) * (place - ball.middle));
        }
        for (int k = 0; k < 3; ++k) *to++ *= share;
    }
}

Thing Raster::thing(int x) const {
    const std::int32_t number = numbers_[static_cast<std::size_t>(x)];
    if (number > 0) return surfaces_[static_cast<std::size_t>(number - 1)].thing;
    if (number < 0) return balls_[static_cast<std::size_t>(-1 - number)].thing;
    return {};
}

void Raster::row(int y, float *to) {
    if (!is_sorted_)
        std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
            return surfaces_[a].first < surfaces_[b].first;
        });
    is_sorted_ = true;
    const auto width = static_cast<std::size_t>(eye_.width);
    std::fill_n(inverses_.begin(), width, 0.0f);
    std::fill_n(numbers_.begin(), width, 0);
    for (std::size_t k = 0; k < balls_.size(); ++k)
        if (balls_[k].first <= y && y <= balls_[k].last)
            cover(balls_[k], -1 - static_cast<std::int32_t>(k), y);
    active_.erase(std::remove_if(active_.begin(), active_.end(),
                                 [&](std::size_t k) { return surfaces_[k].last < y; }),
                  active_.end());
    const auto before = static_cast<std::ptrdiff_t>(active_.size());
    for (; begun_ < order_.size() && surfaces_[order_[begun_]].first <= y; ++begun_)
        if (surfaces_[order_[begun_]].last >= y) active_.push_back(order_[begun_]);
    std::inplace_merge(active_.begin(), active_.begin() + before, active_.end());
    for (const std::size_t k : active_) cover(surfaces_[k], 1 + static_cast<std::int32_t>(k), y);
    for (std::size_t from = 0, end; from < width; from = end) {
        const std::int32_t number = numbers_[from];
        for (end = from + 1; end + 4 <= width;) { // compares four at a time, because runs are long
            const std::int32_t *n = &numbers_[end];
            if (((n[0] ^ number) | (n[1] ^ number) | (n[2] ^ number) | (n[3] ^ number)) != 0) break;
            end += 4;
        }
        while (end < width && numbers_[end] == number) ++end;
        const int x = static_cast<int>(from), count = static_cast<int>(end - from);
        if (number > 0)
            paint(surfaces_[static_cast<std::size_t>(number - 1)], y, x, count, to + 3 * from);
        else if (number < 0)
            paint(balls_[static_cast<std::size_t>(-1 - number)], y, x, count, to + 3 * from);
        else
            fill_run(static_cast<float>(sky_.red), static_cast<float>(sky_.green),
                     static_cast<float>(sky_.blue), to + 3 * from, count);
        if (lamps_ != nullptr && number != 0) relight(number, y, x, count, to + 3 * from);
    }
}

} // namespace frob::sim

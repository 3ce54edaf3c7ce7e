// A picture under way: for each pixel a colour and how far away it is. What is drawn hides what
// is behind it, in whatever order it comes.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "look.h"
#include "space.h"

namespace frob::sim {

// A pinhole camera in the world. A pixel's ray is ahead + (x - cx)/f right + (y - cy)/f down,
// so a place that is t rays away has the depth t along the axis.
struct Pinhole {
    Point origin;
    Point right, down, ahead; // unit vectors
    double focal = 1.0;       // pixels
    double cx = 0.0, cy = 0.0;
    int width = 0, height = 0;

    Point ray(double x, double y) const {
        return ahead + ((x - cx) / focal) * right + ((y - cy) / focal) * down;
    }
};

class Raster {
  public:
    // Nothing is seen yet.
    void start(const Pinhole &eye);

    const Pinhole &eye() const { return eye_; }

    // As Pinhole's, of a pixel.
    Point ray(int x, int y) const {
        return columns_[static_cast<std::size_t>(x)] + rows_[static_cast<std::size_t>(y)];
    }

    // A flat convex polygon. `tint(place, depth)` is its colour at a place of it. With
    // `lies_below` it does not hide what was drawn before it in the same plane.
    template <typename Shade>
    void polygon(const std::vector<Point> &corners, const Shade &tint, bool lies_below = false) {
        const std::vector<Vec> outline = outline_of(corners);
        if (outline.size() < 3) return;
        const Point normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double distance = dot(normal, corners[0] - eye_.origin);
        const double constant = dot(normal, eye_.ray(0.0, 0.0));
        const double along = dot(normal, eye_.right) / eye_.focal;
        const double across = dot(normal, eye_.down) / eye_.focal;
        rows(outline, [&](int y, int from, int to) {
            for (int x = from; x <= to; ++x) {
                const double facing = constant + x * along + y * across;
                if (facing == 0.0) continue;
                put(x, y, distance / facing, lies_below ? below : 1.0f, tint);
            }
        });
    }

    // A ball. `tint(place, normal)` is its colour.
    template <typename Shade> void sphere(Point middle, double radius, const Shade &tint) {
        int from_x, to_x, from_y, to_y;
        if (!bounds(middle, radius, from_x, to_x, from_y, to_y)) return;
        const Point way = eye_.origin - middle;
        const double c = dot(way, way) - radius * radius;
        for (int y = from_y; y <= to_y; ++y) {
            for (int x = from_x; x <= to_x; ++x) {
                const Point ray = this->ray(x, y);
                const double a = dot(ray, ray), b = dot(ray, way), squared = b * b - a * c;
                if (squared < 0.0) continue;
                put(x, y, (-b - std::sqrt(squared)) / a, 1.0f, [&](Point place, double) {
                    return tint(place, (1.0 / radius) * (place - middle));
                });
            }
        }
    }

    // Everything that nothing hides: `tint(x, y)`.
    template <typename Shade> void background(const Shade &tint) {
        for (int y = 0; y < eye_.height; ++y) {
            for (int x = 0; x < eye_.width; ++x) {
                const std::size_t at = index(x, y);
                if (depths_[at] == nothing) tints_[at] = single(tint(x, y));
            }
        }
    }

    struct Single {
        float red, green, blue;
    };

    Single tint(int x, int y) const { return tints_[index(x, y)]; }

    // All, row by row, in exchange for memory of any contents: the picture is over.
    void give_tints(std::vector<Single> &to) { tints_.swap(to); }

    // Along the axis; infinite where nothing is.
    float depth(int x, int y) const { return depths_[index(x, y)]; }

  private:
    static constexpr double nearest = 0.01; // m: what is nearer is not seen
    static constexpr float nothing = 1e30f;
    static constexpr float below = 0.9999f; // of a depth: more than its rounding

    static Single single(Tint t) {
        return {static_cast<float>(t.red), static_cast<float>(t.green), static_cast<float>(t.blue)};
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(eye_.width) +
               static_cast<std::size_t>(x);
    }

    template <typename Shade>
    void put(int x, int y, double depth, float share, const Shade &tint) {
        const std::size_t at = index(x, y);
        const float rounded = static_cast<float>(depth);
        if (!(depth >= nearest && rounded < share * depths_[at])) return;
        depths_[at] = rounded;
        tints_[at] = single(tint(eye_.origin + depth * ray(x, y), depth));
    }

    // In pixels, of what of it is ahead of the camera; empty if nothing is.
    std::vector<Vec> outline_of(const std::vector<Point> &corners) const;

    // Which pixels a ball may be seen in; false if none.
    bool bounds(Point middle, double radius, int &from_x, int &to_x, int &from_y, int &to_y) const;

    // `f(y, from, to)` for the pixels of each row whose middles are inside.
    template <typename F> void rows(const std::vector<Vec> &outline, const F &f) const {
        double top = outline[0].y, bottom = outline[0].y;
        for (const Vec &p : outline) {
            top = std::min(top, p.y);
            bottom = std::max(bottom, p.y);
        }
        const int first = static_cast<int>(std::ceil(std::max(top, 0.0)));
        const int last = static_cast<int>(std::floor(std::min(bottom, eye_.height - 1.0)));
        for (int y = first; y <= last; ++y) {
            double from = 1e30, to = -1e30;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const Vec a = outline[i], b = outline[(i + 1) % outline.size()];
                if ((a.y < y && b.y < y) || (a.y > y && b.y > y)) continue;
                const double x = a.y == b.y ? a.x : a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
                from = std::min({from, x, a.y == b.y ? b.x : x});
                to = std::max({to, x, a.y == b.y ? b.x : x});
            }
            from = std::max(from, 0.0);
            to = std::min(to, eye_.width - 1.0);
            if (from <= to)
                f(y, static_cast<int>(std::ceil(from)), static_cast<int>(std::floor(to)));
        }
    }

    Pinhole eye_;
    std::vector<Point> columns_, rows_; // of rays, the parts that pixels of one share
    std::vector<Single> tints_;
    std::vector<float> depths_;
};

} // namespace frob::sim

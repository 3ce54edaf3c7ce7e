#include "raster.h"

#include <algorithm>

namespace frob::sim {

void Raster::start(const Pinhole &eye) {
    eye_ = eye;
    const std::size_t pixels =
        static_cast<std::size_t>(eye.width) * static_cast<std::size_t>(eye.height);
    columns_.clear();
    rows_.clear();
    for (int x = 0; x < eye.width; ++x)
        columns_.push_back(eye.ahead + ((x - eye.cx) / eye.focal) * eye.right);
    for (int y = 0; y < eye.height; ++y) rows_.push_back(((y - eye.cy) / eye.focal) * eye.down);
    tints_.resize(pixels);
    depths_.assign(pixels, nothing);
}

// What is nearer than the camera can see is cut off, edge by edge (Sutherland and Hodgman).
std::vector<Vec> Raster::outline_of(const std::vector<Point> &corners) const {
    std::vector<Vec> outline;
    const auto seen = [&](Point corner) {
        const Point p = corner - eye_.origin;
        return Point{dot(p, eye_.right), dot(p, eye_.down), dot(p, eye_.ahead)};
    };
    const auto add = [&](Point p) {
        outline.push_back({eye_.cx + eye_.focal * p.x / p.z, eye_.cy + eye_.focal * p.y / p.z});
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Point a = seen(corners[i]), b = seen(corners[(i + 1) % corners.size()]);
        if (a.z >= nearest) add(a);
        if ((a.z >= nearest) != (b.z >= nearest)) add(a + (nearest - a.z) / (b.z - a.z) * (b - a));
    }
    return outline;
}

namespace {

// Of a disc at (across, ahead) from the camera the tangents of the angles to both of its sides;
// what is not ahead is infinitely far aside.
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

bool Raster::bounds(Point middle, double radius, int &from_x, int &to_x, int &from_y,
                    int &to_y) const {
    const Point p = middle - eye_.origin;
    const double ahead = dot(p, eye_.ahead);
    double left, right, top, bottom;
    if (!tangents(dot(p, eye_.right), ahead, radius, left, right) ||
        !tangents(dot(p, eye_.down), ahead, radius, top, bottom))
        return false;
    from_x = std::max(0, clamped(std::floor(eye_.cx + eye_.focal * left), eye_.width));
    to_x = std::min(eye_.width - 1, clamped(std::ceil(eye_.cx + eye_.focal * right), eye_.width));
    from_y = std::max(0, clamped(std::floor(eye_.cy + eye_.focal * top), eye_.height));
    to_y = std::min(eye_.height - 1, clamped(std::ceil(eye_.cy + eye_.focal * bottom), eye_.height));
    return from_x <= to_x && from_y <= to_y;
}

} // namespace frob::sim

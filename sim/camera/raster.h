// Renders a picture row by row: finds the nearest surface at each pixel and computes its light.
// Nearer surfaces hide farther ones, in whatever order they are drawn.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "look.h"
#include "print.h"
#include "space.h"
#include "texture.h"
#include "truth.h"

namespace frob::sim {

// A pinhole camera in the world. A pixel's ray is ahead + (x - cx)/f right + (y - cy)/f down, so
// the point origin + t ray has depth t along the camera's axis.
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

// Texture coordinates of a flat surface: the point that has coordinates (0, 0), and the directions
// along and across.
struct Chart {
    Point origin, along, across;
};

// Appearance of a flat surface.
struct Finish {
    Tint tint; // the colour, multiplied by the light on the surface
    Texture texture = Texture::plain;
    const Print *print = nullptr; // a picture that replaces tint and texture; its texture
                                  // coordinates are 0 to 1
    double light = 1.0;           // light on the picture
    double width = 1.0;           // width of the picture in metres
};

// Light on a surface with this normal: most of it comes from one side.
double light_on(Point normal);

// A lamp, and its light on a surface that faces it from 1 m away, where 1 is white.
struct Shine {
    Point place;
    double light;
};

class Raster {
  public:
    // `longest_row`: maximum number of pixels in a row.
    explicit Raster(int longest_row);

    // Begins an empty picture.
    void start(const Pinhole &eye);

    const Pinhole &eye() const { return eye_; }

    // Sets the light of the scene: `even` scales the light that light_on computes, and lamps add to
    // it. The lamps must outlive the drawing. By default, `even` is 1 and there are no lamps.
    void light(double even, const std::vector<Shine> &lamps) { even_ = even, lamps_ = &lamps; }

    // Sets the owner of the surfaces that are drawn from now on.
    void of(Thing thing) { thing_ = thing; }

    // Sets the colour of pixels that no surface covers.
    void sky(Tint tint) { sky_ = tint; }

    // Draws a flat convex polygon. If `lies_below` is true, it does not hide earlier surfaces in
    // the same plane.
    void polygon(const std::vector<Point> &corners, const Chart &chart, const Finish &finish,
                 bool lies_below = false);

    // Draws the infinite floor at height 0. It does not hide earlier surfaces that lie on it.
    void floor(const Finish &finish);

    void ball(Point middle, double radius, Tint tint);

    // Computes the light of a row: red, green and blue of each pixel. Call it after everything has
    // been drawn, for consecutive rows, starting at any row.
    void row(int y, float *to);

    // The thing shown at this column of the last computed row.
    Thing thing(int x) const;

    // The depth at this column along the camera's axis, in metres; infinity for the sky.
    double depth(int x) const {
        return 1.0 / static_cast<double>(inverses_[static_cast<std::size_t>(x)]);
    }

  private:
    // An affine function of a pixel's column and row.
    struct Planar {
        double corner, right, down;
        double at(double x, double y) const { return corner + x * right + y * down; }
    };

    // An edge of an outline, in pixels: between `top` and `bottom`, it crosses row y at column
    // start + slope (y - top).
    struct Edge {
        double top, bottom, start, slope;
    };

    struct Surface {
        int first, last; // rows
        // Indices of edges: the current left edge of the outline and the end of the left edges,
        // then the same for the right edges. The current edges change from row to row. A surface
        // without edges covers whole rows.
        std::size_t left, left_end, right, right_end;
        bool lies_below;
        Planar inverse, u, v;    // 1 / depth, and the texture coordinates divided by the depth
        double u_start, v_start; // the origin of u and v
        Finish finish;
        Point normal; // unit vector towards the camera
        Thing thing;
    };

    struct Ball {
        int first, last, left, right; // rows and columns
        Point middle;
        double radius;
        Tint tint;
        Thing thing;
    };

    // Projects the part of a polygon that is in front of the camera, and stores its outline, in
    // pixels, in outline_, which is empty if there is no such part.
    void find_outline(const std::vector<Point> &corners);
    void add(const std::vector<Point> &corners, const Chart &chart, const Finish &finish,
             bool lies_below, Surface surface);
    double crossing(std::size_t &edge, std::size_t end, int y) const;
    void cover(Surface &surface, std::int32_t number, int y);
    void cover(const Ball &ball, std::int32_t number, int y);
    void paint(const Surface &surface, int y, int from, int count, float *to);
    void paint(const Ball &ball, int y, int from, int count, float *to);

    // The ratio of the light at a point, including lamps, to the light that `paint` assumed.
    float relight(Point place, Point normal) const;
    void relight(std::int32_t number, int y, int from, int count, float *to) const;

    // Finds the pixels that a ball may cover; returns false if there are none.
    bool find_bounds(Ball &ball) const;

    Planar planar(Point direction) const {
        return {dot(corner_, direction), dot(right_, direction), dot(down_, direction)};
    }

    Pinhole eye_;
    Point corner_, right_, down_; // the ray of pixel (0, 0), and its increments along rows and
                                  // columns
    Tint sky_;
    double even_ = 1.0;
    const std::vector<Shine> *lamps_ = nullptr;
    Thing thing_; // owner of the surfaces being drawn
    std::vector<Surface> surfaces_;
    std::vector<Ball> balls_;
    std::vector<Edge> edges_;
    std::vector<Vec> outline_;
    std::vector<std::size_t> order_,
        active_; // surfaces sorted by first row, and those that cross the current row, in drawing
                 // order
    std::size_t begun_ = 0;
    bool is_sorted_ = false;

    // The current row: for each pixel, the nearest thing (0 is the sky, n is surface n - 1, -n is
    // ball n - 1) and its 1 / depth.
    std::vector<std::int32_t> numbers_;
    std::vector<float> inverses_;
    std::vector<float> u_, v_, per_metre_, brightness_; // for one run of pixels
    Patterns patterns_;
};

} // namespace frob::sim

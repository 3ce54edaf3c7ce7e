// A picture under way: surfaces in space, and row by row of pixels what is nearest, and its light.
// What is drawn hides what is behind it, in whatever order it comes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "look.h"
#include "print.h"
#include "space.h"
#include "texture.h"
#include "truth.h"

namespace frob::sim
{

// A pinhole camera in the world. A pixel's ray is ahead + (x - cx)/f right + (y - cy)/f down,
// so a place that is t rays away has the depth t along the axis.
struct Pinhole {
    Point origin;
    Point right, down, ahead; // unit vectors
    double focal = 1.0;       // pixels
    double cx = 0.0, cy = 0.0;
    int width = 0, height = 0;

    Point ray(double x, double y) const
    {
        return ahead + ((x - cx) / focal) * right + ((y - cy) / focal) * down;
    }
};

// A flat surface's pattern or picture: where a place has 0, and which way along it and across.
struct Chart {
    Point origin, along, across;
};

// What a flat surface looks like.
struct Finish {
    Tint tint; // under its light
    Texture texture = Texture::plain;
    const Print *print = nullptr; // a picture instead of both; its chart goes from 0 to 1 then,
    double light = 1.0;           // and it has this light
    double width = 1.0;           // and is so wide, in metres
};

// The light on what faces this way: most of it comes from one side.
double light_on(Point normal);

// A lamp, and the light on what faces it 1 m away, 1 for white.
struct Shine {
    Point place;
    double light;
};

class Raster
{
  public:
    // For pictures with rows of so many pixels at most.
    explicit Raster(int longest_row);

    // Nothing is seen yet.
    void start(const Pinhole &eye);

    const Pinhole &eye() const { return eye_; }

    // The light that there is: so much everywhere, as light_on has it, and that of lamps, which
    // must stay. Without a call it is 1 and no lamps.
    void light(double even, const std::vector<Shine> &lamps) { even_ = even, lamps_ = &lamps; }

    // What is drawn from now on is of this thing.
    void of(Thing thing) { thing_ = thing; }

    // What is seen where nothing is.
    void sky(Tint tint) { sky_ = tint; }

    // A flat convex polygon. With `lies_below` it does not hide what was drawn before it in the
    // same plane.
    void polygon(const std::vector<Point> &corners, const Chart &chart, const Finish &finish,
                 bool lies_below = false);

    // The floor, at height 0, without an end. It hides nothing that was drawn before it and lies
    // on it.
    void floor(const Finish &finish);

    void ball(Point middle, double radius, Tint tint);

    // What falls on a row: red, green and blue of each pixel. Rows in their order from any
    // on, once each, when everything has been drawn.
    void row(int y, float *to);

    // What the last row's pixel in this column sees.
    Thing thing(int x) const;

    // How far away that is along the axis, in metres; infinity for the sky.
    double depth(int x) const
    {
        return 1.0 / static_cast<double>(inverses_[static_cast<std::size_t>(x)]);
    }

  private:
    // A number that depends on a pixel's column and row as a plane does.
    struct Planar {
        double corner, right, down;
        double at(double x, double y) const { return corner + x * right + y * down; }
    };

    // Of an outline in pixels: which columns the rows between its ends cross.
    struct Edge {
        double top, bottom, start, slope;
    };

    struct Surface {
        int first, last; // rows
        // The edge on the left of a row and the one before the end of these, as far as rows have
        // come; likewise on the right. None: it is as wide as a row.
        std::size_t left, left_end, right, right_end;
        bool lies_below;
        Planar inverse, u, v;    // of the depth; of the places over the depth,
        double u_start, v_start; // from these on
        Finish finish;
        Point normal; // of length 1, towards the camera
        Thing thing;
    };

    struct Ball {
        int first, last, left, right; // rows and columns
        Point middle;
        double radius;
        Tint tint;
        Thing thing;
    };

    // In pixels, of what of it is ahead of the camera; empty if nothing is. In outline_.
    void find_outline(const std::vector<Point> &corners);
    void add(const std::vector<Point> &corners, const Chart &chart, const Finish &finish,
             bool lies_below, Surface surface);
    double crossing(std::size_t &edge, std::size_t end, int y) const;
    void cover(Surface &surface, std::int32_t number, int y);
    void cover(const Ball &ball, std::int32_t number, int y);
    void paint(const Surface &surface, int y, int from, int count, float *to);
    void paint(const Ball &ball, int y, int from, int count, float *to);

    // A place's share of the light that it was painted with.
    float relight(Point place, Point normal) const;
    void relight(std::int32_t number, int y, int from, int count, float *to) const;

    // Which pixels a ball may be seen in; false if none.
    bool find_bounds(Ball &ball) const;

    Planar planar(Point direction) const
    {
        return { dot(corner_, direction), dot(right_, direction), dot(down_, direction) };
    }

    Pinhole eye_;
    Point corner_, right_, down_; // the ray of pixel (0, 0), and its steps along rows and columns
    Tint sky_;
    double even_ = 1.0;
    const std::vector<Shine> *lamps_ = nullptr;
    Thing thing_; // whose surfaces come
    std::vector<Surface> surfaces_;
    std::vector<Ball> balls_;
    std::vector<Edge> edges_;
    std::vector<Vec> outline_;
    std::vector<std::size_t> order_,
        active_; // by their first rows; those of this row, in their order
    std::size_t begun_ = 0;
    bool is_sorted_ = false;

    // Of a row: what is nearest (0 is the sky, n surface n - 1, -n ball n - 1), and 1 / depth.
    std::vector<std::int32_t> numbers_;
    std::vector<float> inverses_;
    std::vector<float> u_, v_, per_metre_, brightness_; // of a run
    Patterns patterns_;
};

} // namespace frob::sim

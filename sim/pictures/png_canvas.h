// A canvas that draws a PNG file with cairo. Each pixel of the canvas becomes 2 by 2 pixels in the
// file.
#pragma once

#include "canvas.h"

typedef struct _cairo cairo_t;
typedef struct _cairo_surface cairo_surface_t;

namespace frob::sim {

class PngCanvas : public Canvas {
  public:
    PngCanvas(double width, double height);
    ~PngCanvas() override;

    PngCanvas(const PngCanvas &) = delete;
    PngCanvas &operator=(const PngCanvas &) = delete;

    void path(const std::vector<Vec> &points, bool closed, const Paint &paint) override;
    void circle(Vec center, double radius, const Paint &paint) override;
    void text(Vec at, const std::string &text, const TextStyle &style) override;
    void image(Vec corner, Vec size, int width, int height,
               const std::vector<unsigned char> &rgb) override;
    void clip(Vec corner, Vec size) override;
    void unclip() override;
    void save(const std::string &file) override;

  private:
    void apply(const Paint &paint);

    cairo_surface_t *surface_;
    cairo_t *cairo_;
};

// Encodes an image as a PNG file, in memory.
std::string png_of(int width, int height, const std::vector<unsigned char> &rgb);

} // namespace frob::sim

// A canvas that draws an SVG file.
#pragma once

#include "canvas.h"

namespace frob::sim {

class SvgCanvas : public Canvas {
  public:
    SvgCanvas(double width, double height);

    void path(const std::vector<Vec> &points, bool closed, const Paint &paint) override;
    void circle(Vec center, double radius, const Paint &paint) override;
    void text(Vec at, const std::string &text, const TextStyle &style) override;
    void image(Vec corner, Vec size, int width, int height,
               const std::vector<unsigned char> &rgb) override;
    void clip(Vec corner, Vec size) override;
    void unclip() override;
    void save(const std::string &file) override;

  private:
    std::string out_;
    int clips_ = 0;
};

} // namespace frob::sim

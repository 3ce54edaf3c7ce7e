#include "png_canvas.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include <cairo/cairo.h>

namespace frob::sim {
namespace {

constexpr double scale = 2.0; // pixels in the file per pixel of the canvas, in each direction

void set_colour(cairo_t *cairo, Colour c) {
    cairo_set_source_rgba(cairo, c.red / 255.0, c.green / 255.0, c.blue / 255.0, c.opacity);
}

// Cairo stores each pixel as a 32-bit number: the highest byte is unused, and the others are red,
// green and blue.
cairo_surface_t *surface_of(int width, int height, const std::vector<unsigned char> &rgb) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    unsigned char *bytes = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    cairo_surface_flush(surface);
    for (int y = 0; y < height && bytes != nullptr; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x));
            const std::uint32_t pixel = static_cast<std::uint32_t>(rgb[at]) << 16 |
                                        static_cast<std::uint32_t>(rgb[at + 1]) << 8 | rgb[at + 2];
            std::memcpy(bytes + y * stride + 4 * x, &pixel, sizeof pixel);
        }
    }
    cairo_surface_mark_dirty(surface);
    return surface;
}

cairo_status_t append(void *text, const unsigned char *bytes, unsigned count) {
    static_cast<std::string *>(text)->append(bytes, bytes + count);
    return CAIRO_STATUS_SUCCESS;
}

} // namespace

std::string png_of(int width, int height, const std::vector<unsigned char> &rgb) {
    cairo_surface_t *surface = surface_of(width, height, rgb);
    std::string file;
    cairo_surface_write_to_png_stream(surface, append, &file);
    cairo_surface_destroy(surface);
    return file;
}

PngCanvas::PngCanvas(double width, double height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                          static_cast<int>(std::ceil(scale * width)),
                                          static_cast<int>(std::ceil(scale * height)))),
      cairo_(cairo_create(surface_)) {
    cairo_scale(cairo_, scale, scale);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
}

PngCanvas::~PngCanvas() {
    cairo_destroy(cairo_);
    cairo_surface_destroy(surface_);
}

// Fills and strokes the current path.
void PngCanvas::apply(const Paint &paint) {
    if (paint.fill.opacity > 0.0) {
        set_colour(cairo_, paint.fill);
        cairo_fill_preserve(cairo_);
    }
    if (paint.stroke.opacity > 0.0) {
        set_colour(cairo_, paint.stroke);
        cairo_set_line_width(cairo_, paint.width);
        cairo_set_dash(cairo_, paint.dash.data(), static_cast<int>(paint.dash.size()), 0.0);
        cairo_stroke_preserve(cairo_);
    }
    cairo_new_path(cairo_);
}

void PngCanvas::path(const std::vector<Vec> &points, bool closed, const Paint &paint) {
    for (const Vec &p : points) cairo_line_to(cairo_, p.x, p.y);
    if (closed) cairo_close_path(cairo_);
    apply(paint);
}

void PngCanvas::circle(Vec center, double radius, const Paint &paint) {
    cairo_arc(cairo_, center.x, center.y, radius, 0.0, 2.0 * pi);
    apply(paint);
}

void PngCanvas::text(Vec at, const std::string &text, const TextStyle &style) {
    cairo_select_font_face(cairo_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, style.size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, text.c_str(), &extents);
    const double share = style.anchor == Anchor::start    ? 0.0
                         : style.anchor == Anchor::middle ? 0.5
                                                          : 1.0;
    set_colour(cairo_, style.colour);
    cairo_move_to(cairo_, at.x - share * extents.x_advance, at.y);
    cairo_show_text(cairo_, text.c_str());
    cairo_new_path(cairo_);
}

void PngCanvas::image(Vec corner, Vec size, int width, int height,
                      const std::vector<unsigned char> &rgb) {
    cairo_surface_t *surface = surface_of(width, height, rgb);
    cairo_save(cairo_);
    cairo_translate(cairo_, corner.x, corner.y);
    cairo_scale(cairo_, size.x / width, size.y / height);
    cairo_set_source_surface(cairo_, surface, 0.0, 0.0);
    cairo_paint(cairo_);
    cairo_restore(cairo_);
    cairo_surface_destroy(surface);
}

void PngCanvas::clip(Vec corner, Vec size) {
    cairo_save(cairo_);
    cairo_rectangle(cairo_, corner.x, corner.y, size.x, size.y);
    cairo_clip(cairo_);
}

void PngCanvas::unclip() { cairo_restore(cairo_); }

void PngCanvas::save(const std::string &file) {
    const cairo_status_t status = cairo_surface_write_to_png(surface_, file.c_str());
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error("cannot write the picture " + file + ": " +
                                 cairo_status_to_string(status));
}

} // namespace frob::sim

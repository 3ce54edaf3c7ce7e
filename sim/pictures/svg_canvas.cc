#include "svg_canvas.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "png_canvas.h"

namespace frob::sim {
namespace {

// Formats a coordinate to hundredths of a pixel, which keeps files short without a visible
// difference.
std::string number(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", x);
    std::string result = text;
    while (result.back() == '0') result.pop_back();
    if (result.back() == '.') result.pop_back();
    return result == "-0" ? "0" : result;
}

std::string colour(const char *attribute, Colour c) {
    const std::string name = attribute;
    if (c.opacity <= 0.0) return " " + name + "=\"none\"";
    char rgb[16];
    std::snprintf(rgb, sizeof rgb, "#%02x%02x%02x", static_cast<unsigned>(c.red) & 255u,
                  static_cast<unsigned>(c.green) & 255u, static_cast<unsigned>(c.blue) & 255u);
    std::string result = " " + name + "=\"" + rgb + "\"";
    if (c.opacity < 1.0) result += " " + name + "-opacity=\"" + number(c.opacity) + "\"";
    return result;
}

std::string attributes(const Paint &paint) {
    std::string result = colour("fill", paint.fill) + colour("stroke", paint.stroke);
    if (paint.stroke.opacity > 0.0) {
        result += " stroke-width=\"" + number(paint.width) + "\"";
        for (std::size_t i = 0; i < paint.dash.size(); ++i)
            result += (i == 0 ? " stroke-dasharray=\"" : " ") + number(paint.dash[i]);
        if (!paint.dash.empty()) result += "\"";
    }
    return result;
}

std::string escaped(const std::string &text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            result += c;
    }
    return result;
}

std::string base64(const std::string &bytes) {
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three =
                three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[three >> (18 - 6 * k) & 63u];
    }
    return text;
}

} // namespace

SvgCanvas::SvgCanvas(double width, double height) {
    const std::string w = number(width), h = number(height);
    out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
           "\" viewBox=\"0 0 " + w + " " + h +
           "\" font-family=\"'DejaVu Sans', Verdana, sans-serif\""
           " stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
}

void SvgCanvas::path(const std::vector<Vec> &points, bool closed, const Paint &paint) {
    if (points.empty()) return;
    out_ += "<path d=\"";
    for (std::size_t i = 0; i < points.size(); ++i)
        out_ += (i == 0   ? "M"
                 : i == 1 ? "L"
                          : " ") +
                number(points[i].x) + " " + number(points[i].y);
    out_ += (closed ? "Z\"" : "\"") + attributes(paint) + "/>\n";
}

void SvgCanvas::circle(Vec center, double radius, const Paint &paint) {
    out_ += "<circle cx=\"" + number(center.x) + "\" cy=\"" + number(center.y) + "\" r=\"" +
            number(radius) + "\"" + attributes(paint) + "/>\n";
}

void SvgCanvas::text(Vec at, const std::string &text, const TextStyle &style) {
    out_ += "<text x=\"" + number(at.x) + "\" y=\"" + number(at.y) + "\" font-size=\"" +
            number(style.size) + "\"" + colour("fill", style.colour);
    if (style.anchor == Anchor::middle) out_ += " text-anchor=\"middle\"";
    if (style.anchor == Anchor::end) out_ += " text-anchor=\"end\"";
    if (style.bold) out_ += " font-weight=\"bold\"";
    out_ += ">" + escaped(text) + "</text>\n";
}

void SvgCanvas::image(Vec corner, Vec size, int width, int height,
                      const std::vector<unsigned char> &rgb) {
    out_ += "<image x=\"" + number(corner.x) + "\" y=\"" + number(corner.y) + "\" width=\"" +
            number(size.x) + "\" height=\"" + number(size.y) + "\" href=\"data:image/png;base64," +
            base64(png_of(width, height, rgb)) + "\"/>\n";
}

void SvgCanvas::clip(Vec corner, Vec size) {
    const std::string name = "clip" + std::to_string(++clips_);
    out_ += "<clipPath id=\"" + name + "\"><rect x=\"" + number(corner.x) + "\" y=\"" +
            number(corner.y) + "\" width=\"" + number(size.x) + "\" height=\"" + number(size.y) +
            "\"/></clipPath>\n<g clip-path=\"url(#" + name + ")\">\n";
}

void SvgCanvas::unclip() { out_ += "</g>\n"; }

void SvgCanvas::save(const std::string &file) {
    std::ofstream stream(file, std::ios::binary);
    stream << out_ << "</svg>\n";
    if (!stream.flush()) throw std::runtime_error("cannot write the picture " + file);
}

} // namespace frob::sim

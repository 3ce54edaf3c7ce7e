#include "print.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace frob::sim {
namespace {

constexpr int most_pixels = 4096; // maximum width and height
constexpr int cell = 16;          // pixels per cell of a tag

// The 6 by 6 cells inside the black frame, in rows from the upper left, where 1 is white, as
// AprilTag 3 prints them (Wang and Olson, AprilTag 2, 2016).
constexpr std::array<std::uint64_t, Print::tags> codes = {
    0xd5d628584, 0xd97f18b49, 0xdd280910e, 0xe479e9c98, 0xebcbca822, 0xf31dab3ac,
    0x056a5d085, 0x10652e1d4, 0x22b1dfead, 0x265ad0472, 0x34fe91b86, 0x3ff962cd5,
    0x43a25329a, 0x474b4385f, 0x4e9d243e9, 0x5246149ae, 0x5997f5538, 0x683bb6c4c,
    0x6be4a7211, 0x7e3158eea, 0x81da494af, 0x858339a74, 0x8cd51a5fe, 0x9f21cc2d7,
    0xa2cabc89c, 0xadc58d9eb, 0xb16e7dfb0, 0xb8c05eb3a, 0xd25ef139d, 0xd607e1962};

bool is_white(std::uint64_t code, int x, int y) {
    if (x == 0 || y == 0 || x == 9 || y == 9) return true;
    if (x == 1 || y == 1 || x == 8 || y == 8) return false;
    return (code >> (35 - 6 * (y - 2) - (x - 2)) & 1) != 0;
}

// Reads a number from the header of a netpbm file, skipping whitespace and comments.
int next_number(const std::string &text, std::size_t &at) {
    for (; at < text.size(); ++at) {
        if (text[at] == '#')
            at = std::min(text.find('\n', at), text.size() - 1);
        else if (text[at] > ' ')
            break;
    }
    int number = 0;
    const std::size_t start = at;
    for (; at < text.size() && text[at] >= '0' && text[at] <= '9' && number < 1'000'000; ++at)
        number = 10 * number + (text[at] - '0');
    return at > start ? number : -1;
}

} // namespace

Print::Print(int width, int height, const std::vector<std::uint8_t> &pixels) {
    Level first{width, height, {}};
    for (std::size_t i = 0; i + 2 < pixels.size(); i += 3)
        first.pixels.push_back({static_cast<float>(pixels[i]) / 255.0f,
                                static_cast<float>(pixels[i + 1]) / 255.0f,
                                static_cast<float>(pixels[i + 2]) / 255.0f});
    levels_.push_back(std::move(first));
    while (levels_.back().width > 1 && levels_.back().height > 1) {
        const Level &finer = levels_.back();
        Level level{finer.width / 2, finer.height / 2, {}};
        for (int y = 0; y < level.height; ++y) {
            for (int x = 0; x < level.width; ++x) {
                const auto *high =
                    &finer.pixels[static_cast<std::size_t>(2 * y * finer.width + 2 * x)];
                const auto *low = high + finer.width;
                std::array<float, 3> mean;
                for (std::size_t k = 0; k < 3; ++k)
                    mean[k] = 0.25f * ((high[0][k] + high[1][k]) + (low[0][k] + low[1][k]));
                level.pixels.push_back(mean);
            }
        }
        levels_.push_back(std::move(level));
    }
}

Print Print::of_file(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file.is_open() || file.bad()) throw std::runtime_error("cannot read this picture");
    const bool colours = text.compare(0, 2, "P6") == 0;
    if (!colours && text.compare(0, 2, "P5") != 0)
        throw std::runtime_error("a picture must be a binary PGM or PPM file");
    std::size_t at = 2;
    const int width = next_number(text, at), height = next_number(text, at);
    const int most = next_number(text, at);
    if (width < 1 || height < 1 || width > most_pixels || height > most_pixels || most != 255)
        throw std::runtime_error(
            "a picture must be 1 to 4096 pixels wide and high, and have a maximum value of 255");
    const std::size_t bytes = colours ? 3 : 1;
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    ++at; // the whitespace that ends the header
    if (text.size() < at + bytes * pixels)
        throw std::runtime_error("the size of this picture does not match its header");
    std::vector<std::uint8_t> colour;
    for (std::size_t i = 0; i < 3 * pixels; ++i)
        colour.push_back(static_cast<std::uint8_t>(text[at + (colours ? i : i / 3)]));
    return {width, height, colour};
}

Print Print::tag(int id) {
    const std::uint64_t code = codes[static_cast<std::size_t>(id)];
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < 10 * cell; ++y)
        for (int x = 0; x < 10 * cell; ++x)
            pixels.insert(pixels.end(), 3, is_white(code, x / cell, y / cell) ? 235 : 16);
    return {10 * cell, 10 * cell, pixels};
}

// Interpolates between four pixels of the first mipmap level whose pixels are not much finer than
// the camera's.
void Print::colours(int count, const float *x, const float *y, const float *per_width, float light,
                    float *to) const {
    std::size_t number = 0;
    const auto is_too_fine = [&](std::size_t level, float pixels) {
        return level + 1 < levels_.size() &&
               static_cast<float>(levels_[level].width) > 1.5f * pixels;
    };
    for (int i = 0; i < count; ++i) {
        while (is_too_fine(number, per_width[i])) ++number;
        while (number > 0 && !is_too_fine(number - 1, per_width[i])) --number;
        const Level &l = levels_[number];
        const float right = static_cast<float>(l.width - 1),
                    bottom = static_cast<float>(l.height - 1);
        const float px = std::clamp(x[i] * static_cast<float>(l.width) - 0.5f, 0.0f, right);
        const float py = std::clamp(y[i] * static_cast<float>(l.height) - 0.5f, 0.0f, bottom);
        const int column = static_cast<int>(px), row = static_cast<int>(py);
        const float right_share = px - static_cast<float>(column);
        const float low_share = py - static_cast<float>(row);
        const auto *high = &l.pixels[static_cast<std::size_t>(row * l.width + column)];
        const auto *low = high + (row + 1 < l.height ? l.width : 0);
        const int next = column + 1 < l.width ? 1 : 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const float above = high[0][k] + right_share * (high[next][k] - high[0][k]);
            const float below = low[0][k] + right_share * (low[next][k] - low[0][k]);
            to[3 * i + static_cast<int>(k)] = light * (above + low_share * (below - above));
        }
    }
}

} // namespace frob::sim

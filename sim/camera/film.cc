#include "film.h"

#include <algorithm>

#include "noise.h"
#include "wide.h"

namespace frob::sim {
namespace {

// noise stream of frame 0; frame n uses this number plus n
constexpr std::uint64_t frame_stream = std::uint64_t{1} << 32;
// maximum exposure, at which everything is white already
constexpr double longest = 3e3;
constexpr double strongest = 1e6; // maximum noise, at which pixels are already black or white with
                                  // equal probability

// Nearly normally distributed random numbers from 0 to 252. The array is so long that its reuse is
// not noticeable. Each number is the sum of four 6-bit numbers. The noise in a row of a picture is
// the sum of two sections of this array that begin at random positions. It has a mean of 252 and a
// standard deviation of 52.249, and extends to nearly five standard deviations.
class Grains {
  public:
    static constexpr float mean = 252.0f, deviation = 52.249f;

    static const std::uint8_t *from(std::uint64_t random) {
        static const Grains grains;
        return &grains.grains_[random % places];
    }

  private:
    static constexpr std::size_t places = 1u << 16;

    Grains() {
        constexpr std::uint64_t seed = 20, stream = 2;
        Noise noise(seed, stream);
        const std::size_t longest_row = 3 * static_cast<std::size_t>(CameraSettings::most_pixels);
        for (std::size_t i = 0; i < places + longest_row; i += 2) {
            std::uint64_t bits = noise.bits();
            for (int k = 0; k < 2; ++k, bits >>= 24)
                grains_.push_back(static_cast<std::uint8_t>((bits & 63) + (bits >> 6 & 63) +
                                                            (bits >> 12 & 63) + (bits >> 18 & 63)));
        }
    }

    std::vector<std::uint8_t> grains_;
};

FROB_WIDE void add_three(const float *a, const float *b, const float *c, float *__restrict to,
                         std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) to[i] = a[i] + b[i] + c[i];
}

FROB_WIDE void add_two(const float *a, const float *b, float *__restrict to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) to[i] += a[i] + b[i];
}

FROB_WIDE void take_grey(const float *light, float *__restrict to, std::size_t pixels) {
    for (std::size_t i = 0; i < pixels; ++i)
        to[i] = (77.0f * light[3 * i] + 150.0f * light[3 * i + 1] + 29.0f * light[3 * i + 2]) *
                (1.0f / 256.0f);
}

// Clamps values that are too bright, or darker than black. The limit `longest` on the exposure
// keeps each level within the range of an int.
FROB_WIDE void make_pixels(const float *light, const float *gains, float share,
                           const std::uint8_t *a, const std::uint8_t *b, float noise,
                           std::uint8_t *__restrict to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
        const float grain = static_cast<float>(a[i] + b[i]) - Grains::mean;
        const int level = static_cast<int>(gains[i] * share * light[i] + noise * grain + 0.5f);
        to[i] = static_cast<std::uint8_t>(level < 0 ? 0 : level > 255 ? 255 : level);
    }
}

// Weight of each pixel in the mean over the pixels within `radius` of pixel `i`, in a line of
// `count` pixels.
double share_of(int i, int count, int radius) {
    const int first = std::max(0, i - radius), last = std::min(count - 1, i + radius);
    return 1.0 / (last - first + 1);
}

} // namespace

Film::Film(const CameraSettings &settings, std::uint64_t seed)
    : height_(settings.height), radius_(static_cast<int>(settings.blur)),
      row_(3 * static_cast<std::size_t>(settings.width)), parts_(settings.grey ? row_ / 3 : row_),
      noise_(static_cast<float>(std::min(settings.noise, strongest)) / Grains::deviation),
      seed_(seed), dark_(row_), sums_(row_), grey_(parts_) {
    const auto radius = static_cast<std::size_t>(radius_);
    padded_.resize(row_ + 6 * radius);
    spread_.resize(row_ * (2 * radius + 1));
    pixels_.resize(parts_ * static_cast<std::size_t>(height_));
    const double gain = 255.0 * std::min(settings.exposure, longest);
    for (int x = 0; x < settings.width; ++x)
        gains_.insert(gains_.end(), settings.grey ? 1 : 3,
                      static_cast<float>(gain * share_of(x, settings.width, radius_)));
}

void Film::start(std::uint32_t number) {
    number_ = number;
    exposed_ = 0;
}

// Blurs along the rows first, then along the columns. Computes the sums in a fixed order, for many
// pixels at once, and divides at the end.
void Film::expose(const float *light) {
    const int y = exposed_++, rows = 2 * radius_ + 1;
    if (radius_ == 0) {
        std::copy(light, light + row_, sums_.begin());
        return develop(y);
    }
    std::copy(light, light + row_, padded_.begin() + 3 * radius_);
    float *spread = &spread_[static_cast<std::size_t>(y % rows) * row_];
    const float *p = padded_.data();
    add_three(p, p + 3, p + 6, spread, row_);
    for (int k = 3; k < rows; k += 2) add_two(p + 3 * k, p + 3 * k + 3, spread, row_);
    const int last = y + 1 == height_ ? y : y - radius_;
    for (int middle = y - radius_; middle <= last; ++middle) {
        if (middle < 0) continue;
        const auto row = [&](int k) { // the k-th row that is blurred into row `middle`
            const int other = middle - radius_ + k;
            return other < 0 || other > y ? dark_.data()
                                          : &spread_[static_cast<std::size_t>(other % rows) * row_];
        };
        add_three(row(0), row(1), row(2), sums_.data(), row_);
        for (int k = 3; k < rows; k += 2) add_two(row(k), row(k + 1), sums_.data(), row_);
        develop(middle);
    }
}

// Converts light to pixel values: value = 255 exposure light + noise n, n normal.
void Film::develop(int y) {
    const float *light = sums_.data();
    if (parts_ != row_) {
        take_grey(light, grey_.data(), parts_);
        light = grey_.data();
    }
    const auto share = static_cast<float>(share_of(y, height_, radius_));
    Noise random(seed_, frame_stream + number_ + (static_cast<std::uint64_t>(y) << 33));
    const std::uint64_t first = random.bits(), second = random.bits();
    make_pixels(light, gains_.data(), share, Grains::from(first), Grains::from(second), noise_,
                &pixels_[static_cast<std::size_t>(y) * parts_], parts_);
}

} // namespace frob::sim

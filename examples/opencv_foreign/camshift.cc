// OpenCV's CamShift as a step of a Frob tracker: a stateless function of an image and a region.
#include <algorithm>
#include <cmath>

#include <frob/image.h>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "opencv_foreign.h"

namespace
{

constexpr double pi = 3.14159265358979323846;

// Converts to OpenCV's hue scale, on which 180 is a full circle.
double half_degrees(double radians)
{
    return radians * 90.0 / pi;
}

// The part of the region that is in the image.
cv::Rect window_in(const frob_image *image, const frob_region *region)
{
    const auto within = [](double x, int most) {
        return x > 0.0 ? (x < most ? static_cast<int>(x) : most) : 0; // also 0 for NaN
    };
    const int left = within(region->x, image->width), top = within(region->y, image->height);
    const int right = within(region->x + region->width, image->width);
    const int bottom = within(region->y + region->height, image->height);
    return { left, top, std::max(right - left, 0), std::max(bottom - top, 0) };
}

} // namespace

extern "C" void camshift(const struct frob_image *image, const struct frob_hues *hues,
                         const struct frob_region *region, struct frob_ellipse *result)
{
    cv::Rect window = window_in(image, region);
    *result = frob_ellipse{};
    if (window.area() == 0 || image->format != FROB_RGB8)
        return;
    // Wraps the existing pixels without copying them; OpenCV does not write to them.
    const cv::Mat pixels(image->height, image->width, CV_8UC3, const_cast<void *>(image->pixels),
                         static_cast<std::size_t>(image->stride));
    cv::Mat hsv, likely;
    cv::cvtColor(pixels, hsv, cv::COLOR_RGB2HSV);
    cv::inRange(hsv, cv::Scalar(half_degrees(hues->low), 140, 50),
                cv::Scalar(half_degrees(hues->high), 255, 255), likely);
    const cv::RotatedRect found = cv::CamShift(
        likely, window, cv::TermCriteria(cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 10, 1.0));
    if (window.area() == 0)
        return;
    // CamShift returns full axis lengths, and the angle in degrees.
    result->cx = found.center.x;
    result->cy = found.center.y;
    result->major = std::max(found.size.width, found.size.height);
    result->minor = std::min(found.size.width, found.size.height);
    result->rotation = found.angle * pi / 180.0;
    result->pixels = cv::countNonZero(likely(window & cv::Rect(0, 0, image->width, image->height)));
}

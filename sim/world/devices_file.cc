#include "devices_file.h"

#include <cmath>
#include <string>

namespace frob::sim {
namespace {

// Reads the ranges of bearings that parts of the robot block: `[[from, to], …]`, in degrees.
std::vector<Vec> read_masks(TomlReader &reader) {
    std::vector<Vec> masks;
    const toml::node *node = reader.any("masked_deg");
    if (node == nullptr) return masks;
    const auto wrong = [&] {
        reader.mistake_at("masked_deg", "`masked_deg` must be a list of pairs of bearings, such as "
                                        "[[150, 170], [-170, -150]]");
        return std::vector<Vec>();
    };
    const toml::array *pairs = node->as_array();
    if (pairs == nullptr) return wrong();
    for (const toml::node &each : *pairs) {
        const toml::array *pair = each.as_array();
        if (pair == nullptr || pair->size() != 2) return wrong();
        const auto from = pair->get(0)->value<double>(), to = pair->get(1)->value<double>();
        if (!from || !to || !(std::abs(*from) <= 360.0) || !(std::abs(*to) <= 360.0))
            return wrong();
        masks.push_back({radians(*from), radians(*to)});
    }
    return masks;
}

// Reads the keys that single cameras and stereo pairs share.
CameraSettings read_any_camera(TomlReader &reader) {
    CameraSettings camera;
    camera.width = reader.integer("width", camera.width, 8, CameraSettings::most_pixels);
    camera.height = reader.integer("height", camera.height, 8, CameraSettings::most_pixels);
    camera.field_of_view =
        radians(reader.number("field_of_view_deg", degrees(camera.field_of_view), Range::positive));
    if (camera.field_of_view > radians(150.0))
        reader.mistake_at("field_of_view_deg", "`field_of_view_deg` must be at most 150");
    camera.rate = reader.number("rate", camera.rate, Range::positive);
    if (camera.rate > 200.0)
        reader.mistake_at("rate", "`rate` must be at most 200, the rate of the physics steps");
    camera.latency = reader.number("latency", camera.latency, Range::not_negative);
    camera.rolling = reader.number("rolling", camera.rolling, Range::not_negative);
    if (camera.rolling * camera.rate > 1.0)
        reader.mistake_at("rolling", "`rolling` must be at most 1 / `rate`, the time "
                                     "between frames");
    camera.jitter = reader.number("jitter", camera.jitter, Range::not_negative);
    camera.dropout = reader.number("dropout", camera.dropout, Range::share);
    camera.noise = reader.number("noise", camera.noise, Range::not_negative);
    camera.exposure = reader.number("exposure", camera.exposure, Range::positive);
    camera.blur = reader.integer("blur", 0, 0, 20);
    camera.k1 = reader.number("k1", camera.k1, Range::error);
    camera.k2 = reader.number("k2", camera.k2, Range::error);
    camera.grey = reader.boolean("grey", camera.grey);
    camera.ahead = reader.optional_number("ahead", Range::any);
    camera.left = reader.optional_number("left", Range::any);
    camera.up = reader.optional_number("up", Range::size);
    camera.yaw = radians(reader.number("yaw_deg", 0.0, Range::turn));
    camera.pitch = radians(reader.number("pitch_deg", 0.0, Range::turn));
    camera.roll = radians(reader.number("roll_deg", 0.0, Range::turn));
    return camera;
}

} // namespace

LidarSettings read_lidar(TomlReader reader) {
    LidarSettings lidar;
    if (const std::string name = reader.string("name"); !name.empty()) lidar.name = name;
    lidar.rays = reader.integer("rays", lidar.rays, 1, LidarSettings::most_rays);
    lidar.field_of_view =
        radians(reader.number("field_of_view_deg", degrees(lidar.field_of_view), Range::positive));
    if (lidar.field_of_view > radians(360.0))
        reader.mistake_at("field_of_view_deg", "`field_of_view_deg` must be at most 360");
    lidar.nearest = reader.number("nearest", lidar.nearest, Range::not_negative);
    lidar.farthest = reader.number("farthest", lidar.farthest, Range::positive);
    if (lidar.farthest <= lidar.nearest || lidar.farthest > 1000.0)
        reader.mistake_at("farthest", "`farthest` must be more than `nearest`, and at most 1000");
    lidar.rate = reader.number("rate", lidar.rate, Range::positive);
    if (lidar.rate > 200.0)
        reader.mistake_at("rate", "`rate` must be at most 200, the rate of the physics steps");
    lidar.latency = reader.number("latency", lidar.latency, Range::not_negative);
    lidar.noise = reader.number("noise", lidar.noise, Range::not_negative);
    lidar.dropout = reader.number("dropout", lidar.dropout, Range::share);
    lidar.ahead = reader.number("ahead", lidar.ahead, Range::any);
    lidar.left = reader.number("left", lidar.left, Range::any);
    lidar.yaw = radians(reader.number("yaw_deg", 0.0, Range::turn));
    lidar.masks = read_masks(reader);
    reader.finish();
    return lidar;
}

ImuSettings read_imu(TomlReader reader) {
    ImuSettings imu;
    const auto angle = [&](const char *key) {
        return radians(reader.number(key, 0.0, Range::not_negative));
    };
    if (const std::string name = reader.string("name"); !name.empty()) imu.name = name;
    imu.rate = reader.number("rate", imu.rate, Range::positive);
    if (imu.rate > 200.0)
        reader.mistake_at("rate", "`rate` must be at most 200, the rate of the physics steps");
    imu.latency = reader.number("latency", imu.latency, Range::not_negative);
    imu.gyro_noise = angle("gyro_noise_deg");
    imu.gyro_bias = angle("gyro_bias_deg");
    imu.gyro_drift = angle("gyro_drift_deg");
    imu.gyro_scale = reader.number("gyro_scale_error", 0.0, Range::error);
    imu.acceleration_noise = reader.number("acceleration_noise", 0.0, Range::not_negative);
    imu.acceleration_bias = reader.number("acceleration_bias", 0.0, Range::not_negative);
    imu.compass = reader.boolean("compass", imu.compass);
    imu.compass_noise = angle("compass_noise_deg");
    imu.compass_error = radians(reader.number("compass_error_deg", 0.0, Range::turn));
    reader.finish();
    return imu;
}

CameraSettings read_camera(TomlReader reader) {
    CameraSettings camera = read_any_camera(reader);
    if (const std::string name = reader.string("name"); !name.empty()) camera.name = name;
    reader.finish();
    return camera;
}

void read_stereo(TomlReader reader, std::vector<CameraSettings> &cameras) {
    CameraSettings left = read_any_camera(reader);
    const double baseline = reader.number("baseline", 0.12, Range::positive);
    left.name = "left";
    left.aside = baseline / 2;
    CameraSettings right = left;
    right.name = "right";
    right.aside = -baseline / 2;
    right.partner = cameras.size();
    right.askew_yaw = radians(reader.number("askew_yaw_deg", 0.0, Range::turn));
    right.askew_pitch = radians(reader.number("askew_pitch_deg", 0.0, Range::turn));
    right.askew_roll = radians(reader.number("askew_roll_deg", 0.0, Range::turn));
    reader.finish();
    cameras.push_back(left);
    cameras.push_back(right);
}

} // namespace frob::sim

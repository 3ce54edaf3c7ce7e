// Reads the tables for the robots' cameras, lidars and inertial measurement units from a
// world file.
#pragma once

#include <vector>

#include "scene.h"
#include "toml_reader.h"

namespace frob::sim {

CameraSettings read_camera(TomlReader reader);

// Reads a stereo pair, and appends its two cameras: side by side, the right one slightly misaligned.
void read_stereo(TomlReader reader, std::vector<CameraSettings> &cameras);

LidarSettings read_lidar(TomlReader reader);
ImuSettings read_imu(TomlReader reader);

} // namespace frob::sim

// Reads the tables for the robots' lidars and inertial measurement units from a world file.
#pragma once

#include "scene.h"
#include "toml_reader.h"

namespace frob::sim {

LidarSettings read_lidar(TomlReader reader);
ImuSettings read_imu(TomlReader reader);

} // namespace frob::sim

// The tables of a world file that describe the lidars and inertial measurement units of its robots.
#pragma once

#include "scene.h"
#include "toml_reader.h"

namespace frob::sim {

LidarSettings read_lidar(TomlReader reader);
ImuSettings read_imu(TomlReader reader);

} // namespace frob::sim

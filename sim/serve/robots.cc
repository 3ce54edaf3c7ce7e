#include "robots.h"

#include "body_firmware.h"
#include "create_wire.h"
#include "pioneer_firmware.h"
#include "scout_wire.h"

namespace frob::serve {

std::uint32_t usual_rate(const std::string &robot) {
    if (robot == "pioneer") return 9600;
    if (robot == "scout") return 38400;
    if (robot == "create") return 115200;
    return 0;
}

std::unique_ptr<Firmware> make_firmware(const std::string &robot, const std::string &model,
                                        std::uint32_t rate, frob_sim *sim) {
    if (robot == "scout")
        return std::make_unique<BodyFirmware<sim::ScoutWire, frob_scout_input>>(sim, rate);
    if (robot == "create")
        return std::make_unique<BodyFirmware<sim::CreateWire, frob_create_input>>(sim, rate);
    const PioneerModel *known = PioneerFirmware::find_model(model);
    if (robot != "pioneer" || !known) return nullptr;
    return std::make_unique<PioneerFirmware>(sim, *known, rate);
}

} // namespace frob::serve

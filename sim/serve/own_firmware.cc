#include "own_firmware.h"

#include <algorithm>

#include <dlfcn.h>

#include "options.h"

namespace frob::serve {
namespace {

std::vector<std::uint64_t> room(std::size_t bytes) {
    return std::vector<std::uint64_t>(bytes / sizeof(std::uint64_t) + 1);
}

const void *part_of(void *object, const std::string &robot, const std::string &part) {
    const std::string symbol = "frob_" + robot + "_" + part;
    const void *found = dlsym(object, symbol.c_str());
    if (found == nullptr)
        throw WrongUse("there is no `" + symbol + "` in the C files of the robot: define the " +
                       part + " of your own robot in a C file, and add the file with `--with`");
    return found;
}

} // namespace

OwnRobot load_own_robot(const std::string &path, const std::string &robot) {
    void *object = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (object == nullptr)
        throw WrongUse("cannot load the C files of the robot: " + std::string(dlerror()));
    return {static_cast<const frob_body *>(part_of(object, robot, "body")),
            static_cast<const frob_board *>(part_of(object, robot, "board"))};
}

OwnFirmware::OwnFirmware(const frob_board &board, frob_sim *sim, std::uint32_t rate)
    : board_(board), sim_(sim), rate_(rate), memory_(room(board.size)),
      input_(room(frob_sim_input_size(sim))), output_(room(frob_sim_output_size(sim))) {
    look(0);
}

void OwnFirmware::advance(std::int64_t time_ns) {
    for (; next_ns_ <= time_ns; next_ns_ += period_ns) look(next_ns_);
    now_ns_ = std::max(now_ns_, time_ns);
    frob_answer answer{};
    board_.advance(memory_.data(), now_ns_, &answer);
    pass_on(answer);
}

void OwnFirmware::receive(std::uint8_t byte) {
    frob_answer answer{};
    board_.receive(memory_.data(), byte, &answer);
    pass_on(answer);
}

void OwnFirmware::look(std::int64_t time_ns) {
    now_ns_ = time_ns;
    frob_sim_advance(sim_, time_ns);
    frob_sim_read(sim_, input_.data());
    board_.sense(memory_.data(), input_.data(), time_ns);
    frob_answer answer{};
    board_.advance(memory_.data(), time_ns, &answer);
    pass_on(answer);
}

// Passes the robot's current command to the body, and the robot's bytes to the client.
void OwnFirmware::pass_on(const frob_answer &answer) {
    std::fill(output_.begin(), output_.end(), 0);
    board_.drive(memory_.data(), output_.data());
    frob_sim_command(sim_, now_ns_, output_.data());
    send(Bytes(answer.bytes, answer.bytes + answer.count));
}

} // namespace frob::serve

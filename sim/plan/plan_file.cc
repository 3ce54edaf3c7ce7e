#include "plan_file.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <vector>

#include "toml_reader.h"
#include "toml_syntax.h"
#include "world_file.h"

namespace frob::sim {
namespace {

constexpr int most_seeds = 1'000'000'000;
constexpr int most_points_of_plan = 10'000'000;

const char *range_form =
    "write a range as \"LOW to HIGH, N steps\", such as \"2[1/m] to 8[1/m], 7 steps\"; "
    "with `sampling`, write \"LOW to HIGH\"";

class PlanReader {
  public:
    PlanReader(Mistakes &mistakes, const toml::table &root)
        : mistakes_(mistakes), reader_(mistakes, root) {}

    std::string read() {
        text("program", true);
        text("trial", false);
        seeds();
        number("lasts", 1e5);
        number("rate", 10'000.0);
        texts("world", "worlds");
        texts("robot", "robots");
        sampling();
        if (const toml::table *params = reader_.table("params"))
            for (const auto &[key, node] : *params) param(std::string(key.str()), node);
        reader_.finish();
        return lines_;
    }

  private:
    void line(const std::vector<std::string> &cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) lines_ += (i == 0 ? "" : "\t") + cells[i];
        lines_ += "\n";
    }

    std::string place(const toml::node &node) { return mistakes_.place(node.source().begin); }

    void mistake(const toml::node &node, const std::string &message) {
        mistakes_.add(node.source(), message);
    }

    // Checks that a value is not empty and contains no tab or line break, which would split its
    // cell or line.
    bool is_plain(const toml::node &node, const std::string &value) {
        const bool plain = !value.empty() && value.find_first_of("\t\n\r") == std::string::npos;
        if (!plain) mistake(node, "this string must not be empty or contain a tab or a line break");
        return plain;
    }

    void text(const char *key, bool needed) {
        const std::string value = needed ? reader_.needed_string(key) : reader_.string(key);
        const toml::node *node = reader_.any(key);
        if (node != nullptr && node->is_string() && is_plain(*node, value))
            line({key, place(*node), value});
    }

    void seeds() {
        const toml::node *node = reader_.any("seeds");
        if (node == nullptr) return;
        const toml::array *list = node->as_array();
        if (list == nullptr || list->size() != 2 || !list->get(0)->is_integer() ||
            !list->get(1)->is_integer()) {
            mistake(*node, "`seeds` must be the first and the last seed, as in [1, 20]");
            return;
        }
        const auto first = *list->get(0)->value<std::int64_t>();
        const auto last = *list->get(1)->value<std::int64_t>();
        if (first < 1 || last > most_seeds)
            mistake(*node, "seeds must be from 1 to 1,000,000,000");
        else if (last < first)
            mistake(*node, "the last seed is less than the first; write [" + std::to_string(last) +
                               ", " + std::to_string(first) + "]");
        else
            line({"seeds", std::to_string(first), std::to_string(last)});
    }

    void number(const char *key, double most) {
        const std::optional<double> value = reader_.optional_number(key, Range::positive);
        if (!value) return;
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.9g", *value);
        if (*value > most)
            reader_.mistake_at(key, "`" + std::string(key) + "` must be at most " +
                                        std::to_string(static_cast<int>(most)));
        else
            line({key, digits});
    }

    // Reads a list of strings.
    void texts(const char *one, const char *key) {
        const toml::node *node = reader_.any(key);
        if (node == nullptr) return;
        const toml::array *list = node->as_array();
        if (list == nullptr || list->empty()) {
            mistake(*node,
                    "`" + std::string(key) + "` must be a list of strings, such as [\"a\", \"b\"]");
            return;
        }
        for (const toml::node &item : *list) {
            const std::optional<std::string> value = item.value<std::string>();
            if (!item.is_string() || !value)
                mistake(item, "`" + std::string(key) + "` must be a list of strings");
            else if (is_plain(item, *value))
                line({one, place(item), *value});
        }
    }

    void sampling() {
        const toml::node *node = reader_.any("sampling");
        const std::string how = node == nullptr ? "grid" : reader_.string("sampling");
        const int points = reader_.integer("points", 0, 1, most_points_of_plan);
        const int seed = reader_.integer("sampling_seed", 1, 1, most_seeds);
        is_sampled_ = how == "random" || how == "latin";
        if (!is_sampled_ && how != "grid")
            reader_.mistake_at("sampling", "`sampling` must be \"grid\", \"random\" or \"latin\"");
        else if (is_sampled_ && reader_.any("points") == nullptr)
            reader_.mistake_at("sampling",
                               "`sampling = \"" + how +
                                   "\"` needs the number of points: add the key `points`");
        else if (!is_sampled_ && reader_.any("points") != nullptr)
            reader_.mistake_at("points",
                               "`points` is only for `sampling = \"random\"` or `\"latin\"`: "
                               "for a grid, remove it and write the number of steps in each range");
        line({"sampling", how, std::to_string(points), std::to_string(seed)});
    }

    // Reads a value that `--param` accepts: a number, boolean or string.
    std::optional<std::string> setting(const toml::node &node) {
        if (const auto *value = node.as_string())
            return is_plain(node, value->get()) ? std::optional(value->get()) : std::nullopt;
        if (const auto *value = node.as_boolean()) return value->get() ? "True" : "False";
        if (const auto *value = node.as_integer()) return std::to_string(value->get());
        if (const auto *value = node.as_floating_point();
            value != nullptr && std::isfinite(value->get())) {
            char digits[40];
            std::snprintf(digits, sizeof digits, "%.17g", value->get());
            return digits;
        }
        mistake(node, "a parameter must be a number, true, false or a string such as \"4[1/m]\"");
        return std::nullopt;
    }

    void param(const std::string &name, const toml::node &node) {
        if (const toml::array *list = node.as_array()) {
            std::vector<std::string> cells = {"values", place(node), name};
            for (const toml::node &item : *list)
                if (const auto value = setting(item)) cells.push_back(*value);
            if (list->empty()) mistake(node, "this list is empty: add a value");
            line(cells);
            return;
        }
        const std::string *value = node.is_string() ? &node.as_string()->get() : nullptr;
        if (value != nullptr && value->find(" to ") != std::string::npos)
            range(name, node, *value);
        else if (const auto one = setting(node))
            line({"values", place(node), name, *one});
    }

    void range(const std::string &name, const toml::node &node, const std::string &value) {
        const std::size_t to = value.find(" to "), comma = value.find_last_of(',');
        const bool has_steps = comma != std::string::npos && comma > to;
        std::string low = value.substr(0, to);
        std::string high = value.substr(to + 4, has_steps ? comma - to - 4 : std::string::npos);
        int steps = 0;
        if (has_steps) {
            char rest[8] = "", end = '\0';
            const std::string text = value.substr(comma + 1);
            if (std::sscanf(text.c_str(), " %9d %7[steps] %c", &steps, rest, &end) != 2 ||
                std::string(rest) != "steps") {
                mistake(node, range_form);
                return;
            }
        }
        if (has_steps && (steps < 2 || steps > most_points_of_plan))
            mistake(node, "the number of steps must be from 2 (the two ends) to 10,000,000");
        else if (!has_steps && !is_sampled_)
            mistake(node, std::string("the number of steps is missing: ") + range_form);
        else if (has_steps && is_sampled_)
            mistake(node, "a sampled range has no steps: write \"" + low + " to " + high + "\"");
        else if (is_plain(node, low) && is_plain(node, high))
            line({"range", place(node), name, low, high, std::to_string(steps)});
    }

    Mistakes &mistakes_;
    TomlReader reader_;
    std::string lines_;
    bool is_sampled_ = false;
};

} // namespace

std::string read_plan_file(const std::string &path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file.is_open() || file.bad()) throw WorldFileError(path + ": cannot read this plan");
    Mistakes mistakes(path);
    try {
        const toml::table root = toml::parse(text);
        std::string lines = PlanReader(mistakes, root).read();
        if (!mistakes.any()) return lines;
    } catch (const toml::parse_error &error) {
        const toml::source_region &where = error.source();
        mistakes.add(
            where, syntax_mistake(text, where.begin.line, where.begin.column, error.description()));
    }
    throw WorldFileError(mistakes.text());
}

} // namespace frob::sim

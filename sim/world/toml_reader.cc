#include "toml_reader.h"

#include <algorithm>
#include <cmath>

namespace frob::sim {
namespace {

constexpr double smallest = 0.01; // m

// The Levenshtein distance: the minimum number of insertions, deletions and replacements of
// letters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row[b.size()];
}

// The known name that was probably meant: a name with an additional unit (`heading_deg` for
// `heading`), or a name that differs in only a few letters.
std::optional<std::string_view> nearest(const std::vector<std::string_view> &known,
                                        std::string_view name) {
    std::optional<std::string_view> best;
    std::size_t least = 2 + name.size() / 4;
    for (const std::string_view candidate : known) {
        if (candidate.size() > name.size() &&
            candidate.substr(0, name.size() + 1) == std::string(name) + "_")
            return candidate;
        const std::size_t distance = edit_distance(name, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

std::string quoted(std::string_view name) { return "`" + std::string(name) + "`"; }

const char *kind(const toml::node &node) {
    switch (node.type()) {
    case toml::node_type::none: return "nothing";
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "a list";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "a whole number";
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time: return "a date or time";
    }
    return "something else";
}

bool within(double x, Range range) {
    if (!(std::abs(x) <= 1e6)) return false;
    switch (range) {
    case Range::any: return true;
    case Range::not_negative: return x >= 0.0;
    case Range::positive: return x > 0.0;
    case Range::size: return x >= smallest;
    case Range::share: return x >= 0.0 && x < 1.0;
    case Range::part: return x >= 0.0 && x <= 1.0;
    case Range::error: return x >= -1.0 && x <= 1.0;
    case Range::turn: return x >= -360.0 && x <= 360.0;
    }
    return false;
}

const char *describe(Range range) {
    switch (range) {
    case Range::any: return "a number up to a million";
    case Range::not_negative: return "zero or more";
    case Range::positive: return "more than zero";
    case Range::size: return "at least 0.01 m";
    case Range::share: return "at least 0 and less than 1";
    case Range::part: return "from 0 to 1";
    case Range::error: return "a fraction of the measured value, from -1 to 1";
    case Range::turn: return "an angle from -360 to 360";
    }
    return "";
}

} // namespace

void Mistakes::add(const toml::source_region &where, const std::string &message) {
    found_.push_back({where.begin, message});
}

std::string Mistakes::place(const toml::source_position &where) const {
    return path_ + ":" + std::to_string(where.line) + ":" + std::to_string(where.column);
}

std::string Mistakes::text() const {
    std::vector<Mistake> ordered = found_;
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const Mistake &a, const Mistake &b) { return a.where < b.where; });
    std::string text;
    for (const Mistake &mistake : ordered)
        text += (text.empty() ? "" : "\n") + place(mistake.where) + ": " + mistake.message;
    return text;
}

const toml::node *TomlReader::find(std::string_view key) {
    asked_.push_back(key);
    return table_.get(key);
}

const toml::node *TomlReader::need(std::string_view key) {
    const toml::node *node = find(key);
    if (node == nullptr) lacking_.push_back(key);
    return node;
}

std::optional<double> TomlReader::as_number(const toml::node &node, std::string_view key,
                                            Range range) {
    const std::optional<double> value = node.value<double>();
    if (!node.is_number() || !value) {
        mistakes_.add(node.source(), quoted(key) + " is " + kind(node) + ", but must be a number");
        return std::nullopt;
    }
    if (!within(*value, range)) {
        mistakes_.add(node.source(), quoted(key) + " must be " + describe(range));
        return std::nullopt;
    }
    return value;
}

std::optional<Vec> TomlReader::as_point(const toml::node &node, std::string_view key, Range range) {
    const toml::array *pair = node.as_array();
    if (pair == nullptr || pair->size() != 2) {
        mistakes_.add(node.source(), quoted(key) + " takes two numbers, [x, y]");
        return std::nullopt;
    }
    const std::optional<double> x = as_number((*pair)[0], key, range);
    const std::optional<double> y = as_number((*pair)[1], key, range);
    if (!x || !y) return std::nullopt;
    return Vec{*x, *y};
}

bool TomlReader::boolean(std::string_view key, bool otherwise) {
    const toml::node *node = find(key);
    if (node == nullptr) return otherwise;
    if (!node->is_boolean())
        mistakes_.add(node->source(),
                      quoted(key) + " is " + kind(*node) + ", but must be true or false");
    return node->value_or(otherwise);
}

double TomlReader::number(std::string_view key, double otherwise, Range range) {
    const toml::node *node = find(key);
    return node == nullptr ? otherwise : as_number(*node, key, range).value_or(otherwise);
}

std::optional<double> TomlReader::optional_number(std::string_view key, Range range) {
    const toml::node *node = find(key);
    return node == nullptr ? std::nullopt : as_number(*node, key, range);
}

double TomlReader::needed_number(std::string_view key, Range range) {
    const toml::node *node = need(key);
    return node == nullptr ? 1.0 : as_number(*node, key, range).value_or(1.0);
}

int TomlReader::integer(std::string_view key, int otherwise, int least, int most) {
    const toml::node *node = find(key);
    if (node == nullptr) return otherwise;
    const std::optional<std::int64_t> value =
        node->is_integer() ? node->value<std::int64_t>() : std::nullopt;
    if (value && *value >= least && *value <= most) return static_cast<int>(*value);
    mistakes_.add(node->source(), quoted(key) + " must be a whole number from " +
                                      std::to_string(least) + " to " + std::to_string(most));
    return otherwise;
}

std::string TomlReader::string(std::string_view key) {
    const toml::node *node = find(key);
    if (node == nullptr) return "";
    if (!node->is_string())
        mistakes_.add(node->source(),
                      quoted(key) + " is " + kind(*node) + ", but must be a string");
    return node->value_or(std::string());
}

std::string TomlReader::needed_string(std::string_view key) {
    return need(key) == nullptr ? "" : string(key);
}

Vec TomlReader::needed_point(std::string_view key, Range range) {
    const toml::node *node = need(key);
    return node == nullptr ? Vec{1.0, 1.0} : as_point(*node, key, range).value_or(Vec{1.0, 1.0});
}

std::vector<Vec> TomlReader::needed_points(std::string_view key, std::size_t least, bool closed) {
    const toml::node *node = need(key);
    if (node == nullptr) return {};
    const toml::array *list = node->as_array();
    if (list == nullptr || list->size() < least) {
        mistakes_.add(node->source(), quoted(key) + " takes a list of at least " +
                                          std::to_string(least) + " points [x, y]");
        return {};
    }
    if (list->size() > most_points) {
        mistakes_.add(node->source(), quoted(key) + " takes at most " +
                                          std::to_string(most_points) + " points, but has " +
                                          std::to_string(list->size()));
        return {};
    }
    std::vector<Vec> points;
    for (const toml::node &item : *list) {
        const std::optional<Vec> point = as_point(item, key, Range::any);
        if (!point) return {};
        if (!points.empty() && length(*point - points.back()) < smallest) {
            mistakes_.add(item.source(), "this point is less than 1 cm from the one before it");
            return {};
        }
        points.push_back(*point);
    }
    if (closed && length(points.front() - points.back()) < smallest) {
        mistakes_.add(list->back().source(), "this point repeats the first one; remove it, because "
                                             "the last point is joined to the first");
        return {};
    }
    return points;
}

const toml::table *TomlReader::table(std::string_view key) {
    const toml::node *node = find(key);
    if (node == nullptr) return nullptr;
    if (!node->is_table())
        mistakes_.add(node->source(), quoted(key) + " is " + kind(*node) +
                                          ", but must be a table [" + std::string(key) + "]");
    return node->as_table();
}

std::vector<const toml::table *> TomlReader::tables(std::string_view key) {
    const toml::node *node = find(key);
    std::vector<const toml::table *> tables;
    if (node == nullptr) return tables;
    const toml::array *list = node->as_array();
    const auto is_table = [](const toml::node &item) { return item.is_table(); };
    if (list == nullptr || !std::all_of(list->begin(), list->end(), is_table)) {
        mistakes_.add(node->source(), quoted(key) + " is " + kind(*node) +
                                          "; write a separate table [[" + std::string(key) +
                                          "]] for each " + std::string(key));
        return tables;
    }
    for (const toml::node &item : *list) tables.push_back(item.as_table());
    return tables;
}

std::vector<const toml::table *> TomlReader::table_or_tables(std::string_view key) {
    const toml::node *node = table_.get(key);
    if (node != nullptr && node->is_array()) return tables(key);
    if (const toml::table *only = table(key)) return {only};
    return {};
}

void TomlReader::mistake(const std::string &message) { mistakes_.add(table_.source(), message); }

void TomlReader::mistake_at(std::string_view key, const std::string &message) {
    const toml::node *node = table_.get(key);
    mistakes_.add(node == nullptr ? table_.source() : node->source(), message);
}

void TomlReader::finish() {
    std::vector<std::string_view> misspelt;
    for (const auto &[key, node] : table_) {
        const std::string_view name = key.str();
        if (std::find(asked_.begin(), asked_.end(), name) != asked_.end()) continue;
        std::string message = "unknown key " + quoted(name);
        if (const std::optional<std::string_view> meant = nearest(asked_, name)) {
            message += "; did you mean " + quoted(*meant) + "?";
            misspelt.push_back(*meant);
        }
        mistakes_.add(key.source(), message);
    }
    for (const std::string_view key : lacking_)
        if (std::find(misspelt.begin(), misspelt.end(), key) == misspelt.end())
            mistake("this needs a key " + quoted(key));
}

} // namespace frob::sim

// A TOML table read key by key, with messages that name file, line and column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "geometry.h"

namespace frob::sim
{

// The mistakes found in a file so far.
class Mistakes
{
  public:
    explicit Mistakes(std::string path) : path_(std::move(path)) {}

    void add(const toml::source_region &where, const std::string &message);
    bool any() const { return !found_.empty(); }

    // A line for each, in the file's order.
    std::string text() const;

    // `FILE:LINE:COLUMN`.
    std::string place(const toml::source_position &where) const;

  private:
    struct Mistake {
        toml::source_position where;
        std::string message;
    };

    std::string path_;
    std::vector<Mistake> found_;
};

// What a world has of points at the most: more are slower than the robot.
constexpr std::size_t most_points = 20'000;

// Which numbers a key takes; none beyond a million. Box2D merges what is nearer
// than a few millimetres, so things that have a size are a centimetre or more.
enum class Range { any, not_negative, positive, size, share, part, error, turn };

// Asks a table for its keys; `finish` then reports the keys nobody asked for, and
// those that are needed and missing, unless one of the former was meant for it.
// A mistake is reported and a default returned, so that reading goes on.
class TomlReader
{
  public:
    TomlReader(Mistakes &mistakes, const toml::table &table) : mistakes_(mistakes), table_(table) {}

    bool boolean(std::string_view key, bool otherwise);
    double number(std::string_view key, double otherwise, Range range);
    std::optional<double> optional_number(std::string_view key, Range range);
    double needed_number(std::string_view key, Range range);
    int integer(std::string_view key, int otherwise, int least, int most);
    std::string string(std::string_view key);
    std::string needed_string(std::string_view key);
    Vec needed_point(std::string_view key, Range range);
    // Neighbours differ; so do the last and the first if `closed`.
    std::vector<Vec> needed_points(std::string_view key, std::size_t least, bool closed);

    // Whatever is at a key, or nullptr.
    const toml::node *any(std::string_view key) { return find(key); }

    // The table at a key, or nullptr.
    const toml::table *table(std::string_view key);
    // The tables of `[[key]]`; none if it does not occur.
    std::vector<const toml::table *> tables(std::string_view key);

    // The one table of `[key]`, or those of `[[key]]`.
    std::vector<const toml::table *> table_or_tables(std::string_view key);

    // Where this table starts, `FILE:LINE:COLUMN`.
    std::string place() const { return mistakes_.place(table_.source().begin); }

    // Says that something is wrong with this table as a whole, or with a key.
    void mistake(const std::string &message);
    void mistake_at(std::string_view key, const std::string &message);

    void finish();

  private:
    const toml::node *find(std::string_view key);
    const toml::node *need(std::string_view key);
    std::optional<double> as_number(const toml::node &node, std::string_view key, Range range);
    std::optional<Vec> as_point(const toml::node &node, std::string_view key, Range range);

    Mistakes &mistakes_;
    const toml::table &table_;
    std::vector<std::string_view> asked_;
    std::vector<std::string_view> lacking_;
};

} // namespace frob::sim

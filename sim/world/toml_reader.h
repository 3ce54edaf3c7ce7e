// Reads a TOML table key by key, and reports mistakes with file, line and column.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <toml++/toml.h>

#include "geometry.h"

namespace frob::sim {

// The mistakes found in a file so far.
class Mistakes {
  public:
    explicit Mistakes(std::string path) : path_(std::move(path)) {}

    void add(const toml::source_region &where, const std::string &message);
    bool any() const { return !found_.empty(); }

    // One line for each mistake, in file order.
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

// Maximum number of points in a world. With more points, a simulation would be slower than real
// time.
constexpr std::size_t most_points = 20'000;

// The range of numbers that a key allows. No number may exceed a million. Box2D merges points that
// are a few millimetres apart, so sizes must be at least a centimetre.
enum class Range { any, not_negative, positive, size, share, part, error, turn };

// Reads the keys of a table. `finish` then reports all unknown keys and all missing required keys.
// It does not report a missing key if an unknown key is probably a misspelling of it. After a
// mistake, the reader returns a default value and continues.
class TomlReader {
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
    // Neighbouring points must be at least a centimetre apart. If `closed` is true, this also
    // applies to the last and the first point.
    std::vector<Vec> needed_points(std::string_view key, std::size_t least, bool closed);

    // Returns the value for a key, whatever its type, or nullptr if there is none.
    const toml::node *any(std::string_view key) { return find(key); }

    // Returns the table at a key, or nullptr if there is none.
    const toml::table *table(std::string_view key);
    // Returns the tables of `[[key]]`; empty if there are none.
    std::vector<const toml::table *> tables(std::string_view key);

    // Returns the single table of `[key]`, or the tables of `[[key]]`.
    std::vector<const toml::table *> table_or_tables(std::string_view key);

    // The place where this table starts, as `FILE:LINE:COLUMN`.
    std::string place() const { return mistakes_.place(table_.source().begin); }

    // Reports a mistake in this table as a whole, or at a key.
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

#include "toml_syntax.h"

#include <cctype>
#include <optional>

namespace frob::sim {
namespace {

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::string_view trimmed(std::string_view s) {
    while (!s.empty() && is_blank(s.front())) s.remove_prefix(1);
    while (!s.empty() && is_blank(s.back())) s.remove_suffix(1);
    return s;
}

std::string_view line_of(std::string_view text, std::size_t line) {
    for (std::size_t n = 1; n < line; ++n) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) return {};
        text.remove_prefix(end + 1);
    }
    return text.substr(0, text.find('\n'));
}

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

// The value at a column, or the value that ends just before that column: the text from the last
// `=`, `[` or `,` up to the next `,`, `]` or comment.
std::string_view value_at(std::string_view line, std::size_t column) {
    const std::size_t here = column > 0 ? column - 1 : 0;
    const std::string_view before = line.substr(0, here < line.size() ? here : line.size());
    const std::size_t opener = before.find_last_of("=[,");
    const std::size_t start = opener == std::string_view::npos ? 0 : opener + 1;
    const std::size_t end = line.find_first_of("],#", start);
    const std::size_t stop = end == std::string_view::npos ? line.size() : end;
    return trimmed(line.substr(start, stop - start));
}

// The digits, sign, point and exponent at the start of a string.
std::string_view leading_number(std::string_view s) {
    std::size_t n = 0;
    if (n < s.size() && (s[n] == '+' || s[n] == '-')) ++n;
    const std::size_t digits = n;
    while (n < s.size() && (is_digit(s[n]) || s[n] == '.' || s[n] == '_')) ++n;
    if (n == digits) return {};
    if (n + 1 < s.size() && (s[n] == 'e' || s[n] == 'E')) {
        std::size_t m = n + 1;
        if (s[m] == '+' || s[m] == '-') ++m;
        if (m < s.size() && is_digit(s[m])) {
            while (m < s.size() && is_digit(s[m])) ++m;
            n = m;
        }
    }
    return s.substr(0, n);
}

// Recognizes a unit after a number: `1.5 m`, `90deg`, `1[m]` or `5 %`.
bool is_unit(std::string_view rest) {
    const unsigned char first = static_cast<unsigned char>(rest.front());
    return is_letter(rest.front()) || rest.front() == '[' || rest.front() == '%' || first >= 0x80;
}

std::optional<std::string> about_number(std::string_view line, std::string_view value,
                                        std::string_view number) {
    const std::string_view rest = trimmed(value.substr(number.size()));
    if (has(rest, "=")) return std::string("write only one key on each line");
    const bool in_brackets = number.data() + number.size() < line.data() + line.size() &&
                             rest.empty() && number.data()[number.size()] == '[';
    if (in_brackets || (!rest.empty() && is_unit(rest)))
        return std::string("write the number without a unit: lengths are in metres, angles in "
                           "degrees, masses in kilograms, times in seconds");
    if (!rest.empty() &&
        (rest.front() == '/' || rest.front() == '*' || rest.front() == '+' || rest.front() == '-'))
        return std::string("expressions are not allowed here: write the result");
    if (number.front() == '.' || number.back() == '.')
        return std::string("a number needs digits on both sides of the decimal point, as in `0.5`");
    return std::nullopt;
}

std::optional<std::string> about_word(std::string_view word) {
    if (word == "True" || word == "False")
        return std::string("write `true` or `false` in lower case");
    for (const char c : word)
        if (!is_letter(c) && !is_digit(c) && c != '_' && c != '-') return std::nullopt;
    return "put strings in quotation marks: `\"" + std::string(word) + "\"`";
}

std::optional<std::string> about_value(std::string_view line, std::size_t column,
                                       std::string_view description) {
    const std::string_view value = value_at(line, column);
    if (has(description, "expected value") || value.empty())
        return std::string("a value is missing after the `=`");
    const std::string_view number = leading_number(value);
    if (!number.empty()) return about_number(line, value, number);
    if (is_letter(value.front())) return about_word(value);
    return std::nullopt;
}

// Recognizes a decimal comma: `x = 1,5`.
bool is_decimal_comma(std::string_view line, std::size_t column) {
    const std::size_t comma = column - 1;
    return has(line, "=") && comma > 0 && comma + 1 < line.size() && line[comma] == ',' &&
           is_digit(line[comma - 1]) && is_digit(line[comma + 1]);
}

std::optional<std::string> sentence(std::string_view line, std::size_t column,
                                    std::string_view description) {
    if (has(description, "cannot redefine"))
        return std::string("this is already defined in the file");
    if (has(description, "leading zeroes")) return std::string("a number must not start with `0`");
    if (has(description, "not representable")) return std::string("this number is too large");
    if (has(description, "parsing string"))
        return std::string("a string must end with `\"` on the line on which it begins");
    if (has(description, "parsing table header"))
        return std::string("put the name of a table in brackets, as in `[start]` or `[[wall]]`");
    if (has(description, "expected '='"))
        return std::string("write a key, `=` and its value, as in `x = 0.5`");
    if (has(description, "root table"))
        return std::string("write `key = value`, a table's name such as `[start]`, or a comment, "
                           "which begins with `#`");
    if (is_decimal_comma(line, column))
        return std::string("write the number with a decimal point, not with a comma");
    const std::optional<std::string> found = about_value(line, column, description);
    if (found) return found;
    if (has(description, "parsing array"))
        return std::string("separate the elements with `,`, and write `]` after the last one");
    if (has(description, "could not determine"))
        return std::string("this is not a value: write a number, a string in quotation marks, "
                           "`true`, `false`, or a list in brackets");
    return std::nullopt;
}

} // namespace

std::string syntax_mistake(std::string_view text, std::size_t line, std::size_t column,
                           std::string_view description) {
    if (const auto found = sentence(line_of(text, line), column, description)) return *found;
    std::string plain(description);
    if (!plain.empty())
        plain[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(plain[0])));
    return plain;
}

} // namespace frob::sim

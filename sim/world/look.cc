#include "look.h"

#include <cstddef>

namespace frob::sim {
namespace {

struct NamedTint {
    const char *name;
    Tint tint;
};

constexpr NamedTint tints[] = {
    {"white", {0.92, 0.92, 0.92}}, {"grey", {0.50, 0.50, 0.50}},   {"black", {0.06, 0.06, 0.07}},
    {"red", {0.80, 0.10, 0.10}},   {"orange", {0.95, 0.42, 0.06}}, {"yellow", {0.92, 0.82, 0.10}},
    {"green", {0.13, 0.60, 0.20}}, {"blue", {0.12, 0.28, 0.78}},   {"purple", {0.52, 0.16, 0.64}},
    {"pink", {0.94, 0.45, 0.62}},  {"brown", {0.42, 0.27, 0.16}},
};

struct NamedTexture {
    const char *name;
    Texture texture;
};

constexpr NamedTexture textures[] = {
    {"plain", Texture::plain},     {"plaster", Texture::plaster}, {"bricks", Texture::bricks},
    {"stripes", Texture::stripes}, {"checks", Texture::checks},
};

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

template <typename Named, std::size_t count>
std::string names(const Named (&all)[count]) {
    std::string text;
    for (const Named &one : all) text += (text.empty() ? "" : ", ") + std::string(one.name);
    return text;
}

} // namespace

std::optional<Tint> tint_of(const std::string &text) {
    for (const NamedTint &named : tints)
        if (text == named.name) return named.tint;
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    double parts[3];
    for (std::size_t i = 0; i < 3; ++i) {
        const int high = hex_digit(text[1 + 2 * i]), low = hex_digit(text[2 + 2 * i]);
        if (high < 0 || low < 0) return std::nullopt;
        parts[i] = (16 * high + low) / 255.0;
    }
    return Tint{parts[0], parts[1], parts[2]};
}

std::string tint_names() { return names(tints); }

std::optional<Texture> texture_of(const std::string &name) {
    for (const NamedTexture &named : textures)
        if (name == named.name) return named.texture;
    return std::nullopt;
}

std::string texture_names() { return names(textures); }

} // namespace frob::sim

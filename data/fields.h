#pragma once

#include "data/tokens.h"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Named fields of an entity, in any order, each at most once: "roughness 0.2 gloss 40".
namespace rayshoot {

class Fields {
public:
    /// `entity`: for errors. `names` outlive this.
    Fields(Tokens& tokens, std::string_view entity, std::span<const std::string_view> names)
        : tokens_(tokens), entity_(entity), names_(names) {}

    /// The next word if it is a field's name, which is then read; else empty, and nothing is read.
    std::string_view next() {
        const std::string_view word = tokens_.peek();
        if (!among(names_, word)) return {};
        tokens_.next();
        if (among(given_, word))
            tokens_.refuse(std::string(entity_) + ": a second " + quoted(word) + "; keep one");
        given_.push_back(word);
        return word;
    }

    void require(std::initializer_list<std::string_view> names) const {
        for (const std::string_view name : names)
            if (!among(given_, name))
                tokens_.refuse(std::string(entity_) + ": " + quoted(name) + " is missing; it has " +
                               listed(names_));
    }

private:
    static bool among(std::span<const std::string_view> names, std::string_view word) {
        return std::ranges::find(names, word) != names.end();
    }
    static std::string listed(std::span<const std::string_view> names) {
        std::string text;
        for (const std::string_view name : names)
            text += (text.empty() ? "" : ", ") + std::string(name);
        return text;
    }

    Tokens& tokens_;
    std::string_view entity_;
    std::span<const std::string_view> names_;
    std::vector<std::string_view> given_;
};

}  // namespace rayshoot

#include "data/tokens.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace rayshoot {

namespace {

bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
    return word;
}

template <class Number>
std::errc parse(std::string_view word, Number& value) {
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return stop == end ? error : std::errc::invalid_argument;
}

/// A number that no normal float can hold: too small is a zero, too large is none.
std::optional<float> parse_extreme(std::string_view word) {
    double wide = 0;
    if (parse(word, wide) == std::errc{}) {
        if (std::abs(wide) > std::numeric_limits<float>::max()) return std::nullopt;
        return static_cast<float>(wide);
    }
    const bool small = word.find("e-") != word.npos || word.find("E-") != word.npos;
    return small ? std::optional(0.0f) : std::nullopt;
}

}  // namespace

std::optional<float> parse_number(std::string_view word) {
    word = without_plus(word);
    float value = 0;
    const std::errc error = parse(word, value);
    if (error == std::errc::result_out_of_range) return parse_extreme(word);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> parse_integer(std::string_view word) {
    std::int64_t value = 0;
    if (parse(without_plus(word), value) != std::errc{}) return std::nullopt;
    return value;
}

std::string quoted(std::string_view word) {
    constexpr std::size_t shown = 40;  // characters: a binary file is one long word
    std::string text = "'";
    text += word.substr(0, shown);
    text += word.size() > shown ? "...'" : "'";
    return text;
}

Tokens::Tokens(std::string_view text, std::string name, Lexis lexis)
    : text_(text), name_(std::move(name)), lexis_(lexis) {}

bool Tokens::ends_word(char c) const {
    return blank(c) || lexis_.comments.find(c) != std::string_view::npos ||
           lexis_.alone.find(c) != std::string_view::npos;
}

std::size_t Tokens::word_end(std::size_t begin) const {
    std::size_t end = begin;
    while (end < text_.size() && !ends_word(text_[end])) ++end;
    const bool alone = end == begin && end < text_.size();  // blanks and comments were skipped
    return alone ? end + 1 : end;
}

void Tokens::skip_blanks() {
    for (; position_ < text_.size(); ++position_) {
        const char c = text_[position_];
        if (lexis_.comments.find(c) != std::string_view::npos) {
            position_ = text_.find('\n', position_);
            if (position_ == std::string_view::npos) position_ = text_.size();
            if (position_ == text_.size()) return;
        } else if (!blank(c)) {
            return;
        }
        if (text_[position_] == '\n') ++line_;
    }
}

std::string_view Tokens::next() {
    skip_blanks();
    const std::size_t begin = position_;
    position_ = word_end(begin);
    word_line_ = line_;
    return text_.substr(begin, position_ - begin);
}

std::string_view Tokens::peek() {
    skip_blanks();
    return text_.substr(position_, word_end(position_) - position_);
}

void Tokens::skip_line() {
    if (line_ != word_line_) return;
    position_ = text_.find('\n', position_);
    if (position_ == std::string_view::npos) position_ = text_.size();
}

float Tokens::number(std::string_view use) {
    const std::string_view word = next();
    const auto value = parse_number(word);
    if (!value) refuse_word(word, use);
    return *value;
}

vec3 Tokens::three(std::string_view use) {
    const float x = number(use), y = number(use), z = number(use);
    return {x, y, z};
}

std::int64_t Tokens::integer(std::string_view use, std::int64_t lowest, std::int64_t highest) {
    const std::string_view word = next();
    const auto value = parse_integer(word);
    if (!value) refuse_word(word, use);
    if (*value < lowest || *value > highest)
        refuse(std::string(word) + " is out of range: " + std::string(use) + ", from " +
               std::to_string(lowest) + " to " + std::to_string(highest));
    return *value;
}

void Tokens::refuse_word(std::string_view word, std::string_view use) const {
    const std::string what = word.empty() ? "the file ends" : quoted(word) + " stands";
    refuse(what + " where a number is expected: " + std::string(use));
}

void Tokens::refuse(const std::string& message) const {
    throw std::invalid_argument(where() + ": " + message);
}

}  // namespace rayshoot

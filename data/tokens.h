#pragma once

#include "accel/core/vec.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

/// Text files as words between blanks, each with its line.
namespace rayshoot {

/// The whole word as a finite number; nothing when it is not one or too large for a float.
std::optional<float> parse_number(std::string_view word);
std::optional<std::int64_t> parse_integer(std::string_view word);

/// For errors: in quotes, shortened where it is long.
std::string quoted(std::string_view word);

/// Which characters are more than letters of words.
struct Lexis {
    std::string_view comments = "#";  ///< each begins a comment up to the end of the line
    std::string_view alone = "";      ///< each is a word by itself
};

class Tokens {
public:
    /// `name`: the file's, for errors.
    Tokens(std::string_view text, std::string name, Lexis lexis = {});

    /// The next word, or an empty one at the end of the file.
    std::string_view next();
    std::string_view peek();
    /// Leaves out what remains of the line that the last word stands on.
    void skip_line();

    /// The next word as a number; `use` says in an error what it should have been.
    float number(std::string_view use);
    vec3 three(std::string_view use);
    std::int64_t integer(std::string_view use, std::int64_t lowest, std::int64_t highest);

    /// Bytes that have not been read.
    std::size_t remaining() const { return text_.size() - position_; }
    /// "name:line", line being that of the last word.
    std::string where() const { return name_ + ":" + std::to_string(word_line_); }
    /// Throws std::invalid_argument: "name:line: message", line being that of the last word.
    [[noreturn]] void refuse(const std::string& message) const;

private:
    bool ends_word(char c) const;
    std::size_t word_end(std::size_t begin) const;
    void skip_blanks();
    [[noreturn]] void refuse_word(std::string_view word, std::string_view use) const;

    std::string_view text_;
    std::string name_;
    Lexis lexis_;
    std::size_t position_ = 0;
    std::size_t line_ = 1;       ///< at position_
    std::size_t word_line_ = 1;  ///< of the last word
};

}  // namespace rayshoot

#pragma once

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace rayshoot {

/// What std::invalid_argument says when `action` throws it; empty when it does not throw.
template <class Action>
std::string message_of(Action&& action) {
    try {
        action();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

inline testing::AssertionResult contains(const std::string& text, const std::string& part) {
    if (!part.empty() && text.find(part) != text.npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "'" << text << "' does not contain '" << part << "'";
}

}  // namespace rayshoot

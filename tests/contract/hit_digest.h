#pragma once

#include "tests/contract/contract.h"

/// One number for all answers of the kit's scenes and rays: the same for every compiler, preset and
/// machine.
namespace rayshoot::contract {

/// SHA-256 of every answer of `spec` to every ray, NaN-free and bit for bit.
std::string hit_digest(const Catalogue& catalogue, const std::string& spec,
                       const std::vector<Case>& cases);

/// SHA-256 of the scenes' bounds and of all rays: when answers differ, were the questions the same?
std::string question_digest(const std::vector<Case>& cases);

}  // namespace rayshoot::contract

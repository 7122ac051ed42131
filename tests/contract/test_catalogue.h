#pragma once

#include "lazy_tree_entry.h"
#include "picky_entry.h"
#include "test_tree_entry.h"
#include "wary_entry.h"

/// The built-in catalogue with the test-only structures added, as a program of one's own does it.
namespace rayshoot::contract {

inline Catalogue test_catalogue() {
    Catalogue catalogue = built_in_catalogue();
    for (const auto entry : {lazy_tree_entry, picky_entry, test_tree_entry, wary_entry})
        catalogue.push_back(entry());
    return catalogue;
}

}  // namespace rayshoot::contract

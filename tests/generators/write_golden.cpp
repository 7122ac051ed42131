#include "tests/generators/golden.h"

#include <iostream>

/// Prints what digests.csv holds.
int main() {
    std::cout << rayshoot::golden_header << '\n';
    for (const std::string& scene : rayshoot::golden_scenes())
        std::cout << rayshoot::golden_line(scene) << '\n';
}

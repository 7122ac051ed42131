#include <cinttypes>
#include <cstdio>

#include "tests/core/digest.h"

/// Prints a line per kind: the digests that digest_test.cpp expects.
int main() {
    using namespace rayshoot;
    const auto print = [](const char* name, PrimitiveKind kind, Precision precision) {
        std::printf("%-20s 0x%016" PRIx64 "\n", name, hit_digest(kind, precision));
    };
    print("triangle", PrimitiveKind::triangle, Precision::standard);
    print("watertight triangle", PrimitiveKind::triangle, Precision::watertight);
    print("sphere", PrimitiveKind::sphere, Precision::standard);
    print("frustum", PrimitiveKind::frustum, Precision::standard);
    print("polygon", PrimitiveKind::polygon, Precision::standard);
}

#pragma once

#include "accel/core/catalogue.h"

namespace rayshoot {

/// A scene that every kind of structure can be built over, for asking about the structure itself.
class Specimen {
public:
    Specimen();
    BuildInput input() const { return {geometry_, view_, lights_, nullptr}; }

private:
    Geometry geometry_;
    std::vector<Light> lights_;
    View view_;
};

/// Throws std::invalid_argument, saying what exists, for a name, option or value there is not:
/// before the scene is loaded, not after.
void require_spec(const Catalogue& catalogue, const std::string& spec);

}  // namespace rayshoot

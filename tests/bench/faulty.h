#pragma once

#include "accel/core/catalogue.h"

namespace rayshoot {

/// What a planted structure does wrong, on every fiftieth hit; else it answers as the bvh does.
enum class Fault { none, wrong_t, missed_hit, wrong_primitive };

/// The built-in catalogue and `sound`, `wrong` (t), `mistaken` (primitive), `blind` (hits), all of
/// them exact, `off` (hits) and `tolerant` (t by one ulp), which declare tolerance.
///
/// And `lanes`: a bvh that claims as many bytes as it was allowed threads to be built with.
Catalogue faulty_catalogue();

}  // namespace rayshoot

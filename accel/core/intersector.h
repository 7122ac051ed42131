#pragma once

#include "accel/core/counters.h"
#include "accel/core/ray.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The one interface: an Accel is immutable and shared, a Session answers for one lane of work.
namespace rayshoot::inline RAYSHOOT_ISA {

enum class Mode : std::uint8_t { timing, counting };

/// What a structure is made of. Not measured is nullopt, never 0.
struct Footprint {
    std::optional<std::uint64_t> interior = std::nullopt;      ///< [N_IN] interior nodes
    std::optional<std::uint64_t> leaves = std::nullopt;        ///< [N_V] leaves or elementary cells
    std::optional<std::uint64_t> empty_leaves = std::nullopt;  ///< [N_EV]
    std::optional<std::uint64_t> references =
        std::nullopt;                                   ///< [N_OIV] primitive references in leaves
    std::optional<std::uint64_t> depth = std::nullopt;  ///< of the deepest leaf; the root's is 0
    std::optional<std::uint64_t> bytes =
        std::nullopt;         ///< the structure without the geometry it refers to
    std::string remark = {};  ///< what its builder has to say: that it stopped at a bound, say
};

/// Scratch, caches, lazily built parts, counters. Not re-entrant: one lane at a time.
class Session {
public:
    virtual ~Session() = default;

    /// Nearest hit of each ray, hits[i] for rays[i]. Returns the indices declined, ascending, valid
    /// until the next call; what hits[] holds for those is unspecified.
    virtual std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) = 0;
    /// occluded[i] = 1 iff any primitive is hit by rays[i], else 0; declines as above.
    virtual std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                                    std::span<std::uint8_t> occluded) = 0;

    /// What this session counted for rays of a kind; null when timing, or where the structure
    /// cannot count. For a composition: the sums over its members, `declined` being what none
    /// answered.
    virtual const Counters* counters(RayKind kind) const = 0;
    /// The sessions of a composition's members, in order; empty for a lone structure.
    virtual std::span<const std::unique_ptr<Session>> members() const { return {}; }
    /// Bytes held by scratch, caches and lazily built parts.
    virtual std::size_t bytes() const { return 0; }
};

/// Must outlive its sessions, as the geometry, lights and hierarchy it was built from must outlive
/// it.
class Accel {
public:
    virtual ~Accel() = default;

    virtual std::unique_ptr<Session> open(Mode mode) const = 0;
    virtual Footprint footprint() const = 0;
    /// Whether rays of this kind may be answered at all; a complete structure always says true.
    virtual bool serves(Query query, RayKind kind) const = 0;
    /// The spec it was built from, in canonical form: a row name.
    virtual const std::string& spec() const = 0;
    virtual bool complete() const = 0;
    /// Answers are equal, but counts depend on earlier batches of the session.
    virtual bool remembers() const = 0;
    /// The members of a composition, in order; empty for a lone structure.
    virtual std::span<const std::unique_ptr<Accel>> members() const { return {}; }
};

}  // namespace rayshoot::inline RAYSHOOT_ISA

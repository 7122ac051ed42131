#pragma once

#include "accel/core/answers.h"
#include "accel/core/promise.h"
#include "accel/core/structure.h"

#include <algorithm>
#include <cassert>

/// The session of an author's structure: everything around the traversal that all structures share.
namespace rayshoot::inline RAYSHOOT_ISA {

template <Structure S, Counter C>
class StructureSession final : public Session {
public:
    StructureSession(const S& structure, const BuildInput& input)
        : structure_(structure), input_(input) {
        declined_.reserve(max_batch);
    }

    std::span<const std::uint32_t> closest(const RayBatch& batch, std::span<Hit> hits) override {
        return answer<Query::closest>(batch, hits);
    }
    std::span<const std::uint32_t> occluded(const RayBatch& batch,
                                            std::span<std::uint8_t> occluded) override {
        return answer<Query::occluded>(batch, occluded);
    }
    const Counters* counters(RayKind kind) const override {
        if constexpr (C::counts) return &counters_[static_cast<std::size_t>(kind)];
        return nullptr;
    }
    std::size_t bytes() const override {
        if constexpr (requires { scratch_.bytes(); }) return scratch_.bytes();
        return 0;
    }

private:
    template <Query Q>
    std::span<const std::uint32_t> answer(const RayBatch& batch, std::span<Answer<Q>> answers) {
        assert(batch.rays.size() <= max_batch && answers.size() >= batch.rays.size());
        assert(batch.source.empty() || batch.source.size() == batch.rays.size());
        assert_promises_kept(input_, batch);
        declined_.clear();
        C count = policy(batch.kind);
        if (!serves(structure_, Q, batch.kind) || (NeedsSource<S> && batch.source.empty())) {
            for (std::uint32_t i = 0; i < batch.rays.size(); ++i) declined_.push_back(i);
        } else if constexpr (AnswersOneRay<S>) {
            answer_singly<Q>(batch, answers, count);
        } else {
            answer_together<Q>(batch, answers, count);
        }
        count(Event::declined, declined_.size());
        count(Event::ray, batch.rays.size() - declined_.size());
        return declined_;
    }

    template <Query Q>
    void answer_singly(const RayBatch& batch, std::span<Answer<Q>> answers, C& count) {
        for (std::size_t i = 0; i < batch.rays.size(); ++i) {
            Ray ray = batch.rays[i];
            if (!answerable(ray)) [[unlikely]] {
                answers[i] = {};
                continue;
            }
            ray.time = shutter_time(ray.time);
            Hit hit = nothing_yet(ray);
            const Source source = batch.source.empty() ? Source{} : batch.source[i];
            if (!structure_.template one<Q>(ray, source, hit, scratch_, count)) {
                declined_.push_back(static_cast<std::uint32_t>(i));
                continue;
            }
            if constexpr (C::counts) count(Event::hit, hit.primitive != no_primitive);
            answers[i] = conclude<Q>(hit);
        }
    }

    template <Query Q>
    void answer_together(const RayBatch& batch, std::span<Answer<Q>> answers, C& count) {
        const bool plain = std::all_of(batch.rays.begin(), batch.rays.end(), [](const Ray& ray) {
            return answerable(ray) & (ray.time >= 0) & (ray.time <= 1);
        });
        if (!plain) [[unlikely]]
            compact<Q>(batch, answers);
        Answers<Q> out(answers, declined_, plain ? std::span<const std::uint32_t>{} : index_of_);
        const RayBatch asked =
            plain ? batch
                  : RayBatch{batch.kind, batch.depth, rays_,
                             batch.source.empty() ? std::span<const Source>{} : source_};
        structure_.template many<Q>(asked, out, scratch_, count);
        if constexpr (C::counts) count(Event::hit, out.hits());
    }

    /// Sets aside the rays that have no answer, and clamps the times of the others.
    template <Query Q>
    void compact(const RayBatch& batch, std::span<Answer<Q>> answers) {
        rays_.clear();
        source_.clear();
        index_of_.clear();
        for (std::size_t i = 0; i < batch.rays.size(); ++i) {
            if (!answerable(batch.rays[i])) {
                answers[i] = {};
                continue;
            }
            rays_.push_back(batch.rays[i]);
            rays_.back().time = shutter_time(rays_.back().time);
            if (!batch.source.empty()) source_.push_back(batch.source[i]);
            index_of_.push_back(static_cast<std::uint32_t>(i));
        }
    }

    C policy(RayKind kind) {
        if constexpr (C::counts) return C{&counters_[static_cast<std::size_t>(kind)]};
        else return C{};
    }

    const S& structure_;
    const BuildInput& input_;
    typename S::Scratch scratch_{};
    std::array<Counters, ray_kinds> counters_{};
    std::vector<std::uint32_t> declined_, index_of_;
    std::vector<Ray> rays_;
    std::vector<Source> source_;
};

template <Structure S, Counter C>
std::unique_ptr<Session> open_session(const S& structure, const BuildInput& input) {
    return std::make_unique<StructureSession<S, C>>(structure, input);
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

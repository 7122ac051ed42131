#pragma once

#include "accel/core/answers.h"
#include "accel/core/catalogue.h"
#include "accel/core/leaves.h"
#include "accel/core/options.h"

/// What an author writes, spelt out as concepts, and the Accel made of it.
namespace rayshoot::inline RAYSHOOT_ISA {

/// A structure says what it is called, in a word and in a line.
template <class S>
concept HasName = requires {
    { S::name } -> std::convertible_to<std::string_view>;
    { S::summary } -> std::convertible_to<std::string_view>;
};
/// ... whether it answers every ray, and whether its counts depend on earlier batches.
template <class S>
concept HasTraits = requires {
    { S::complete } -> std::convertible_to<bool>;
    { S::remembers } -> std::convertible_to<bool>;
};
/// ... which options it takes, and which specs the contract kit is to run.
template <class S>
concept HasOptions = requires {
    {std::span<const OptionInfo>(S::options)};
    {std::span<const std::string_view>(S::configurations)};
};
/// ... is built from the input and its options,
template <class S>
concept IsBuilt = std::constructible_from<S, const BuildInput&, const Options&>;
/// ... says what it is made of,
template <class S>
concept HasFootprint = requires(const S& s) {
    { s.footprint() } -> std::same_as<Footprint>;
};
/// ... has a Scratch, one per session,
template <class S>
concept HasScratch = std::default_initializable<typename S::Scratch>;
/// ... and answers rays one by one: false means declined;
template <class S>
concept AnswersOneRay = requires(const S& s, const Ray& ray, Source source, Hit& hit,
                                 typename S::Scratch& scratch, Silent& silent, Tally& tally) {
    { s.template one<Query::closest>(ray, source, hit, scratch, silent) } -> std::same_as<bool>;
    { s.template one<Query::occluded>(ray, source, hit, scratch, tally) } -> std::same_as<bool>;
};
/// or whole batches.
template <class S>
concept AnswersBatches = requires(const S& s, const RayBatch& batch, Answers<Query::closest>& hits,
                                  Answers<Query::occluded>& bits, typename S::Scratch& scratch,
                                  Silent& silent, Tally& tally) {
    s.template many<Query::closest>(batch, hits, scratch, silent);
    s.template many<Query::occluded>(batch, bits, scratch, tally);
};

template <class S>
concept Structure = HasName<S> && HasTraits<S> && HasOptions<S> && IsBuilt<S> && HasFootprint<S> &&
    HasScratch<S> &&(AnswersOneRay<S> || AnswersBatches<S>);

/// Partial structures may say which rays they take at all; asked once per batch.
template <class S>
concept Selective = requires(const S& s) {
    { s.serves(Query::closest, RayKind::camera) } -> std::same_as<bool>;
};
/// ... or that they cannot answer without knowing where a ray comes from; of a batch without
/// sources every ray is then declined for them.
template <class S>
concept NeedsSource = requires {
    requires S::needs_source;
};
/// A structure may refuse a geometry before it is built.
template <class S>
concept Refusing = requires(const Geometry& geometry) {
    { S::refuses(geometry) } -> std::same_as<std::string>;
};

template <Structure S>
bool serves(const S& structure, Query query, RayKind kind) {
    if constexpr (Selective<S>) return structure.serves(query, kind);
    return true;
}

/// Defined in session.h and instantiated once per counting policy, each in a file of its own: both
/// in one file cost the silent code 13 % more instructions.
template <Structure S, Counter C>
std::unique_ptr<Session> open_session(const S& structure, const BuildInput& input);

/// An author's structure behind the interface.
template <Structure S>
class StructureAccel final : public Accel {
public:
    StructureAccel(const BuildInput& input, const Options& options, std::string spec)
        : input_(input), structure_(input_, options), spec_(std::move(spec)) {}

    std::unique_ptr<Session> open(Mode mode) const override {
        return mode == Mode::timing ? open_session<S, Silent>(structure_, input_)
                                    : open_session<S, Tally>(structure_, input_);
    }
    Footprint footprint() const override { return structure_.footprint(); }
    bool serves(Query query, RayKind kind) const override {
        return rayshoot::serves(structure_, query, kind);
    }
    const std::string& spec() const override { return spec_; }
    bool complete() const override { return S::complete; }
    bool remembers() const override { return S::remembers; }

private:
    BuildInput input_;
    S structure_;
    std::string spec_;
};

/// A catalogue line for a structure.
template <class S>
StructureEntry make_entry(Agreement agreement) {
    static_assert(HasName<S>, "a structure has a static name and summary");
    static_assert(HasTraits<S>, "a structure says whether it is complete and whether it remembers");
    static_assert(HasOptions<S>, "a structure lists its options and configurations");
    static_assert(IsBuilt<S>, "a structure is built from (const BuildInput&, const Options&)");
    static_assert(HasFootprint<S>, "a structure reports its Footprint");
    static_assert(HasScratch<S>, "a structure has a default-constructible Scratch");
    static_assert(AnswersOneRay<S> || AnswersBatches<S>,
                  "a structure answers rays by one<Query>(...) or batches by many<Query>(...)");
    return {.name = S::name,
            .agreement = agreement,
            .complete = S::complete,
            .remembers = S::remembers,
            .options = S::options,
            .configurations = S::configurations,
            .summary = S::summary,
            .build = [](const BuildInput& input, const Options& options,
                        std::string spec) -> std::unique_ptr<Accel> {
                return std::make_unique<StructureAccel<S>>(input, options, std::move(spec));
            },
            .refuses = [](const Geometry& geometry) -> std::string {
                if constexpr (Refusing<S>) return S::refuses(geometry);
                return {};
            }};
}

}  // namespace rayshoot::inline RAYSHOOT_ISA

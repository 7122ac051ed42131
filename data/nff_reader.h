#pragma once

#include "data/animation.h"
#include "data/movement.h"
#include "data/nff_shapes.h"
#include "data/scene.h"
#include "data/tokens.h"

#include <stdexcept>
#include <utility>

/// How read_nff works: one member function per entity. nff.cpp has those of NFF itself,
/// nff_extension.cpp ours.
namespace rayshoot {

class NffReader {
public:
    NffReader(std::string_view text, const std::string& name, const Frame& frame)
        : tokens_(text, name), frame_(frame), frames_(frames_of(frame, 1, name)) {}
    Scene read(Precision precision) &&;

private:
    void entity(std::string_view keyword);
    void background();
    void view();
    void light();
    void sphere();
    void cone();
    void polygon(const Outline& outline);
    void finish_lights();

    /// Whether the keyword is one of the extension's, which then has been read.
    bool extension(std::string_view keyword);
    void physical_light();
    void show(const Light& light);
    void lens();
    void shutter();
    void rest();
    void finish_extension();
    /// The motion of what is added now.
    std::uint32_t motion();
    Exposure exposure();

    bool emitting() const;
    void paint_with(const Material& material);
    template <class Add>
    void add(Add&& add_to_builder);

    Tokens tokens_;
    GeometryBuilder builder_;
    Scene scene_;
    std::uint32_t surface_ = 0;            ///< of what follows: index into the scene's materials
    std::vector<std::size_t> uncoloured_;  ///< lights without a colour of their own
    bool has_view_ = false;

    Frame frame_;
    double frames_;            ///< of the whole animation
    Exposure of_frame_{0, 1};  ///< when the shutter is open, as shares of a frame's time
    bool exposed_ = false;     ///< a motion has used it
    Movement objects_, camera_;
    std::uint32_t motion_ = no_motion;  ///< of objects_, once something has moved with it
    std::vector<std::pair<std::size_t, std::uint32_t>> visible_;  ///< lights and their primitives
};

/// Adds a primitive by a call that may throw, under the surface in force.
template <class Add>
void NffReader::add(Add&& add_to_builder) {
    try {
        add_to_builder();
    } catch (const std::invalid_argument& error) {
        tokens_.refuse(error.what());
    }
    if (scene_.materials.empty()) scene_.materials.emplace_back();
    scene_.material_of.push_back(surface_);
}

}  // namespace rayshoot

#pragma once

#include <optional>
#include <stdexcept>
#include <string>

/// When in an animation a scene is loaded.
namespace rayshoot {

/// Which picture of an animation, and how long it is exposed.
struct Frame {
    int number = 0;  ///< 0 to of - 1
    int of = 0;      ///< frames of the whole animation; 0: as the file says
    std::optional<double> shutter =
        std::nullopt;  ///< share of a frame's time, 0 to 1; none: as the file says
};
inline constexpr int most_frames = 1'000'000;

/// The number of frames that `frame` is one of, `usual` where it does not say. Throws
/// std::invalid_argument, with the file's name, where there is no such frame.
inline int frames_of(const Frame& frame, int usual, const std::string& name) {
    const int frames = frame.of > 0 ? frame.of : usual;
    if (frame.number < frames) return frames;
    throw std::invalid_argument(name + ": frame=" + std::to_string(frame.number) +
                                ": the animation has " + std::to_string(frames) +
                                (frames == 1 ? " frame" : " frames, numbered from 0") +
                                "; frames=N divides it otherwise");
}

/// From the shutter's opening to its closing, in the file's own time. Readers evaluate motions at
/// both; they are times 0 and 1 of the scene's Motions and rays.
struct Exposure {
    double open = 0, close = 1;

    double middle() const { return 0.5 * (open + close); }
};

}  // namespace rayshoot

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "snug/base/message.h"
#include "snug/base/vec.h"

namespace snug {

constexpr std::size_t kMostZones = 100;   // of an item
constexpr std::size_t kMostBalls = 2000;  // of a zone
constexpr double kMostKeepOff = 1000;     // mm

/// A place on an item that foam keeps away from, or may press on so much at most: the surface that lies in
/// any of its balls, or in one separate part. It belongs to the object and moves with it.
struct Zone {
    /// In the coordinates of the object's file, mm.
    struct Ball {
        Vec3d centre;
        double radius_mm = 0;
        friend bool operator==(const Ball&, const Ball&) = default;
    };
    std::vector<Ball> balls;
    int part = 0;                     ///< as `snug inspect` numbers them, from 1; 0: none
    double keep_off_mm = 0;           ///< foam stays so far from it, all round; 0: no farther than elsewhere
    std::optional<double> press_kpa;  ///< what it bears, as a mean over 1 cm2; none: nothing is known
    bool loose = false;               ///< flaking, powdery, gilded: nothing may touch it
    friend bool operator==(const Zone&, const Zone&) = default;
};
using Zones = std::vector<Zone>;

/// "part=3:15" keeps 15 mm off part 3, "10,20,30,25:15:press=2kPa" off what lies within 25 mm of a point;
/// more balls follow by more numbers, more zones behind a comma. None where the text is something else.
[[nodiscard]] std::optional<Zones> typed_zones(std::string_view text);
/// What typed_zones() reads back; none where there are no zones.
[[nodiscard]] std::optional<std::string> text_of(const Zones& zones);

/// What is wrong with the first that is wrong, numbered from 1.
[[nodiscard]] std::optional<Message> problem_of(const Zones& zones);

}  // namespace snug

#pragma once

#include "snug/formats/mesh_files.h"
#include "snug/picture/relief.h"

namespace snug {

/// The colours of a foam half's faces: tops light, right walls dark, deep floors and walls darker.
class FoamTones {
  public:
    FoamTones(const Relief& relief, Color foam);
    [[nodiscard]] Color of(const Face& face) const;

  private:
    const Relief& relief_;
    Color tones_[3];  // by FaceSide
    Color deep_;
};

}  // namespace snug

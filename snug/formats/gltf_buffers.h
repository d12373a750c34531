#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "snug/base/bytes.h"
#include "snug/base/result.h"
#include "snug/formats/gltf_container.h"
#include "snug/formats/scene_tools.h"

namespace snug::gltf {

/// A buffer view's bytes; `stride` 0: elements lie side by side.
struct View {
    Bytes bytes;
    std::uint64_t stride = 0;
};

/// The bytes that a scene's JSON speaks of: in its own chunk, as text, in files beside it, packed by meshopt.
/// Each is read once and only when it is asked for, and tried once where it cannot be had. What is given out
/// lives as long as this and the file.
class Buffers {
  public:
    Buffers(const Container& file, const SceneTools& tools, std::uint64_t file_bytes)
        : scene_(file.json),
          binary_(file.binary),
          tools_(tools),
          meshopt_required_(names(field(scene_, "extensionsRequired"), "EXT_meshopt_compression")),
          file_bytes_(file_bytes),
          read_(file_bytes) {}

    [[nodiscard]] Result<View> view(std::uint64_t index);
    /// How many bytes stand behind the scene: of its file, of those beside it, and as they were unpacked.
    [[nodiscard]] std::uint64_t bytes_read() const { return read_; }
    /// Counts `steps` of work that the JSON asks for; fails where it asks for far more than its size allows.
    [[nodiscard]] Result<void> spend(std::uint64_t steps);

  private:
    [[nodiscard]] Result<Bytes> buffer(std::uint64_t index);
    [[nodiscard]] Result<Bytes> find_buffer(std::uint64_t index);
    [[nodiscard]] Result<Bytes> beside(const std::string& uri);
    /// `of`: a buffer view, or the object of an extension that names bytes in the same way.
    [[nodiscard]] Result<Bytes> slice(const Json& of);
    [[nodiscard]] Result<View> packed_view(std::uint64_t index, const Json& extension);
    [[nodiscard]] Result<FileBytes> unpacked(const Json& extension);

    const Json& scene_;
    Bytes binary_;
    const SceneTools& tools_;
    bool meshopt_required_;
    std::uint64_t file_bytes_, read_, spent_ = 0;
    std::uint64_t unpacked_bytes_ = 0;
    std::map<std::uint64_t, Result<Bytes>> known_;
    std::map<std::string, FileBytes> beside_;   ///< by their names
    std::map<std::uint64_t, FileBytes> texts_;  ///< of buffers that stand in the JSON
    std::map<std::uint64_t, Result<FileBytes>> unpacked_;
};

}  // namespace snug::gltf

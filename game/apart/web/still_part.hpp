// SPDX-License-Identifier: MIT
#pragma once

#include <kodo_draw/mesh.hpp>

#include <cstddef>
#include <span>
#include <vector>

namespace apart {

/// Finds the triangles at the beginning of a picture that stay the same from frame to frame, such
/// as a backdrop and blocks that nothing moves. A renderer keeps a picture of them and paints the
/// others over it: without a graphics card each pixel costs time.
class StillPart {
public:
    /// Counts of vertices from the first one on.
    struct Plan {
        std::size_t keep = 0; // to be drawn into the kept picture, if not 0
        std::size_t kept = 0; // that the kept picture then has
    };

    /// The triangles of the next frame, whose picture has so many pixels.
    Plan next(std::span<const kodo_draw::MeshVertex> vertices,
              std::span<const kodo_draw::MeshRun> runs, kodo_draw::Size pixels);
    /// The kept picture is lost, or has another size.
    void forget() { kept_ = 0; }

private:
    std::vector<kodo_draw::MeshVertex> vertices_; // of the last frame
    std::vector<kodo_draw::MeshRun> runs_;
    std::size_t kept_ = 0;
    std::size_t least_ = 0; // that stayed the same in the present window of frames
    int frames_ = 0;        // of it
};

/// Where a picture has been painted over, in tiles.
class TouchedTiles {
public:
    /// Of a picture of this size: all tiles.
    void touchAll(kodo_draw::Size pixels);
    void touch(std::span<const kodo_draw::MeshVertex> triangles);
    void clear() { touched_.assign(touched_.size(), false); }
    /// Two triangles for each row of tiles that are touched.
    std::vector<kodo_draw::MeshVertex> quads() const;

private:
    std::size_t across_ = 0;
    std::size_t down_ = 0;
    std::vector<bool> touched_; // row by row
};

} // namespace apart

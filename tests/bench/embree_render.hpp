// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>

#include "keikan/image/image.hpp"
#include "keikan/scene/camera.hpp"
#include "keikan/scene/mesh.hpp"

namespace keikan::bench {

/// The same faces, seen by rays: Embree 3 with its default build quality, every face cut into a fan of
/// triangles, single precision relative to the camera.
class EmbreeRender {
  public:
    /// Copies the triangles into Embree's buffers; no hierarchy yet.
    EmbreeRender(const Geometry& geometry, const Camera& camera, int threads);
    ~EmbreeRender();
    EmbreeRender(const EmbreeRender&) = delete;
    EmbreeRender& operator=(const EmbreeRender&) = delete;

    /// Builds the hierarchy anew from the buffers (rtcCommitScene).
    void build();

    /// Traces side * side jittered primary rays a pixel, in packets of eight neighbouring pixels
    /// (rtcIntersect8, coherent), and stores the mean of the colours of the faces hit: one table look-up a
    /// ray, no shading. Rows of packets are shared among the threads as keikan shares its own work.
    void trace(int side, Image<Rgb>& image) const;

  private:
    struct Working;
    std::unique_ptr<Working> working_;
};

}  // namespace keikan::bench

// SPDX-License-Identifier: Apache-2.0
#include "keikan/scan/projected_faces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "camera_space.hpp"
#include "hidden_backs.hpp"
#include "keikan/clip/orient2d.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan {
namespace {

/// A corner of a mesh as the camera sees it, made once for all faces that share it.
struct SeenCorner {
    CameraPoint camera;
    Point image;               ///< only where `behind` is not set
    std::uint8_t outside = 0;  ///< which borders of the view it lies beyond
    static constexpr std::uint8_t kLeft = 1, kRight = 2, kAbove = 4, kBelow = 8, kBehind = 16;
};

SeenCorner seen_corner(const Camera& camera, const glm::dvec3& world) {
    SeenCorner corner;
    corner.camera = camera_point(camera, world);
    if (!(corner.camera.depth >= camera.near_m)) {
        corner.outside = SeenCorner::kBehind;
        return corner;
    }
    corner.image = image_point(camera, corner.camera);
    if (corner.image.x < 0) corner.outside |= SeenCorner::kLeft;
    if (corner.image.x > camera.size.width) corner.outside |= SeenCorner::kRight;
    if (corner.image.y < 0) corner.outside |= SeenCorner::kAbove;
    if (corner.image.y > camera.size.height) corner.outside |= SeenCorner::kBelow;
    return corner;
}

/// Where the edge from corner `i` to corner `j` (positions in the mesh) crosses the near plane. Computed from
/// the smaller index to the larger, so that both faces at the edge get the same doubles.
Point near_crossing(const Camera& camera, const std::vector<SeenCorner>& corners, std::uint32_t i,
                    std::uint32_t j) {
    if (i > j) std::swap(i, j);
    const CameraPoint& from = corners[i].camera;
    const CameraPoint& to = corners[j].camera;
    const double t = (camera.near_m - from.depth) / (to.depth - from.depth);
    return image_point(camera, {from.u + t * (to.u - from.u), from.v + t * (to.v - from.v), camera.near_m});
}

/// Sign of the outline's area, exact: +1 where it turns from +x towards +y. 0 where it has none, and where
/// rounding left an outline whose corners turn both ways, `mixed` is set.
struct Turning {
    int sign = 0;
    bool mixed = false;
};

Turning turning(std::span<const Point> outline) {
    Turning result;
    for (std::size_t i = 2; i < outline.size(); ++i) {
        const int sign = static_cast<int>(orient2d(outline[0], outline[i - 1], outline[i]));
        if (sign == 0) continue;
        if (result.sign != 0 && sign != result.sign) result.mixed = true;
        if (result.sign == 0) result.sign = sign;
    }
    return result;
}

/// The projected faces of one run of faces of one object.
struct Projected {
    std::vector<Point> points;
    std::vector<std::uint32_t> sizes;
    std::vector<FaceId> id;
    std::vector<DepthPlane> plane;
};

class ObjectProjection {
  public:
    ObjectProjection(const Object& object, const Camera& camera, HiddenBacks backs)
        : mesh_(object.mesh),
          camera_(camera),
          without_backs_(backs == HiddenBacks::LeftOut && backs_are_hidden(object, camera)),
          corners_(mesh_.positions.size()) {
        parallel_ranges(corners_.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) corners_[i] = seen_corner(camera_, mesh_.positions[i]);
        });
    }

    void project(std::uint32_t face, FaceId id, Projected& out) const {
        const std::span<const std::uint32_t> corners = mesh_.face(face);
        if (corners.size() < 3) return;
        std::uint8_t all = 0xFF, any = 0;
        for (const std::uint32_t c : corners) {
            all &= corners_[c].outside;
            any |= corners_[c].outside;
        }
        if (all != 0) return;

        const std::size_t first = out.points.size();
        if (any & SeenCorner::kBehind) {
            append_cut_outline(corners, out.points);
        } else {
            for (const std::uint32_t c : corners) out.points.push_back(corners_[c].image);
        }
        const auto outline = std::span<const Point>(out.points).subspan(first);
        const Turning turns = turning(outline);
        // Counter-clockwise seen from outside is a negative turn where rows grow downwards.
        const bool back = without_backs_ && turns.sign > 0 && !turns.mixed;
        if (turns.sign == 0 || back || ((any & SeenCorner::kBehind) && outside_image(outline))) {
            out.points.resize(first);
            return;
        }
        out.sizes.push_back(static_cast<std::uint32_t>(out.points.size() - first));
        out.id.push_back(id);
        out.plane.push_back(depth_plane(corners));
    }

  private:
    void append_cut_outline(std::span<const std::uint32_t> corners, std::vector<Point>& points) const {
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::uint32_t i = corners[k], j = corners[(k + 1) % corners.size()];
            const bool i_behind = corners_[i].outside & SeenCorner::kBehind;
            const bool j_behind = corners_[j].outside & SeenCorner::kBehind;
            if (!i_behind) points.push_back(corners_[i].image);
            if (i_behind != j_behind) points.push_back(near_crossing(camera_, corners_, i, j));
        }
    }

    bool outside_image(std::span<const Point> outline) const {
        const auto all = [&](auto beyond) { return std::all_of(outline.begin(), outline.end(), beyond); };
        return all([](Point p) { return p.x < 0; }) || all([](Point p) { return p.y < 0; }) ||
               all([&](Point p) { return p.x > camera_.size.width; }) ||
               all([&](Point p) { return p.y > camera_.size.height; });
    }

    /// The face's plane by Newell's sum, which weighs all corners, taken from the corners' mean so that far
    /// positions do not cancel. A face whose plane passes through the eye, yet was not seen edge-on after
    /// rounding, gets the mean nearness of its corners.
    DepthPlane depth_plane(std::span<const std::uint32_t> corners) const {
        CameraPoint mean;
        for (const std::uint32_t c : corners) mean = mean + corners_[c].camera;
        mean = mean * (1.0 / static_cast<double>(corners.size()));
        CameraPoint normal;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const CameraPoint from = corners_[corners[k]].camera - mean;
            const CameraPoint to = corners_[corners[(k + 1) % corners.size()]].camera - mean;
            normal = normal + cross(from, to);
        }
        DepthPlane plane;
        if (camera_.kind == Camera::Kind::Perspective) {
            // On the plane n.P = n.mean; along the ray P = depth (x', y', 1), so 1/depth = n.(x', y', 1) /
            // n.mean.
            const double distance = dot(normal, mean);
            plane.a = normal.u / (camera_.focal_px * distance);
            plane.b = normal.v / (camera_.focal_px * distance);
            plane.c = normal.depth / distance - plane.a * camera_.centre_x - plane.b * camera_.centre_y;
        } else {
            // -depth = (n_u (u - u0) + n_v (v - v0)) / n_d - depth0.
            plane.a = normal.u / (camera_.focal_px * normal.depth);
            plane.b = normal.v / (camera_.focal_px * normal.depth);
            const Point at = image_point(camera_, mean);
            plane.c = -mean.depth - plane.a * at.x - plane.b * at.y;
        }
        if (std::isfinite(plane.a) && std::isfinite(plane.b) && std::isfinite(plane.c)) return plane;
        return {0, 0, camera_.nearness_at(std::max(mean.depth, camera_.near_m))};
    }

    const Mesh& mesh_;
    const Camera& camera_;
    const bool without_backs_;
    std::vector<SeenCorner> corners_;
};

/// Faces of a mesh that are projected by one call: enough to be worth it, few enough to share out.
constexpr std::size_t kFacesPerRun = 8192;

}  // namespace

ProjectedFaces project_faces(const Geometry& geometry, const Camera& camera, HiddenBacks backs) {
    KEIKAN_CHECK(geometry.first_face.size() == geometry.objects.size() + 1,
                 "first_face holds " << geometry.first_face.size() << " values for "
                                     << geometry.objects.size() << " objects");
    std::vector<Projected> runs;
    for (std::size_t o = 0; o < geometry.objects.size(); ++o) {
        const Mesh& mesh = geometry.objects[o].mesh;
        const ObjectProjection projection(geometry.objects[o], camera, backs);
        const std::size_t faces = mesh.face_count();
        const std::size_t first_run = runs.size();
        const std::size_t run_count = (faces + kFacesPerRun - 1) / kFacesPerRun;
        runs.resize(first_run + run_count);
        parallel_for(run_count, [&](std::size_t r) {
            Projected& run = runs[first_run + r];
            const std::size_t end = std::min(faces, (r + 1) * kFacesPerRun);
            for (std::size_t f = r * kFacesPerRun; f < end; ++f)
                projection.project(static_cast<std::uint32_t>(f),
                                   geometry.first_face[o] + static_cast<FaceId>(f), run);
        });
    }

    // The runs one after the other: ids rise, because objects and faces were taken in order.
    std::vector<std::size_t> face_at(runs.size() + 1, 0), point_at(runs.size() + 1, 0);
    for (std::size_t r = 0; r < runs.size(); ++r) {
        face_at[r + 1] = face_at[r] + runs[r].id.size();
        point_at[r + 1] = point_at[r] + runs[r].points.size();
    }
    KEIKAN_CHECK(point_at.back() < std::numeric_limits<std::uint32_t>::max(), "too many corners to number");
    ProjectedFaces faces;
    faces.points.resize(point_at.back());
    faces.begin.resize(face_at.back() + 1);
    faces.id.resize(face_at.back());
    faces.plane.resize(face_at.back());
    parallel_for(runs.size(), [&](std::size_t r) {
        const Projected& run = runs[r];
        std::copy(run.points.begin(), run.points.end(), faces.points.begin() + std::ptrdiff_t(point_at[r]));
        std::copy(run.id.begin(), run.id.end(), faces.id.begin() + std::ptrdiff_t(face_at[r]));
        std::copy(run.plane.begin(), run.plane.end(), faces.plane.begin() + std::ptrdiff_t(face_at[r]));
        std::size_t at = point_at[r];
        for (std::size_t f = 0; f < run.sizes.size(); ++f) {
            at += run.sizes[f];
            faces.begin[face_at[r] + f + 1] = static_cast<std::uint32_t>(at);
        }
    });
    return faces;
}

}  // namespace keikan

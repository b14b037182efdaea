// SPDX-License-Identifier: GPL-3.0-or-later
#include "world_truth.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <vector>

#include "crosscheck/certain_hiding.hpp"
#include "crosscheck/face_bins.hpp"
#include "crosscheck/sampling.hpp"
#include "keikan/support/check.hpp"
#include "keikan/support/parallel.hpp"

namespace keikan::truth {
namespace {

/// Along the camera's axes right, down, forward [m].
struct ExactCameraPoint {
    mpq_class u, v, depth;

    friend ExactCameraPoint operator+(const ExactCameraPoint& p, const ExactCameraPoint& q) {
        return {p.u + q.u, p.v + q.v, p.depth + q.depth};
    }
    friend ExactCameraPoint operator-(const ExactCameraPoint& p, const ExactCameraPoint& q) {
        return {p.u - q.u, p.v - q.v, p.depth - q.depth};
    }
    friend ExactCameraPoint operator*(const mpq_class& s, const ExactCameraPoint& p) {
        return {s * p.u, s * p.v, s * p.depth};
    }
};

ExactCameraPoint cross(const ExactCameraPoint& p, const ExactCameraPoint& q) {
    return {p.v * q.depth - p.depth * q.v, p.depth * q.u - p.u * q.depth, p.u * q.v - p.v * q.u};
}

ExactCameraPoint camera_point(const Camera& camera, const glm::dvec3& world) {
    const mpq_class x = mpq_class(world.x) - camera.position.x, y = mpq_class(world.y) - camera.position.y,
                    z = mpq_class(world.z) - camera.position.z;
    const auto along = [&](const glm::dvec3& axis) -> mpq_class {
        return mpq_class(axis.x) * x + mpq_class(axis.y) * y + mpq_class(axis.z) * z;
    };
    return {along(camera.right), along(camera.down), along(camera.forward)};
}

oracle::RationalPoint image_point(const Camera& camera, const ExactCameraPoint& p) {
    const bool perspective = camera.kind == Camera::Kind::Perspective;
    const mpq_class share = perspective ? mpq_class(camera.focal_px / p.depth) : mpq_class(camera.focal_px);
    const mpq_class x = camera.centre_x + share * p.u, y = camera.centre_y + share * p.v;
    oracle::RationalPoint point;
    mpz_lcm(point.w.get_mpz_t(), x.get_den_mpz_t(), y.get_den_mpz_t());
    point.x = x.get_num() * (point.w / x.get_den());
    point.y = y.get_num() * (point.w / y.get_den());
    return point;
}

/// With the depth plane w(x, y) = a x + b y + c.
void set_plane(oracle::RationalFace& face, const mpq_class& a, const mpq_class& b, const mpq_class& c) {
    mpz_lcm(face.unit.get_mpz_t(), a.get_den_mpz_t(), b.get_den_mpz_t());
    mpz_lcm(face.unit.get_mpz_t(), face.unit.get_mpz_t(), c.get_den_mpz_t());
    face.a = a.get_num() * (face.unit / a.get_den());
    face.b = b.get_num() * (face.unit / b.get_den());
    face.c = c.get_num() * (face.unit / c.get_den());
}

/// Nothing for a plane through the eye, or seen edge-on.
std::optional<oracle::RationalFace> plane_of(const std::vector<ExactCameraPoint>& corners,
                                             const Camera& camera) {
    ExactCameraPoint mean;
    for (const ExactCameraPoint& c : corners) mean = mean + c;
    mean = mpq_class(1, corners.size()) * mean;
    ExactCameraPoint normal;
    for (std::size_t k = 0; k < corners.size(); ++k)
        normal = normal + cross(corners[k] - mean, corners[(k + 1) % corners.size()] - mean);
    oracle::RationalFace face;
    if (camera.kind == Camera::Kind::Perspective) {
        const mpq_class distance = normal.u * mean.u + normal.v * mean.v + normal.depth * mean.depth;
        if (distance == 0) return std::nullopt;
        const mpq_class a = normal.u / (camera.focal_px * distance);
        const mpq_class b = normal.v / (camera.focal_px * distance);
        set_plane(face, a, b, normal.depth / distance - a * camera.centre_x - b * camera.centre_y);
        return face;
    }
    if (normal.depth == 0) return std::nullopt;
    const mpq_class a = normal.u / (camera.focal_px * normal.depth);
    const mpq_class b = normal.v / (camera.focal_px * normal.depth);
    set_plane(face, a, b,
              -mean.depth - a * (camera.centre_x + camera.focal_px * mean.u) -
                  b * (camera.centre_y + camera.focal_px * mean.v));
    return face;
}

std::size_t object_of(FaceId id, const Geometry& geometry) {
    const auto next = std::ranges::upper_bound(geometry.first_face, id);
    return static_cast<std::size_t>(next - geometry.first_face.begin() - 1);
}

using Coverage = std::map<std::size_t, mpq_class>;  ///< by object; the background after the last

Coverage coverage_of(const oracle::ExactAreas& exact, std::span<const std::size_t> objects,
                     std::size_t background) {
    Coverage coverage;
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (exact.areas[i] != 0) coverage[objects[i]] += exact.areas[i];
    coverage[background] += exact.background;
    return coverage;
}

struct Difference {
    double value = 0;
    std::size_t object = 0;
};

Difference largest_difference(const Coverage& from_world, const Coverage& from_doubles) {
    Coverage differences = from_world;
    for (const auto& [object, coverage] : from_doubles) differences[object] -= coverage;
    Difference largest;
    for (const auto& [object, difference] : differences) {
        const double value = std::abs(difference.get_d());
        if (value > largest.value) largest = {value, object};
    }
    return largest;
}

}  // namespace

oracle::RationalFace WorldFaces::operator[](std::size_t position) const {
    const FaceId id = projected_.id[position];
    const std::size_t object = object_of(id, geometry_);
    const Mesh& mesh = geometry_.objects[object].mesh;
    std::vector<ExactCameraPoint> corners;
    for (const std::uint32_t c : mesh.face(id - geometry_.first_face[object]))
        corners.push_back(camera_point(camera_, mesh.positions[c]));

    std::optional<oracle::RationalFace> face = plane_of(corners, camera_);
    if (!face) {  // as the projection does it, by the mean nearness: rounding made it visible
        face.emplace();
        set_plane(*face, 0, 0, projected_.plane[position].c);
    }
    face->id = id;
    const mpq_class near = camera_.near_m;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const ExactCameraPoint &p = corners[k], &q = corners[(k + 1) % corners.size()];
        if (p.depth >= near) face->outline.push_back(image_point(camera_, p));
        if ((p.depth >= near) != (q.depth >= near)) {
            const mpq_class t = (near - p.depth) / (q.depth - p.depth);
            face->outline.push_back(image_point(camera_, p + t * (q - p)));
        }
    }
    return *face;
}

WorldSummary rounding_of_projection(const ProjectedFaces& projected, const Geometry& geometry,
                                    const Camera& camera, std::uint64_t seed, std::uint64_t one_in) {
    const ImageSize size = camera.size;
    const crosscheck::FaceBins bins(projected, size);
    const crosscheck::CertainHiding hiding(projected);
    const WorldFaces world(projected, geometry, camera);
    const std::size_t background = geometry.objects.size();
    struct RowResult {
        std::uint64_t checked = 0;
        Difference largest;
        int column = 0;
    };
    std::vector<RowResult> rows(static_cast<std::size_t>(size.height));

    const auto check_row = [&](std::size_t row) {
        const int y = static_cast<int>(row);
        std::vector<crosscheck::FaceBins::Row> around;
        for (int beside = std::max(0, y - 1); beside <= std::min(size.height - 1, y + 1); ++beside)
            around.push_back(bins.row(beside));
        const crosscheck::FaceBins::Row own = bins.row(y);
        crosscheck::CertainHiding::Remaining remaining;
        std::unordered_map<std::uint32_t, oracle::RationalFace> of_row;  // each is in question in many pixels
        for (int x = 0; x < size.width; ++x) {
            const PixelIndex pixel{x, y};
            if (crosscheck::draw_of(seed, pixel) % one_in != 0) continue;
            hiding(pixel, own.at(x), remaining);
            if (remaining.decided()) continue;
            std::vector<std::uint32_t> asked;
            for (const crosscheck::FaceBins::Row& r : around)
                for (int beside = std::max(0, x - 1); beside <= std::min(size.width - 1, x + 1); ++beside)
                    asked.insert(asked.end(), r.at(beside).begin(), r.at(beside).end());
            std::ranges::sort(asked);
            asked.erase(std::unique(asked.begin(), asked.end()), asked.end());

            std::vector<FaceView> doubles;
            std::vector<const oracle::RationalFace*> exact;
            std::vector<std::size_t> objects;
            for (const std::uint32_t face : asked) {
                doubles.push_back(projected[face]);
                const auto [known, is_new] = of_row.try_emplace(face);
                if (is_new) known->second = world[face];
                exact.push_back(&known->second);
                objects.push_back(object_of(projected.id[face], geometry));
            }
            const Difference found = largest_difference(
                coverage_of(oracle::areas_by_rational_splitting(pixel, exact), objects, background),
                coverage_of(oracle::areas_by_rational_splitting(pixel, doubles, Nearness::ByDepth), objects,
                            background));
            ++rows[row].checked;
            if (found.value > rows[row].largest.value) {
                rows[row].largest = found;
                rows[row].column = x;
            }
        }
    };
    parallel_for(rows.size(), check_row);

    WorldSummary summary;
    summary.pixels = static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
    for (std::size_t row = 0; row < rows.size(); ++row) {
        summary.checked += rows[row].checked;
        if (rows[row].largest.value <= summary.max_difference) continue;
        summary.max_difference = rows[row].largest.value;
        summary.at = {rows[row].column, static_cast<int>(row)};
        const std::size_t object = rows[row].largest.object;
        summary.object = object == background ? std::string() : geometry.objects[object].name;
    }
    return summary;
}

}  // namespace keikan::truth

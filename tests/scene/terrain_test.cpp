// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/terrain.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>

#include "keikan/support/parallel.hpp"

using namespace keikan;

namespace {

HeightGrid grid_of(int columns, int rows, double (*height)(double, double)) {
    HeightGrid grid{columns, rows, {-50, 30}, {12.5, 8}, {}, 0};
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const glm::dvec2 at = grid.point(column, row);
            grid.heights.push_back(static_cast<float>(height(at.x, at.y)));
        }
    }
    return grid;
}

double rugged(double x, double y) {
    return 40 * std::sin(x / 17) * std::cos(y / 11) + x * y / 500;
}

}  // namespace

TEST_CASE("terrain_mesh: two triangles a cell, upwards, on the samples themselves", "[scene][terrain]") {
    const HeightGrid grid = grid_of(7, 5, rugged);
    const Mesh mesh = terrain_mesh(grid, 3);
    REQUIRE(mesh.face_count() == 2 * 6 * 4);
    REQUIRE(mesh.positions.size() == 35);
    CHECK(mesh.face_material == std::vector<std::uint16_t>(48, 3));
    CHECK_FALSE(mesh.closed);
    double area = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto corners = mesh.face(f);
        REQUIRE(corners.size() == 3);
        const glm::dvec3 a = mesh.positions[corners[0]], b = mesh.positions[corners[1]],
                         c = mesh.positions[corners[2]];
        const glm::dvec3 cross = glm::cross(b - a, c - a);
        CHECK(cross.z > 0);
        area += cross.z / 2;
    }
    CHECK(area == Approx(6 * 12.5 * 4 * 8));
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 7; ++column) {
            const glm::dvec3 p = mesh.positions[grid.index(column, row)];
            CHECK(p == glm::dvec3(grid.point(column, row), grid.height(column, row)));
        }
    }
}

TEST_CASE("terrain_mesh: a cell is divided along the diagonal that is more level", "[scene][terrain]") {
    HeightGrid ridge{2, 2, {0, 0}, {1, 1}, {0, 5, 5, 2}, 0};  // the ridge runs from south-east to north-west
    const Mesh mesh = terrain_mesh(ridge, 0);
    for (std::size_t f = 0; f < 2; ++f) {
        const auto corners = mesh.face(f);
        CHECK(std::count(corners.begin(), corners.end(), 1U) == 1);
        CHECK(std::count(corners.begin(), corners.end(), 2U) == 1);
    }
    CHECK(height_at(ridge, 0.5, 0.5) == 5.0);
    ridge.heights = {5, 0, 1, 5};
    CHECK(height_at(ridge, 0.5, 0.5) == 5.0);
}

TEST_CASE("terrain_mesh: normals of a plane are its own, borders included", "[scene][terrain]") {
    const HeightGrid grid = grid_of(4, 4, [](double x, double y) { return 0.25 * x - 0.5 * y + 7; });
    const glm::vec3 expected = glm::normalize(glm::vec3(-0.25f, 0.5f, 1));
    for (const glm::vec3& normal : terrain_mesh(grid, 0).normals)
        CHECK(glm::length(normal - expected) < 1e-6f);
}

TEST_CASE("terrain_mesh: the same bytes for any number of threads", "[scene][terrain]") {
    const HeightGrid grid = grid_of(70, 90, rugged);
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return terrain_mesh(grid, 0);
    };
    const Mesh one = with_threads(1), four = with_threads(4);
    CHECK(one.positions == four.positions);
    CHECK(one.normals == four.normals);
    CHECK(one.corners == four.corners);
}

TEST_CASE("height_at: lies on the triangle of the mesh that is over the place", "[scene][terrain]") {
    const HeightGrid grid = grid_of(9, 8, rugged);
    const Mesh mesh = terrain_mesh(grid, 0);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const auto corners = mesh.face(f);
        const glm::dvec3 a = mesh.positions[corners[0]], b = mesh.positions[corners[1]],
                         c = mesh.positions[corners[2]];
        for (const glm::dvec3 weight :
             {glm::dvec3(1, 0, 0), {0.2, 0.5, 0.3}, {0.5, 0.5, 0}, {0.01, 0.01, 0.98}}) {
            const glm::dvec3 p = weight.x * a + weight.y * b + weight.z * c;
            const auto height = height_at(grid, p.x, p.y);
            if (!height) continue;  // rounded out of the grid
            CHECK(std::abs(*height - p.z) < 1e-12);
        }
    }
}

TEST_CASE("height_at: says nothing beside the grid and is there on its border", "[scene][terrain]") {
    const HeightGrid grid = grid_of(4, 4, rugged);
    const glm::dvec2 corner = grid.point(3, 3);
    CHECK(height_at(grid, corner.x, corner.y) == static_cast<double>(grid.height(3, 3)));
    CHECK(height_at(grid, -50, 30) == static_cast<double>(grid.height(0, 0)));
    CHECK_FALSE(height_at(grid, corner.x + 0.01, corner.y));
    CHECK_FALSE(height_at(grid, -50.01, 30));
    CHECK_FALSE(height_at(grid, std::nan(""), 40));
}

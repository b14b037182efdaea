// SPDX-License-Identifier: Apache-2.0
#include "keikan/scene/mesh_file.hpp"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <numbers>

#include "keikan/clip/orient2d.hpp"
#include "keikan/support/input_error.hpp"
#include "simple_polygon.hpp"

namespace keikan {

namespace {

glm::dmat4 matrix_of(const aiMatrix4x4& m) {  // Assimp's is row by row, GLM's column by column
    return {m.a1, m.b1, m.c1, m.d1, m.a2, m.b2, m.c2, m.d2, m.a3, m.b3, m.c3, m.d3, m.a4, m.b4, m.c4, m.d4};
}

/// A point without its largest axis of `normal`: seen from the normal's side, turns keep their sense.
glm::dvec2 flattened(glm::dvec3 p, glm::dvec3 normal) {
    const glm::dvec3 size = glm::abs(normal);
    const int drop = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const glm::dvec2 flat{p[(drop + 1) % 3], p[(drop + 2) % 3]};
    return normal[drop] > 0 ? flat : glm::dvec2(flat.y, flat.x);
}

/// Twice the area vector, from the first corner (Newell).
glm::dvec3 doubled_area(const std::vector<glm::dvec3>& corners) {
    glm::dvec3 area{0};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        area += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return area;
}

bool is_planar(const std::vector<glm::dvec3>& corners, glm::dvec3 area) {
    const glm::dvec3 normal = glm::normalize(area);
    glm::dvec3 mean{0};
    double reach = 0;
    for (const glm::dvec3& p : corners) {
        mean += p / static_cast<double>(corners.size());
        reach = std::max(reach, glm::length(p));
    }
    return std::all_of(corners.begin(), corners.end(), [&](const glm::dvec3& p) {
        return std::abs(glm::dot(p - mean, normal)) <= kFilePlanarity * reach;
    });
}

/// No corner turns against the area's sense (exactly), and all turns together go around once.
bool is_convex(const std::vector<glm::dvec2>& outline) {
    const std::size_t n = outline.size();
    double around = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 a = outline[i], b = outline[(i + 1) % n], c = outline[(i + 2) % n];
        if (static_cast<int>(orient2d({a.x, a.y}, {b.x, b.y}, {c.x, c.y})) < 0) return false;
        const glm::dvec2 one = b - a, next = c - b;
        around += std::atan2(one.x * next.y - one.y * next.x, glm::dot(one, next));
    }
    return around < 3 * std::numbers::pi;  // once around is 2 pi, twice 4 pi
}

/// Collects what the nodes of a file hold into one mesh.
class MeshCollector {
  public:
    MeshCollector(const std::string& file, const MeshPlacement& placement,
                  const std::function<std::uint16_t(const std::string&)>& material_of)
        : file_(file), placement_(placement), material_of_(material_of) {}

    LoadedMesh collect(const aiScene& scene) {
        add_node(scene, *scene.mRootNode, glm::dmat4(1));
        if (loaded_.mesh.face_count() == 0) throw InputError(file_, "", "it holds no face with area");
        return std::move(loaded_);
    }

  private:
    void add_node(const aiScene& scene, const aiNode& node, const glm::dmat4& file_from_parent) {
        const glm::dmat4 file_from_node = file_from_parent * matrix_of(node.mTransformation);
        for (unsigned i = 0; i < node.mNumMeshes; ++i) {
            if (node.mMeshes[i] >= scene.mNumMeshes)
                throw InputError(file_, "", "a node names a mesh that is not there");
            add_mesh(scene, *scene.mMeshes[node.mMeshes[i]], file_from_node);
        }
        for (unsigned i = 0; i < node.mNumChildren; ++i) add_node(scene, *node.mChildren[i], file_from_node);
    }

    void add_mesh(const aiScene& scene, const aiMesh& mesh, const glm::dmat4& file_from_node) {
        const std::uint16_t material = material_index(scene, mesh.mMaterialIndex);
        std::vector<glm::dvec3> in_file(mesh.mNumVertices);
        std::vector<std::uint32_t> index(mesh.mNumVertices);
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D& p = mesh.mVertices[v];
            in_file[v] = glm::dvec3(file_from_node * glm::dvec4(p.x, p.y, p.z, 1));
            index[v] = position_index(in_file[v]);
        }
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) add_face(mesh.mFaces[f], in_file, index, material);
    }

    std::uint16_t material_index(const aiScene& scene, unsigned i) {
        const std::string name = i < scene.mNumMaterials ? material_name(*scene.mMaterials[i]) : "";
        const auto found = materials_.find(name);
        if (found != materials_.end()) return found->second;
        loaded_.file_materials.push_back(name);
        return materials_[name] = material_of_(name);
    }

    static std::string material_name(const aiMaterial& material) {
        aiString name;
        if (material.Get(AI_MATKEY_NAME, name) != AI_SUCCESS) return "";
        const std::string text = name.C_Str();
        return text == AI_DEFAULT_MATERIAL_NAME ? "" : text;  // Assimp's own word for none
    }

    /// Corners that lie on the same spot become one vertex: files split them by normal or texture.
    std::uint32_t position_index(glm::dvec3 in_file) {
        if (!std::isfinite(in_file.x) || !std::isfinite(in_file.y) || !std::isfinite(in_file.z))
            throw InputError(file_, "", "a coordinate is not finite");
        const auto [place, is_new] =
            vertices_.try_emplace({in_file.x, in_file.y, in_file.z}, std::uint32_t{0});
        if (is_new) place->second = loaded_.mesh.add_position(placed(in_file));
        return place->second;
    }

    glm::dvec3 placed(glm::dvec3 p) const {
        if (placement_.y_up) p = {p.x, -p.z, p.y};
        p *= placement_.scale;
        const double c = std::cos(placement_.yaw_rad), s = std::sin(placement_.yaw_rad);
        return placement_.position_m + glm::dvec3(c * p.x - s * p.y, s * p.x + c * p.y, p.z);
    }

    void add_face(const aiFace& face, const std::vector<glm::dvec3>& in_file,
                  const std::vector<std::uint32_t>& index, std::uint16_t material) {
        std::vector<std::uint32_t> vertices;
        std::vector<glm::dvec3> corners;
        for (unsigned k = 0; k < face.mNumIndices; ++k) {
            const unsigned v = face.mIndices[k];
            if (v >= index.size()) throw InputError(file_, "", "a face names a vertex that is not there");
            if (!vertices.empty() && vertices.back() == index[v]) continue;
            vertices.push_back(index[v]);
            corners.push_back(in_file[v]);
        }
        while (vertices.size() > 1 && vertices.front() == vertices.back()) {
            vertices.pop_back();
            corners.pop_back();
        }
        const glm::dvec3 area = doubled_area(corners);
        if (vertices.size() < 3 || glm::length(area) == 0) {
            ++loaded_.without_area;
            return;
        }
        ++loaded_.faces_in_file;
        if (vertices.size() == 3) return loaded_.mesh.add_face(vertices, material);
        std::vector<glm::dvec2> outline;
        for (const glm::dvec3& p : corners) outline.push_back(flattened(p, area));
        const bool planar = is_planar(corners, area);
        if (planar && is_convex(outline)) return loaded_.mesh.add_face(vertices, material);
        ++(planar ? loaded_.concave : loaded_.not_planar);
        add_triangles(vertices, corners, outline, material);
    }

    void add_triangles(const std::vector<std::uint32_t>& vertices, const std::vector<glm::dvec3>& corners,
                       const std::vector<glm::dvec2>& outline, std::uint16_t material) {
        std::vector<std::array<std::uint32_t, 3>> triangles;
        if (!why_not_simple(outline)) {
            triangles = triangulate(outline);
        } else {
            for (std::uint32_t k = 1; k + 1 < outline.size(); ++k) triangles.push_back({0, k, k + 1});
        }
        for (const auto& [a, b, c] : triangles)
            if (glm::length(doubled_area({corners[a], corners[b], corners[c]})) > 0)
                loaded_.mesh.add_face(std::array{vertices[a], vertices[b], vertices[c]}, material);
    }

    const std::string& file_;
    const MeshPlacement& placement_;
    const std::function<std::uint16_t(const std::string&)>& material_of_;
    std::map<std::string, std::uint16_t> materials_;
    std::map<std::array<double, 3>, std::uint32_t> vertices_;
    LoadedMesh loaded_;
};

void require_known_format(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    static constexpr std::array<const char*, 4> kKnown{".obj", ".ply", ".gltf", ".glb"};
    if (std::find(kKnown.begin(), kKnown.end(), ending) == kKnown.end())
        throw InputError(file.string(), "", "not a mesh format that is read: .obj, .ply, .gltf or .glb");
}

/// Assimp 5.2 looks for the end of a PLY header for ever where there is none.
void require_header_end(const std::filesystem::path& file) {
    constexpr std::streamsize kLongestHeader = 1 << 20;
    std::ifstream stream(file, std::ios::binary);
    std::string start(static_cast<std::size_t>(kLongestHeader), '\0');
    stream.read(start.data(), kLongestHeader);
    start.resize(static_cast<std::size_t>(stream.gcount()));
    if (start.compare(0, 3, "ply") == 0 && start.find("\nend_header") == std::string::npos)
        throw InputError(file.string(), "", "its PLY header does not end");
}

void require_placement(const MeshPlacement& placement) {
    const glm::dvec3 p = placement.position_m;
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) ||
        !std::isfinite(placement.yaw_rad))
        throw InputError("a mesh's position and yaw must be finite");
    if (!(placement.scale > 0) || !std::isfinite(placement.scale))
        throw InputError("a mesh's scale must be positive");
}

}  // namespace

std::string LoadedMesh::note(const std::string& name) const {
    std::string text =
        fmt::format("{}: {} polygons in the file, {} faces", name, faces_in_file, mesh.face_count());
    if (not_planar > 0) text += fmt::format(", {} triangulated because they are not planar", not_planar);
    if (concave > 0) text += fmt::format(", {} triangulated because they are not convex", concave);
    if (without_area > 0) text += fmt::format(", {} without area left out", without_area);
    return text;
}

LoadedMesh read_mesh_file(const std::filesystem::path& file, const MeshPlacement& placement,
                          const std::function<std::uint16_t(const std::string& file_material)>& material_of) {
    const std::string name = file.string();
    require_known_format(file);
    require_placement(placement);
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) throw InputError(name, "", "no such file");
    require_header_end(file);
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFile(name, aiProcess_ValidateDataStructure);
    if (scene == nullptr || scene->mRootNode == nullptr || scene->mNumMeshes == 0) {
        std::string reason = importer.GetErrorString();
        std::replace(reason.begin(), reason.end(), '\n', ' ');
        throw InputError(name, "", reason.empty() ? "it holds no mesh" : reason);
    }
    return MeshCollector(name, placement, material_of).collect(*scene);
}

}  // namespace keikan

#include "assets/gltf.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "assets/gltf_materials.h"
#include "assets/gltf_numbers.h"

namespace tumble {

namespace {

// Extensions that a file may require and that change nothing for us, or that are read.
const std::set<std::string> kKnown = {"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_materials_emissive_strength", "KHR_lights_punctual"};

template <class T>
const T& at(const GltfFile& file, const std::vector<T>& list, int index, const char* what) {
  if (index < 0 || static_cast<std::size_t>(index) >= list.size())
    fail_model(file.name, what, " ", index, " of ", list.size(), " is wanted; export it again");
  return list[static_cast<std::size_t>(index)];
}

struct Builder {
  GltfFile file;
  Model model;
  std::vector<int> node_of;        // the file's node -> ours; -1 for one that is not in the scene
  std::vector<int> file_node;      // and back
  std::size_t vertices = 0;
  std::map<const tinygltf::Primitive*, Mesh> meshes;  // many nodes may show one

  const tinygltf::Model& records() const { return *file.records; }
  void note(const std::string& text) {
    if (std::find(model.notes.begin(), model.notes.end(), text) == model.notes.end()) model.notes.push_back(text);
  }

  // ---- nodes

  void add_nodes() {
    const auto& nodes = records().nodes;
    node_of.assign(nodes.size(), -1);
    struct Next {
      int node, parent;
    };
    std::vector<Next> next;  // the last one is the next
    const std::vector<int> tops = top_nodes();
    for (auto top = tops.rbegin(); top != tops.rend(); ++top) next.push_back({*top, -1});
    while (!next.empty()) {
      const auto [index, parent] = next.back();
      next.pop_back();
      const tinygltf::Node& node = at(file, nodes, index, "node");
      if (node_of[static_cast<std::size_t>(index)] >= 0) fail_model(file.name, "node ", index, " hangs in two places; export it again");
      node_of[static_cast<std::size_t>(index)] = static_cast<int>(model.nodes.size());
      file_node.push_back(index);
      add_node(node, parent);
      const int own = node_of[static_cast<std::size_t>(index)];
      for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) next.push_back({*child, own});
    }
  }

  // Of the file's own scene, or, without scenes, all that are nobody's children.
  std::vector<int> top_nodes() const {
    const auto& scenes = records().scenes;
    if (!scenes.empty()) return at(file, scenes, std::max(records().defaultScene, 0), "scene").nodes;
    std::set<int> children;
    for (const tinygltf::Node& node : records().nodes) children.insert(node.children.begin(), node.children.end());
    std::vector<int> tops;
    for (int i = 0; i < static_cast<int>(records().nodes.size()); ++i)
      if (!children.contains(i)) tops.push_back(i);
    return tops;
  }

  void add_node(const tinygltf::Node& from, int parent) {
    ModelNode node;
    node.name = from.name;
    node.parent = parent;
    node.rest = from.matrix.empty() ? pose_of(from) : pose_of_matrix(from.matrix);
    node.place = to_place(node.rest);
    if (parent >= 0) node.place = model.nodes[static_cast<std::size_t>(parent)].place * node.place;
    if (from.skin >= 0) note("bones are not played yet: what they move stands still");
    model.nodes.push_back(node);
  }

  // A list of `count` sound numbers, or empty where the file gives none.
  void require(const std::vector<double>& list, std::size_t count, const char* what) const {
    const bool sound = std::all_of(list.begin(), list.end(), [](double v) { return std::abs(v) <= 1e9; });
    if (!list.empty() && (list.size() != count || !sound)) fail_model(file.name, "a node's ", what, " is not ", count, " finite numbers; export it again");
  }

  ModelPose pose_of(const tinygltf::Node& node) const {
    const auto &t = node.translation, &r = node.rotation, &s = node.scale;
    require(t, 3, "translation");
    require(r, 4, "rotation");
    require(s, 3, "scale");
    ModelPose pose;
    if (!t.empty()) pose.position = {t[0], t[1], t[2]};
    if (!r.empty()) pose.rotation = normalized(Quat{r[0], r[1], r[2], r[3]});
    if (!s.empty()) pose.scale = {s[0], s[1], s[2]};
    return pose;
  }

  // A mirrored one is mirrored along x: any axis does, with another rotation.
  ModelPose pose_of_matrix(const std::vector<double>& m) const {
    require(m, 16, "matrix");
    Vec3 x{m[0], m[1], m[2]}, y{m[4], m[5], m[6]}, z{m[8], m[9], m[10]};
    ModelPose pose;
    pose.position = {m[12], m[13], m[14]};
    pose.scale = {length(x), length(y), length(z)};
    if (dot(cross(x, y), z) < 0) {
      pose.scale.x = -pose.scale.x;
      x = -x;
    }
    // Of a flat or sheared one, axes that are at right angles all the same.
    y = normalized(y);
    z = normalized(z - y * dot(z, y));
    pose.rotation = length(z) > 0 && length(y) > 0 ? look_rotation(-z, y) : Quat{};
    return pose;
  }

  // ---- parts

  void add_parts() {
    for (std::size_t i = 0; i < file_node.size(); ++i) {
      const int mesh = records().nodes[static_cast<std::size_t>(file_node[i])].mesh;
      if (mesh < 0) continue;
      for (const tinygltf::Primitive& primitive : at(file, records().meshes, mesh, "mesh").primitives) add_part(primitive, static_cast<int>(i));
    }
  }

  void add_part(const tinygltf::Primitive& primitive, int node) {
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    const bool triangles = mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP || mode == TINYGLTF_MODE_TRIANGLE_FAN;
    if (!triangles) return note("points and lines are not drawn");
    if (!primitive.targets.empty()) note("morph targets are not played: the shape stays as it is without them");
    if (primitive.attributes.contains("COLOR_0")) note("colors of vertices are not drawn; give a color or a texture to the material");
    if (primitive.extensions.contains("KHR_draco_mesh_compression")) fail_model(file.name, "it is compressed with Draco; export it without compression");
    ModelPart part;
    part.node = node;
    part.material = primitive.material < 0 ? static_cast<int>(records().materials.size()) : primitive.material;
    if (part.material > static_cast<int>(records().materials.size())) fail_model(file.name, "material ", part.material, " of ", records().materials.size(), " is wanted; export it again");
    const auto [kept, fresh] = meshes.try_emplace(&primitive);
    if (fresh) kept->second = mesh_of(primitive, mode);
    count_vertices(kept->second.vertices.size());
    part.mesh = kept->second;
    const ModelPlace& place = model.nodes[static_cast<std::size_t>(node)].place;
    if (dot(cross(place.x, place.y), place.z) < 0)  // mirrored: the triangles would be seen from behind
      for (std::size_t i = 0; i + 2 < part.mesh.triangles.size(); i += 3) std::swap(part.mesh.triangles[i + 1], part.mesh.triangles[i + 2]);
    if (!part.mesh.triangles.empty()) model.parts.push_back(std::move(part));
  }

  static int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
  }

  void count_vertices(std::size_t count) {
    vertices += count;
    if (vertices > kMostModelVertices) fail_model(file.name, "it has more than ", kMostModelVertices, " vertices; make it simpler");
  }

  Mesh mesh_of(const tinygltf::Primitive& primitive, int mode) {
    if (attribute(primitive, "POSITION") < 0) return {};
    const GltfNumbers positions = read_numbers(file, attribute(primitive, "POSITION"), 3, "a list of positions");
    const int normals_at = attribute(primitive, "NORMAL"), uvs_at = attribute(primitive, "TEXCOORD_" + std::to_string(uv_set(records(), primitive.material)));
    GltfNumbers normals, uvs;
    if (normals_at >= 0) normals = read_numbers(file, normals_at, 3, "a list of normals");
    if (uvs_at >= 0) uvs = read_numbers(file, uvs_at, 2, "a list of texture coordinates");
    if ((normals_at >= 0 && normals.count != positions.count) || (uvs_at >= 0 && uvs.count != positions.count))
      fail_model(file.name, "a mesh has not as many normals or texture coordinates as positions; export it again");

    Mesh mesh;
    mesh.triangles = triangles_of(primitive, mode, positions.count);
    if (mesh.triangles.size() > 3 * kMostModelVertices) fail_model(file.name, "it has more than ", kMostModelVertices, " triangles; make it simpler");
    mesh.vertices.resize(positions.count);
    for (std::size_t i = 0; i < positions.count; ++i) {
      Vertex& vertex = mesh.vertices[i];
      std::copy_n(positions.row(i), 3, vertex.position.begin());
      if (uvs_at >= 0) std::copy_n(uvs.row(i), 2, vertex.uv.begin());
      if (normals_at < 0) continue;
      const float* n = normals.row(i);
      set_normal(vertex, {n[0], n[1], n[2]});
    }
    if (normals_at < 0) give_flat_normals(mesh);
    return mesh;
  }

  static void set_normal(Vertex& vertex, Vec3 direction) {
    const Vec3 n = length(direction) > 0 ? normalized(direction) : Vec3{0, 1, 0};
    vertex.normal = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  }

  // Each triangle gets corners of its own.
  static void give_flat_normals(Mesh& mesh) {
    std::vector<Vertex> corners;
    corners.reserve(mesh.triangles.size());
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
      const auto place = [&](std::size_t k) {
        const auto& p = mesh.vertices[mesh.triangles[i + k]].position;
        return Vec3{p[0], p[1], p[2]};
      };
      const Vec3 normal = cross(place(1) - place(0), place(2) - place(0));
      for (std::size_t k = 0; k < 3; ++k) {
        corners.push_back(mesh.vertices[mesh.triangles[i + k]]);
        set_normal(corners.back(), normal);
      }
    }
    mesh.vertices = std::move(corners);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) mesh.triangles[i] = static_cast<std::uint32_t>(i);
  }

  std::vector<std::uint32_t> triangles_of(const tinygltf::Primitive& primitive, int mode, std::size_t vertices_there) {
    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) corners = read_indices(file, primitive.indices, vertices_there);
    else
      for (std::size_t i = 0; i < vertices_there; ++i) corners.push_back(static_cast<std::uint32_t>(i));
    if (mode == TINYGLTF_MODE_TRIANGLES) {
      if (corners.size() % 3 != 0) fail_model(file.name, "a mesh has ", corners.size(), " corners, which is not three for each triangle; export it again");
      return corners;
    }
    // In a strip every other triangle is turned round; a fan shares its first corner.
    const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
    std::vector<std::uint32_t> triangles;
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const bool turned = !fan && i % 2 == 1;
      triangles.insert(triangles.end(), {corners[fan ? 0 : i - 2], corners[turned ? i : i - 1], corners[turned ? i - 1 : i]});
    }
    return triangles;
  }

  void measure() {
    bool first = true;
    for (const ModelPart& part : model.parts)
      for (const Vertex& vertex : part.mesh.vertices) {
        const Vec3 p = model.nodes[static_cast<std::size_t>(part.node)].place.point({vertex.position[0], vertex.position[1], vertex.position[2]});
        if (std::exchange(first, false)) model.low = model.high = p;
        model.low = {std::min(model.low.x, p.x), std::min(model.low.y, p.y), std::min(model.low.z, p.z)};
        model.high = {std::max(model.high.x, p.x), std::max(model.high.y, p.y), std::max(model.high.z, p.z)};
      }
    if (!is_finite(model.low) || !is_finite(model.high)) fail_model(file.name, "its nodes make it infinitely large; export it again");
  }

  // ---- clips

  void add_clips() {
    for (const tinygltf::Animation& animation : records().animations) {
      ModelClip clip;
      clip.name = animation.name.empty() ? "clip " + std::to_string(model.clips.size() + 1) : animation.name;
      for (const tinygltf::AnimationChannel& channel : animation.channels) add_track(clip, animation, channel);
      model.clips.push_back(std::move(clip));
    }
  }

  void add_track(ModelClip& clip, const tinygltf::Animation& animation, const tinygltf::AnimationChannel& channel) {
    if (channel.target_path == "weights") return note("morph targets are not played: the shape stays as it is without them");
    if (channel.target_node < 0 || static_cast<std::size_t>(channel.target_node) >= node_of.size())
      fail_model(file.name, "a clip moves node ", channel.target_node, " of ", node_of.size(), "; export it again");
    ModelTrack track;
    track.node = node_of[static_cast<std::size_t>(channel.target_node)];
    if (track.node < 0) return;
    if (channel.target_path == "translation") track.target = ModelTrack::Target::position;
    else if (channel.target_path == "rotation") track.target = ModelTrack::Target::rotation;
    else if (channel.target_path == "scale") track.target = ModelTrack::Target::scale;
    else return;
    const tinygltf::AnimationSampler& sampler = at(file, animation.samplers, channel.sampler, "sampler");
    if (sampler.interpolation == "STEP") track.ease = ModelTrack::Ease::step;
    else if (sampler.interpolation == "CUBICSPLINE") track.ease = ModelTrack::Ease::cubic;
    const GltfNumbers times = read_numbers(file, sampler.input, 1, "a clip's times");
    const GltfNumbers values = read_numbers(file, sampler.output, track.target == ModelTrack::Target::rotation ? 4 : 3, "a clip's values");
    if (times.count == 0 || values.count != times.count * (track.ease == ModelTrack::Ease::cubic ? 3 : 1))
      fail_model(file.name, "clip '", clip.name, "' has ", values.count, " values for ", times.count, " times; export it again");
    for (std::size_t i = 0; i < times.count; ++i)
      if (times.values[i] < 0 || (i > 0 && !(times.values[i] > times.values[i - 1])))
        fail_model(file.name, "clip '", clip.name, "' has times that do not rise; export it again");
    track.times.assign(times.values.begin(), times.values.end());
    track.values.assign(values.values.begin(), values.values.end());
    clip.seconds = std::max(clip.seconds, track.times.back());
    clip.tracks.push_back(std::move(track));
  }
};

}  // namespace

Model read_model(std::string_view bytes, const std::string& name, const ReadOther& read) {
  Builder builder{open_gltf(bytes, name, read), {}, {}, {}, 0, {}};
  for (const std::string& extension : builder.records().extensionsRequired)
    if (!kKnown.contains(extension)) fail_model(name, "it needs the extension ", extension, ", which we do not have; export it without");
  builder.add_nodes();
  add_materials(builder.file, builder.model);
  builder.add_parts();
  builder.measure();
  builder.add_clips();
  if (builder.model.parts.empty() && builder.model.clips.empty()) fail_model(name, "it holds neither triangles nor clips; export it with its meshes");
  return std::move(builder.model);
}

}  // namespace tumble

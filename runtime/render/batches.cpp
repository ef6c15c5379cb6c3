#include "render/batches.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "assets/mesh.h"

namespace tumble {
namespace {

float linear(double value) {
  return static_cast<float>(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

Instance make_instance(const DrawMesh& mesh) {
  const Matrix& m = mesh.matrix;
  return {{m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]},
          linear(is_stand_in(mesh.shape) ? kMissing : mesh.color),
          {mesh.roughness, mesh.metalness, mesh.glow, 0}};
}

float squared_distance(const DrawMesh& mesh) {
  const Matrix& m = mesh.matrix;
  return m[12] * m[12] + m[13] * m[13] + m[14] * m[14];
}

std::uint64_t key_of(const DrawMesh& mesh) { return mesh.key != 0 ? mesh.key : mesh_key(mesh.shape); }

}  // namespace

std::array<float, 4> linear(const Color& color) {
  return {linear(color.r), linear(color.g), linear(color.b), static_cast<float>(color.a)};
}

Batches make_batches(const DrawList& list) {
  Batches result;
  std::vector<std::vector<const DrawMesh*>> groups;
  std::unordered_map<std::uint64_t, std::size_t> group_of;
  std::vector<const DrawMesh*> transparent;
  for (const DrawMesh& mesh : list.meshes) {
    if (mesh.color.a < 1) {
      if (mesh.color.a > 0) transparent.push_back(&mesh);
      continue;
    }
    const auto [place, is_new] = group_of.try_emplace(key_of(mesh), groups.size());
    if (is_new) groups.emplace_back();
    groups[place->second].push_back(&mesh);
  }
  const auto nearer = [](const DrawMesh* a, const DrawMesh* b) { return squared_distance(*a) < squared_distance(*b); };
  // What is near hides what is far, which then need not be lit.
  for (auto& group : groups) std::stable_sort(group.begin(), group.end(), nearer);
  std::stable_sort(transparent.rbegin(), transparent.rend(), nearer);

  const auto add = [&](std::vector<Batch>& batches, const std::vector<const DrawMesh*>& group) {
    batches.push_back({key_of(*group[0]), &group[0]->shape, static_cast<std::uint32_t>(result.instances.size()),
                       static_cast<std::uint32_t>(group.size())});
    for (const DrawMesh* mesh : group) result.instances.push_back(make_instance(*mesh));
  };
  for (const auto& group : groups) add(result.opaque, group);
  for (const DrawMesh* mesh : transparent) add(result.transparent, {mesh});
  return result;
}

}  // namespace tumble

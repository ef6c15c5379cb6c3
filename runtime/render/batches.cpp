#include "render/batches.h"

#include <algorithm>
#include <cmath>

#include "assets/mesh_detail.h"
#include "base/hash.h"

namespace tumble {
namespace {

float linear(double value) {
  return static_cast<float>(value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4));
}

// A mesh on its way into a batch.
struct Item {
  std::uint64_t group = 0;  // equal: may be drawn together
  float order = 0;          // near ones first
  std::uint32_t mesh = 0;
  int coarseness = 0;
};

// Most neighbours in a list have the same colour, and the curve's powers are dear.
class Painter {
 public:
  explicit Painter(const DrawList& list) : list_(list) {}

  Instance instance(const DrawMesh& mesh) {
    const DrawShape& shape = list_.shapes[mesh.shape];
    const Color& color = shape.part < 0 && is_stand_in(shape.shape) ? kMissing : mesh.color;
    if (!(color == color_)) {
      color_ = color;
      linear_ = tumble::linear(color);
    }
    std::array<float, 4> glow{};
    if (mesh.glow > 0) glow = mesh.glow_color ? tumble::linear(*mesh.glow_color) : linear_;
    for (float& part : glow) part *= mesh.glow;
    const Matrix& m = mesh.matrix;
    return {{m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14]},
            linear_,
            {mesh.roughness, mesh.metalness, 0, mesh.texture_size},
            glow};
  }

 private:
  const DrawList& list_;
  Color color_{-1, -1, -1, -1};
  std::array<float, 4> linear_{};
};

float squared_distance(const Ball& ball) { return ball.x * ball.x + ball.y * ball.y + ball.z * ball.z; }

// By their far side: ground reaches far, and most of it is hidden by what stands on it.
float far_side(const Ball& ball) { return std::sqrt(squared_distance(ball)) + ball.radius; }

// A mirroring matrix turns triangles inside out.
bool is_mirrored(const Matrix& m) {
  return m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]) < 0;
}

bool both_sides(const DrawMesh& mesh) { return mesh.two_sided || is_mirrored(mesh.matrix); }

// A built-in face shows the whole picture, and at its edges nothing of the opposite one.
bool comes_again(const DrawList& list, const DrawMesh& mesh) {
  return mesh.texture_size > 0 || list.shapes[mesh.shape].part >= 0;
}

void add_batches(const DrawList& list, std::vector<Item>& items, bool with_texture, Batches& result) {
  std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
    if (a.group != b.group) return a.group < b.group;
    return a.order != b.order ? a.order < b.order : a.mesh < b.mesh;
  });
  std::vector<std::pair<float, Batch>> found;
  Painter painter(list);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const DrawMesh& mesh = list.meshes[items[i].mesh];
    if (i == 0 || items[i].group != items[i - 1].group)
      found.push_back({items[i].order, {mesh.shape, with_texture ? mesh.texture : 0, both_sides(mesh), comes_again(list, mesh),
                                        items[i].coarseness, static_cast<std::uint32_t>(result.instances.size()), 0}});
    ++found.back().second.count;
    result.instances.push_back(painter.instance(mesh));
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [order, batch] : found) result.opaque.push_back(batch);
}

std::uint64_t group_of(const DrawMesh& mesh, std::uint32_t texture, int coarseness) {
  const bool repeats = texture > 0 && mesh.texture_size > 0;
  return std::uint64_t{mesh.shape} << 32 | std::uint64_t{texture} << 4 | static_cast<std::uint64_t>(coarseness) << 2 |
         std::uint64_t{repeats} << 1 | both_sides(mesh);
}

// The most that the matrix stretches anything.
double stretch(const Matrix& m) {
  float squared = 0;
  for (std::size_t i = 0; i < 12; i += 4) squared = std::max(squared, m[i] * m[i] + m[i + 1] * m[i + 1] + m[i + 2] * m[i + 2]);
  return std::sqrt(squared);
}

int coarseness_of(const DrawList& list, const DrawMesh& mesh, double distance) {
  return coarseness_within(list.shapes[mesh.shape].shape, distance / std::max(stretch(mesh.matrix), 1e-6));
}

double near_side(const Ball& ball) { return std::max(0.0f, std::sqrt(squared_distance(ball)) - ball.radius); }

}  // namespace

std::array<float, 4> linear(const Color& color) {
  return {linear(color.r), linear(color.g), linear(color.b), static_cast<float>(color.a)};
}

Batches make_batches(const DrawList& list, const std::vector<Ball>& around, double angle, const Wanted& wanted) {
  Batches result;
  std::vector<Item> opaque, transparent;
  for (std::uint32_t i = 0; i < list.meshes.size(); ++i) {
    const DrawMesh& mesh = list.meshes[i];
    if (mesh.color.a <= 0 || !wanted(around[i])) continue;
    const int coarseness = coarseness_of(list, mesh, angle * near_side(around[i]));
    if (mesh.color.a < 1) transparent.push_back({0, -squared_distance(around[i]), i, coarseness});
    else opaque.push_back({group_of(mesh, mesh.texture, coarseness), far_side(around[i]), i, coarseness});
  }
  add_batches(list, opaque, true, result);
  std::stable_sort(transparent.begin(), transparent.end(), [](const Item& a, const Item& b) { return a.order < b.order; });
  Painter painter(list);
  for (const Item& item : transparent) {
    const DrawMesh& mesh = list.meshes[item.mesh];
    result.transparent.push_back(
        {mesh.shape, mesh.texture, both_sides(mesh), comes_again(list, mesh), item.coarseness,
         static_cast<std::uint32_t>(result.instances.size()), 1});
    result.instances.push_back(painter.instance(mesh));
  }
  return result;
}

Batches make_casters(const DrawList& list, const std::vector<Ball>& around, double distance, const Wanted& wanted) {
  Batches result;
  std::vector<Item> items;
  for (std::uint32_t i = 0; i < list.meshes.size(); ++i) {
    const DrawMesh& mesh = list.meshes[i];
    if (mesh.color.a < 1 || !wanted(around[i])) continue;
    const int coarseness = coarseness_of(list, mesh, distance);
    items.push_back({group_of(mesh, 0, coarseness), 0, i, coarseness});
  }
  add_batches(list, items, false, result);
  return result;
}

}  // namespace tumble

#include "engine/camera.h"

#include <algorithm>

#include "engine/engine_private.h"

namespace tumble {

namespace {

struct Bounds {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  bool empty() const { return low.x > high.x; }
  void add(Vec3 center, Vec3 half) {
    low = {std::min(low.x, center.x - half.x), std::min(low.y, center.y - half.y), std::min(low.z, center.z - half.z)};
    high = {std::max(high.x, center.x + half.x), std::max(high.y, center.y + half.y), std::max(high.z, center.z + half.z)};
  }
};

// Half the size of the world's box around a turned box.
Vec3 turned_half(Quat rotation, Vec3 half) {
  const auto positive = [](Vec3 v) { return Vec3{std::abs(v.x), std::abs(v.y), std::abs(v.z)}; };
  return positive(rotation * Vec3{half.x, 0, 0}) + positive(rotation * Vec3{0, half.y, 0}) + positive(rotation * Vec3{0, 0, half.z});
}

// A built-in shape lies around its node; a model where its file says.
void add_mesh(const Shape& mesh, const Transform& place, AssetLibrary* assets, Bounds& bounds) {
  const Model* model = assets && mesh.shape == ShapeKind::mesh ? assets->model(mesh.file) : nullptr;
  const Vec3 center = model ? (model->low + model->high) / 2 : Vec3{};
  const Vec3 half = model ? (model->high - model->low) / 2 : half_extents(mesh);
  bounds.add(to_parent(place, center), turned_half(place.rotation, scaled(half, place.scale)));
}

void add_meshes(const Scene& scene, NodeId id, AssetLibrary* assets, Bounds& bounds) {
  const SceneNode& node = scene[id];
  if (!node.visible || !node.enabled) return;
  if (node.mesh) add_mesh(*node.mesh, scene.world(id), assets, bounds);
  for (const NodeId child : node.children) add_meshes(scene, child, assets, bounds);
}

NodeId first_active_camera(const Scene& scene, NodeId id, NodeId except) {
  const SceneNode& node = scene[id];
  if (!node.enabled) return {};
  if (node.camera && node.camera->active && id != except && !node.dying) return id;
  for (const NodeId child : node.children)
    if (const NodeId found = first_active_camera(scene, child, except)) return found;
  return {};
}

}  // namespace

CameraView framing(const Scene& scene, AssetLibrary* assets) {
  Bounds bounds;
  add_meshes(scene, scene.root(), assets, bounds);
  if (bounds.empty()) bounds.add({}, {2, 2, 2});
  const Vec3 center = (bounds.low + bounds.high) / 2;
  const double radius = std::max(length(bounds.high - center), 0.5);

  CameraView view;
  const double away = radius / std::sin(view.field_of_view / 2);
  const Vec3 direction = normalized(Vec3{0, 0.4, 1});
  view.pose = {center + direction * away, look_rotation(-direction)};
  view.far = std::max(view.far, away + 2 * radius);
  return view;
}

NodeId Engine::find_camera() const {
  const NodeId own = private_->own_camera;
  const NodeId found = first_active_camera(scene, scene.root(), own);
  return found || !alive(own) ? found : own;
}

NodeId Engine::camera() {
  if (const NodeId found = find_camera()) return found;
  private_->own_camera = scene.add("camera");
  scene[private_->own_camera].origin = Origin::declared;
  scene[private_->own_camera].camera.emplace();
  private_->camera_checked = true;
  reframe_own_camera();
  return private_->own_camera;
}

// Beside a camera of the game's own it would only be a second node of that name.
void Engine::drop_spare_camera() {
  const NodeId own = private_->own_camera;
  if (alive(own) && scene[own].children.empty() && find_camera() != own) remove_now(own);
}

void Engine::reframe_own_camera() {
  const NodeId own = private_->own_camera;
  if (!alive(own)) return;
  const CameraView view = framing(scene, assets);
  scene.jump(own, {view.pose.position, view.pose.rotation, {1, 1, 1}});
  scene[own].camera->far = view.far;
}

}  // namespace tumble

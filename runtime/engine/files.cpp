// What nodes take from files: asked for when it is first named, so that what is missing is said at once, and again when
// the file was saved.

#include <algorithm>

#include "engine/engine_private.h"

namespace tumble {

namespace {

bool names_one(const Shape& shape, const std::vector<std::string>& files) {
  return !shape.file.empty() && std::find(files.begin(), files.end(), shape.file) != files.end();
}

}  // namespace

Shape Engine::with_points(const Shape& shape) const {
  try {
    return private_->shape_files.with_points(shape, assets);
  } catch (const Error& error) {
    warn(error.what() + std::string("; a box stands in"));
    Shape box;
    box.size = shape.size;
    return box;
  }
}

void Engine::ask_for_files(NodeId id) {
  if (!assets) return;
  const SceneNode& node = scene[id];
  const auto picture = [this](const std::string& file) {
    if (!file.empty()) assets->image(file);
  };
  if (node.mesh && !node.mesh->file.empty()) assets->model(node.mesh->file);
  if (node.animation && !node.animation->file.empty()) assets->model(node.animation->file);
  if (node.material) picture(node.material->texture);
  if (node.particles) picture(node.particles->texture);
}

void Engine::files_changed(const std::vector<std::string>& files) {
  private_->said.clear();
  scene.each(scene.root(), [&](NodeId id, SceneNode& node) {
    ask_for_files(id);
    const BodyComponent* component = body(id);
    if (!component) return;
    const auto& colliders = component->def.colliders;
    const bool given = std::any_of(colliders.begin(), colliders.end(), [&](const ColliderDef& c) { return names_one(c.shape, files); });
    const bool fitted = colliders.empty() && node.mesh && names_one(*node.mesh, files);
    if (!given && !fitted) return;
    try {
      refit_body(id);
    } catch (const Error& error) {
      warn(error.what());
    }
  });
}

}  // namespace tumble

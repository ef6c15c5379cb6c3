#include "engine/extract.h"

#include <algorithm>

#include "base/hash.h"
#include "engine/animation.h"

namespace tumble {

namespace {

constexpr double kUiHeight = 720;

// Equal for shapes that look alike: only the fields that the kind reads.
std::uint64_t shape_key(const Shape& shape) {
  Hash hash;
  hash.add(static_cast<std::uint64_t>(shape.shape));
  switch (shape.shape) {
    case ShapeKind::box:
    case ShapeKind::pyramid:
    case ShapeKind::plane: hash.add(shape.size); break;
    case ShapeKind::sphere: hash.add(shape.radius); break;
    case ShapeKind::capsule:
    case ShapeKind::cylinder:
    case ShapeKind::cone: hash.add(shape.radius).add(shape.height); break;
    case ShapeKind::torus: hash.add(shape.radius).add(shape.thickness); break;
    default:
      hash.add(shape.size).add(shape.file);
      for (const Vec3& point : shape.points) hash.add(point);
  }
  return hash.value();
}

// Model to picture space: the columns are the turned and stretched axes, then the place seen from the camera.
Matrix matrix_of(const Transform& t, Vec3 origin, const ModelPlace& part = {}) {
  const auto axis = [&](Vec3 v) { return t.rotation * scaled(t.scale, v); };
  const Vec3 x = axis(part.x), y = axis(part.y), z = axis(part.z), p = t.position + axis(part.position) - origin;
  const auto f = [](double d) { return static_cast<float>(d); };
  return {f(x.x), f(x.y), f(x.z), 0, f(y.x), f(y.y), f(y.z), 0, f(z.x), f(z.y), f(z.z), 0, f(p.x), f(p.y), f(p.z), 1};
}

void set_material(DrawMesh& mesh, const Material& material) {
  mesh.color = material.color;
  mesh.color.a *= material.opacity;
  mesh.roughness = static_cast<float>(material.roughness);
  mesh.metalness = static_cast<float>(material.metalness);
  mesh.glow = static_cast<float>(material.glow);
  mesh.texture = material.texture;
  mesh.texture_size = static_cast<float>(material.texture_size);
}

// The light of its own that a file gives has a colour; ours takes the material's. So a part without a picture takes on
// the colour of its light, as far as that is strong.
void set_glow(DrawMesh& mesh, const ModelMaterial& of_file) {
  const Color& glow = of_file.glow;
  const double strength = std::max({glow.r, glow.g, glow.b});
  if (strength <= 0) return;
  mesh.glow = static_cast<float>(strength);
  if (of_file.image >= 0) return;
  const double share = std::min(strength, 1.0);
  const auto mix = [&](double own, double light) { return own + (light / strength - own) * share; };
  mesh.color = {mix(mesh.color.r, glow.r), mix(mesh.color.g, glow.g), mix(mesh.color.b, glow.b), mesh.color.a};
}

// A part looks as its file says. Of the node's material, the colour tints it, the opacity clears it, and whatever else
// differs from a plain material takes the file's place.
void set_material(DrawMesh& mesh, const ModelMaterial& of_file, const std::optional<Material>& of_node) {
  mesh.color = of_file.color;
  mesh.roughness = static_cast<float>(of_file.roughness);
  mesh.metalness = static_cast<float>(of_file.metalness);
  set_glow(mesh, of_file);
  if (!of_node) return;
  const Material plain, &own = *of_node;
  if (!(own.color == plain.color)) mesh.color = {mesh.color.r * own.color.r, mesh.color.g * own.color.g, mesh.color.b * own.color.b, mesh.color.a * own.color.a};
  mesh.color.a *= own.opacity;
  if (own.roughness != plain.roughness) mesh.roughness = static_cast<float>(own.roughness);
  if (own.metalness != plain.metalness) mesh.metalness = static_cast<float>(own.metalness);
  if (own.glow != plain.glow) mesh.glow = static_cast<float>(own.glow);
  mesh.texture = own.texture;
  mesh.texture_size = static_cast<float>(own.texture_size);
}

// A mesh that is built in, or the stand-in of one that is not there.
DrawMesh draw_shape(const Engine& engine, const SceneNode& node, const Transform& world, Vec3 origin) {
  static const Material usual;
  DrawMesh mesh;
  const bool hull_of_file = node.mesh->shape == ShapeKind::hull && !node.mesh->file.empty() && engine.assets && engine.assets->model(node.mesh->file);
  mesh.shape = hull_of_file ? engine.with_points(*node.mesh) : *node.mesh;
  mesh.matrix = matrix_of(world, origin);
  set_material(mesh, node.material ? *node.material : usual);
  mesh.key = shape_key(mesh.shape);
  return mesh;
}

void draw_model(const Engine& engine, NodeId id, const Model& model, const Transform& world, double alpha, DrawList& list) {
  const SceneNode& node = engine.scene[id];
  const std::vector<ModelPlace> moved = node.animation ? animated_places(engine, id, model, alpha) : std::vector<ModelPlace>{};
  Transform place = world;
  if (node.mesh->shape == ShapeKind::height_field) place.scale = scaled(place.scale, node.mesh->size);
  DrawMesh mesh;
  mesh.shape = *node.mesh;
  const std::uint64_t version = engine.assets->version(node.mesh->file);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const auto on = static_cast<std::size_t>(model.parts[i].node);
    mesh.part = static_cast<int>(i);
    mesh.matrix = matrix_of(place, list.origin, moved.empty() ? model.nodes[on].place : moved[on]);
    set_material(mesh, model.materials[static_cast<std::size_t>(model.parts[i].material)], node.material);
    mesh.key = Hash().add(mesh.shape.file).add(version).add(std::uint64_t{i}).value();
    list.meshes.push_back(mesh);
  }
}

const Model* model_of(const Engine& engine, const Shape& mesh) {
  const bool drawn = mesh.shape == ShapeKind::mesh || mesh.shape == ShapeKind::height_field;
  return drawn && engine.assets && !mesh.file.empty() ? engine.assets->model(mesh.file) : nullptr;
}

struct Walk {
  const Engine& engine;
  const Scene& scene;
  double alpha;
  DrawList& list;
  bool sun_found = false, light_found = false;

  void visit(NodeId id, const Transform& parent) {
    const SceneNode& node = scene[id];
    if (!node.visible || !node.enabled) return;
    const Transform world = scene.interpolated(node, parent, alpha);
    if (node.mesh) add_mesh(id, node, world);
    if (node.light) add_light(*node.light, world);
    for (const NodeId child : node.children) visit(child, world);
  }

  void add_mesh(NodeId id, const SceneNode& node, const Transform& world) {
    if (const Model* model = model_of(engine, *node.mesh)) draw_model(engine, id, *model, world, alpha, list);
    else list.meshes.push_back(draw_shape(engine, node, world, list.origin));
  }

  void add_light(const Light& light, const Transform& world) {
    light_found = true;
    if (light.type != LightType::sun || sun_found) return;
    sun_found = true;
    list.sun_direction = world.rotation * Vec3{0, 0, -1};
    list.sun_color = light.color;
    list.sun_brightness = light.brightness;
    list.sun_shadow = light.shadow;
  }
};

CameraView view_of(const Engine& engine, NodeId camera, const Transform& place) {
  if (!camera) return framing(engine.scene, engine.assets);
  const Camera& c = *engine.scene[camera].camera;
  return {{place.position, place.rotation}, c.field_of_view, c.near, c.far};
}

}  // namespace

DrawList extract(const Engine& engine, double alpha, double /*aspect*/) {
  const NodeId camera = engine.find_camera();
  const CameraView view = view_of(engine, camera, camera ? engine.scene.interpolated_world(camera, alpha) : Transform{});
  DrawList list;
  list.origin = view.pose.position;
  list.camera_rotation = view.pose.rotation;
  list.field_of_view = view.field_of_view;
  list.near = view.near;
  list.far = view.far;
  list.sun_direction = normalized(list.sun_direction);

  Walk walk{engine, engine.scene, alpha, list};
  walk.visit(engine.scene.root(), {});
  engine.particles.draw(alpha, list.origin, list.particles);
  list.has_sun = walk.sun_found || !walk.light_found;
  return list;
}

CameraView camera_view(const Engine& engine) {
  const NodeId camera = engine.find_camera();
  return view_of(engine, camera, camera ? engine.scene.world(camera) : Transform{});
}

std::pair<Vec3, Vec3> camera_ray(const CameraView& view, double x, double y, double aspect) {
  // Right and up on a plane at distance 1: the picture is 2 tan(fov / 2) high there.
  const double half = std::tan(view.field_of_view / 2);
  const double right = (x / (kUiHeight * aspect) * 2 - 1) * half * aspect;
  const double up = (1 - y / kUiHeight * 2) * half;
  return {view.pose.position, view.pose.rotation * normalized(Vec3{right, up, -1})};
}

bool to_screen(const CameraView& view, Vec3 point, double aspect, double& x, double& y) {
  const Vec3 seen = conjugate(view.pose.rotation) * (point - view.pose.position);
  const double half = std::tan(view.field_of_view / 2);
  // Behind the camera the place is mirrored to the front, so that arrows at the edge of the picture still point well.
  const double depth = std::max(std::abs(seen.z), 1e-9);
  x = (seen.x / (depth * half * aspect) + 1) / 2 * kUiHeight * aspect;
  y = (1 - seen.y / (depth * half)) / 2 * kUiHeight;
  return seen.z < 0;
}

}  // namespace tumble

#include "engine/extract.h"

#include <algorithm>
#include <array>

#include "engine/animation.h"

namespace tumble {

namespace {

constexpr double kUiHeight = 720;

// Model to picture space: the columns are the turned and stretched axes, then the place seen from the camera.
Matrix matrix_of(const Transform& t, Vec3 origin, const ModelPlace& part = {}) {
  const auto axis = [&](Vec3 v) { return t.rotation * scaled(t.scale, v); };
  const Vec3 x = axis(part.x), y = axis(part.y), z = axis(part.z), p = t.position + axis(part.position) - origin;
  const auto f = [](double d) { return static_cast<float>(d); };
  return {f(x.x), f(x.y), f(x.z), 0, f(y.x), f(y.y), f(y.z), 0, f(z.x), f(z.y), f(z.z), 0, f(p.x), f(p.y), f(p.z), 1};
}

// A mesh that is built in, or the stand-in of one that is not there.
DrawMesh draw_shape(const Engine& engine, const SceneNode& node, const Transform& world, DrawList& list) {
  static const Material usual;
  const Material& material = node.material ? *node.material : usual;
  const bool hull_of_file = node.mesh->shape == ShapeKind::hull && engine.assets && !node.mesh->file.empty() && engine.assets->model(node.mesh->file);
  DrawMesh mesh;
  mesh.shape = list.shape_number(hull_of_file ? engine.with_points(*node.mesh) : *node.mesh);
  mesh.texture = list.texture_number(material.texture);
  mesh.texture_size = static_cast<float>(material.texture_size);
  mesh.matrix = matrix_of(world, list.origin);
  mesh.color = material.color;
  mesh.color.a *= material.opacity;
  mesh.roughness = static_cast<float>(material.roughness);
  mesh.metalness = static_cast<float>(material.metalness);
  mesh.glow = static_cast<float>(material.glow);
  return mesh;
}

void look_like_file(DrawMesh& mesh, const ModelMaterial& material, const std::string& file, DrawList& list) {
  mesh.texture = material.image < 0 ? 0 : list.texture_number(file, material.image);
  mesh.texture_size = 0;
  mesh.color = material.color;
  mesh.roughness = static_cast<float>(material.roughness);
  mesh.metalness = static_cast<float>(material.metalness);
  mesh.two_sided = material.two_sided;
  const double strength = std::max({material.glow.r, material.glow.g, material.glow.b});
  mesh.glow = static_cast<float>(strength);
  mesh.glow_color.reset();
  if (strength > 0) mesh.glow_color = Color{material.glow.r / strength, material.glow.g / strength, material.glow.b / strength, 1};
}

// Of the node's own material, the colour tints the file's, the opacity clears it, and whatever else differs from a plain
// material takes the file's place.
void look_like_node(DrawMesh& mesh, const Material& own, DrawList& list) {
  const Material plain;
  const Color& tint = own.color;
  if (!(tint == plain.color)) mesh.color = {mesh.color.r * tint.r, mesh.color.g * tint.g, mesh.color.b * tint.b, mesh.color.a * tint.a};
  mesh.color.a *= own.opacity;
  if (own.roughness != plain.roughness) mesh.roughness = static_cast<float>(own.roughness);
  if (own.metalness != plain.metalness) mesh.metalness = static_cast<float>(own.metalness);
  if (own.glow != plain.glow) {
    mesh.glow = static_cast<float>(own.glow);
    mesh.glow_color.reset();
  }
  if (own.texture.empty()) return;
  mesh.texture = list.texture_number(own.texture);
  mesh.texture_size = static_cast<float>(own.texture_size);
}

void draw_model(const Engine& engine, NodeId id, const Model& model, const Transform& world, double alpha, DrawList& list) {
  const SceneNode& node = engine.scene[id];
  const std::vector<ModelPlace> moved = node.animation ? animated_places(engine, id, model, alpha) : std::vector<ModelPlace>{};
  Transform place = world;
  if (node.mesh->shape == ShapeKind::height_field) place.scale = scaled(place.scale, node.mesh->size);
  for (std::size_t i = 0; i < model.parts.size(); ++i) {
    const ModelPart& part = model.parts[i];
    const auto on = static_cast<std::size_t>(part.node);
    DrawMesh mesh;
    mesh.shape = list.shape_number(*node.mesh, static_cast<int>(i));
    mesh.matrix = matrix_of(place, list.origin, moved.empty() ? model.nodes[on].place : moved[on]);
    look_like_file(mesh, model.materials[static_cast<std::size_t>(part.material)], node.mesh->file, list);
    if (node.material) look_like_node(mesh, *node.material, list);
    list.meshes.push_back(mesh);
  }
}

const Model* model_of(const Engine& engine, const Shape& mesh) {
  const bool drawn = mesh.shape == ShapeKind::mesh || mesh.shape == ShapeKind::height_field;
  return drawn && engine.assets && !mesh.file.empty() ? engine.assets->model(mesh.file) : nullptr;
}

DrawLight lamp(const Light& light, const Transform& world, Vec3 origin) {
  const auto narrow = [](Vec3 v) {
    return std::array<float, 3>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  };
  DrawLight result;
  result.spot = light.type == LightType::spot;
  result.position = narrow(world.position - origin);
  result.direction = narrow(world.rotation * Vec3{0, 0, -1});
  result.color = light.color;
  result.brightness = static_cast<float>(light.brightness);
  result.range = static_cast<float>(light.range);
  result.angle = static_cast<float>(light.angle);
  return result;
}

struct Walk {
  const Engine& engine;
  const Scene& scene;
  double alpha;
  DrawList& list;
  bool sun_found = false, light_found = false, sky_found = false;

  void visit(NodeId id, const Transform& parent) {
    const SceneNode& node = scene[id];
    if (!node.visible || !node.enabled) return;
    const Transform world = scene.interpolated(node, parent, alpha);
    if (node.mesh) add_mesh(id, node, world);
    if (node.light) add_light(*node.light, world);
    if (node.sky && !sky_found) set_sky(*node.sky);
    for (const NodeId child : node.children) visit(child, world);
  }

  void add_mesh(NodeId id, const SceneNode& node, const Transform& world) {
    if (const Model* model = model_of(engine, *node.mesh)) draw_model(engine, id, *model, world, alpha, list);
    else list.meshes.push_back(draw_shape(engine, node, world, list));
  }

  void add_light(const Light& light, const Transform& world) {
    light_found = true;
    if (light.type != LightType::sun) list.lights.push_back(lamp(light, world, list.origin));
    if (light.type != LightType::sun || sun_found) return;
    sun_found = true;
    list.sun_direction = world.rotation * Vec3{0, 0, -1};
    list.sun_color = light.color;
    list.sun_brightness = light.brightness;
    list.sun_shadow = light.shadow;
  }

  void set_sky(const Sky& sky) {
    sky_found = true;
    list.sky_top = sky.top;
    list.sky_horizon = sky.horizon;
    list.ground = sky.ground;
    list.sky_brightness = sky.brightness;
    list.exposure = sky.exposure;
    list.fog_color = sky.fog_color;
    list.fog_start = sky.fog_start;
    list.fog_end = sky.fog_end;
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

#include "engine/extract.h"

#include <array>

namespace tumble {

namespace {

constexpr double kUiHeight = 720;

// Model to picture space: the columns are the turned and stretched axes, then the place seen from the camera.
Matrix matrix_of(const Transform& t, Vec3 origin) {
  const Vec3 x = t.rotation * Vec3{t.scale.x, 0, 0}, y = t.rotation * Vec3{0, t.scale.y, 0}, z = t.rotation * Vec3{0, 0, t.scale.z};
  const Vec3 p = t.position - origin;
  const auto f = [](double d) { return static_cast<float>(d); };
  return {f(x.x), f(x.y), f(x.z), 0, f(y.x), f(y.y), f(y.z), 0, f(z.x), f(z.y), f(z.z), 0, f(p.x), f(p.y), f(p.z), 1};
}

DrawMesh draw_mesh(const SceneNode& node, const Transform& world, DrawList& list) {
  static const Material usual;
  const Material& material = node.material ? *node.material : usual;
  DrawMesh mesh;
  mesh.shape = list.shape_number(*node.mesh);
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
  const Scene& scene;
  double alpha;
  DrawList& list;
  bool sun_found = false, light_found = false, sky_found = false;

  void visit(NodeId id, const Transform& parent) {
    const SceneNode& node = scene[id];
    if (!node.visible || !node.enabled) return;
    const Transform world = scene.interpolated(node, parent, alpha);
    if (node.mesh) list.meshes.push_back(draw_mesh(node, world, list));
    if (node.light) add_light(*node.light, world);
    if (node.sky && !sky_found) set_sky(*node.sky);
    for (const NodeId child : node.children) visit(child, world);
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
  if (!camera) return framing(engine.scene);
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

  Walk walk{engine.scene, alpha, list};
  walk.visit(engine.scene.root(), {});
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

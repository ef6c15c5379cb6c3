#include "assets/model.h"

#include <algorithm>

#include "base/error.h"

namespace tumble {

namespace {

// A cubic track's keys are in-tangent, value, out-tangent.
constexpr int kIn = 0, kValue = 1, kOut = 2;

struct Key {
  std::size_t at;     // of the key at or before the time
  std::size_t next;   // the same where the time is outside the keys
  double share;       // of the way to the next
  double seconds;     // between the two
};

Key find_key(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  if (after == times.begin()) return {0, 0, 0, 0};
  const auto at = static_cast<std::size_t>(after - times.begin() - 1);
  if (after == times.end()) return {at, at, 0, 0};
  const double seconds = times[at + 1] - times[at];
  return {at, at + 1, (time - times[at]) / seconds, seconds};
}

// Hermite's polynomial: through both values, along both tangents.
double hermite(double a, double out, double b, double in, double t, double seconds) {
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * seconds * out + (3 * t2 - 2 * t3) * b + (t3 - t2) * seconds * in;
}

// One of the numbers of a key, by what lies between the keys; a rotation's straight way is not this one.
double number_at(const ModelTrack& track, const Key& key, int index, int width) {
  const bool cubic = track.ease == ModelTrack::Ease::cubic;
  const auto value = [&](std::size_t k, int which) {
    return track.values[(cubic ? k * 3 + static_cast<std::size_t>(which) : k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(index)];
  };
  const double a = value(key.at, kValue);
  if (key.next == key.at || track.ease == ModelTrack::Ease::step) return a;
  const double b = value(key.next, kValue);
  if (!cubic) return a + (b - a) * key.share;
  return hermite(a, value(key.at, kOut), b, value(key.next, kIn), key.share, key.seconds);
}

Quat rotation_at(const ModelTrack& track, const Key& key) {
  if (track.ease != ModelTrack::Ease::linear || key.next == key.at)
    return normalized(Quat{number_at(track, key, 0, 4), number_at(track, key, 1, 4), number_at(track, key, 2, 4), number_at(track, key, 3, 4)});
  const auto value = [&](std::size_t k) {
    const double* v = &track.values[k * 4];
    return normalized(Quat{v[0], v[1], v[2], v[3]});
  };
  return slerp(value(key.at), value(key.next), key.share);
}

int index_of(const Model& model, const std::string& name) {
  for (std::size_t i = 0; i < model.nodes.size(); ++i)
    if (model.nodes[i].name == name) return static_cast<int>(i);
  return -1;
}

}  // namespace

ModelPlace operator*(const ModelPlace& parent, const ModelPlace& child) {
  return {parent.direction(child.x), parent.direction(child.y), parent.direction(child.z), parent.point(child.position)};
}

ModelPlace to_place(const ModelPose& pose) {
  return {pose.rotation * Vec3{pose.scale.x, 0, 0}, pose.rotation * Vec3{0, pose.scale.y, 0}, pose.rotation * Vec3{0, 0, pose.scale.z},
          pose.position};
}

const ModelClip* find_clip(const Model& model, std::string_view name) {
  if (name.empty()) return model.clips.empty() ? nullptr : &model.clips[0];
  for (const ModelClip& clip : model.clips)
    if (clip.name == name) return &clip;
  return nullptr;
}

void sample(const ModelTrack& track, double time, ModelPose& pose) {
  const Key key = find_key(track.times, time);
  if (track.target == ModelTrack::Target::rotation) {
    pose.rotation = rotation_at(track, key);
    return;
  }
  Vec3& vector = track.target == ModelTrack::Target::position ? pose.position : pose.scale;
  vector = {number_at(track, key, 0, 3), number_at(track, key, 1, 3), number_at(track, key, 2, 3)};
}

std::vector<ModelPlace> places(const Model& model, const Model& source, const ModelClip& clip, double time) {
  std::vector<ModelPose> poses;
  for (const ModelNode& node : model.nodes) poses.push_back(node.rest);
  for (const ModelTrack& track : clip.tracks) {
    const int node = &model == &source ? track.node : index_of(model, source.nodes[static_cast<std::size_t>(track.node)].name);
    if (node >= 0) sample(track, time, poses[static_cast<std::size_t>(node)]);
  }
  std::vector<ModelPlace> places;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const int parent = model.nodes[i].parent;
    const ModelPlace own = to_place(poses[i]);
    places.push_back(parent < 0 ? own : places[static_cast<std::size_t>(parent)] * own);
  }
  return places;
}

std::vector<Vec3> triangles_of(const Model& model) {
  std::vector<Vec3> corners;
  for (const ModelPart& part : model.parts) {
    const ModelPlace& place = model.nodes[static_cast<std::size_t>(part.node)].place;
    for (const std::uint32_t index : part.mesh.triangles) {
      const auto& p = part.mesh.vertices[index].position;
      corners.push_back(place.point({p[0], p[1], p[2]}));
    }
  }
  return corners;
}

Model height_field_of(const Image& picture, const std::string& name) {
  const int w = picture.width, h = picture.height;
  if (w < 2 || h < 2 || w > kLargestHeightField || h > kLargestHeightField)
    fail("height field: '", name, "' is ", w, " x ", h, " pixels; make each side 2 to ", kLargestHeightField);
  const auto height = [&](int x, int z) {
    const std::uint8_t* p = &picture.pixels[std::size_t{4} * static_cast<std::size_t>(std::clamp(z, 0, h - 1) * w + std::clamp(x, 0, w - 1))];
    return (p[0] + p[1] + p[2]) / 765.0 - 0.5;
  };
  const auto f = [](double value) { return static_cast<float>(value); };
  Model model;
  model.nodes.emplace_back();
  model.materials.emplace_back();
  Mesh& mesh = model.parts.emplace_back().mesh;
  for (int z = 0; z < h; ++z)
    for (int x = 0; x < w; ++x) {
      const double u = x / (w - 1.0), v = z / (h - 1.0);
      const double across = std::clamp(x + 1, 0, w - 1) - std::clamp(x - 1, 0, w - 1), along = std::clamp(z + 1, 0, h - 1) - std::clamp(z - 1, 0, h - 1);
      const Vec3 normal = normalized(Vec3{-(height(x + 1, z) - height(x - 1, z)) * (w - 1) / across, 1,
                                          -(height(x, z + 1) - height(x, z - 1)) * (h - 1) / along});
      mesh.vertices.push_back({{f(u - 0.5), f(height(x, z)), f(v - 0.5)}, {f(normal.x), f(normal.y), f(normal.z)}, {f(u), f(v)}});
    }
  for (int z = 0; z + 1 < h; ++z)
    for (int x = 0; x + 1 < w; ++x) {
      const auto a = static_cast<std::uint32_t>(z * w + x), below = a + static_cast<std::uint32_t>(w);
      mesh.triangles.insert(mesh.triangles.end(), {a, below, a + 1, a + 1, below, below + 1});
    }
  model.low = {-0.5, -0.5, -0.5};
  model.high = {0.5, 0.5, 0.5};
  return model;
}

}  // namespace tumble

#include "script/areas.h"

#include <deque>

#include "script/script.h"

namespace tumble {

namespace {

struct Entry {
  const char* name;
  bool object;
  void (*rows)(Area&);
  const Type* (*described)();
  const char* doc;
};

template <class T>
const Type* described() { return &type_of<T>(); }

const char* const kUiDoc =
    "What is on the screen, named anew in each tick, in draw_ui(). The screen is 720 units high whatever the window; `at` keeps things at its edges and corners, and panels and "
    "rows stack what is in them. Arrows, d-pad and left stick walk through the widgets of panels, enter, space and pad_a press them; a press that a widget took, the game does not "
    "see. A widget is known by its label: one that changes or comes twice needs an id.";

// A module and an object may share a word ("joint" the module, "joint" the object); objects are found by area(), and
// modules are what is not an object.
const Entry kEntries[] = {
    {"scene", false, rows_scene, nullptr, "The tree of nodes: adding, finding, loading."},
    {"node", true, rows_node, nullptr, "A thing in the scene: a place, a name, and what hangs on it."},
    {"list of children", true, rows_children, nullptr, "A node's children, to be read: #, [i], ipairs."},
    {"mesh", true, rows_mesh, described<Shape>, "What a node looks like: node.mesh."},
    {"material", true, rows_material, described<Material>, "How its surface looks: node.material."},
    {"light", true, rows_light, described<Light>, "A light that shines from a node: node.light."},
    {"camera", true, rows_camera, described<Camera>, "The eye: node.camera."},
    {"sky", true, rows_sky, described<Sky>, "Sky and fog: node.sky."},
    {"sound", true, rows_sound, described<Sound>, "What is heard from a node: node.sound."},
    {"sound", false, rows_sound_module, nullptr, "Sounds and music, and how loud they are."},
    {"voice", true, rows_voice, nullptr, "A sound that plays: what sound.play gives."},
    {"sound groups", true, rows_sound_groups, nullptr, "How loud each group of sounds is: sound.groups."},
    {"particles", true, rows_particles, described<Particles>, "Small sprites that rise from a node: node.particles."},
    {"animation", true, rows_animation, described<Animation>, "Keyframes that move a node: node.animation."},
    {"body", true, rows_body, described<BodyDef>, "What makes a node a physical body: node.body."},
    {"physics", false, rows_physics, described<WorldSettings>, "Rays, casts and the world's settings."},
    {"hit", true, rows_hit, nullptr, "What a ray found, or who touched whom: a record of its own, to keep as long as you like."},
    {"filter", true, rows_filter, nullptr, "A compiled filter for queries."},
    {"joint", false, rows_joint_module, nullptr, "Joints between two bodies, or a body and the world."},
    {"joint", true, rows_joint, nullptr, "A joint: its options can be read and written live."},
    {"table", true, rows_view, nullptr, "A table inside a component or joint, such as hinge.motor."},
    {"input", false, rows_input, nullptr, "Keys, buttons and the pointer, sampled once a tick."},
    {"input.pointer", false, rows_pointer, nullptr, "The pointer: a mouse, a pen or a finger."},
    {"time", false, rows_time, nullptr, "The game's clock."},
    {"task", false, rows_task, nullptr, "Things that happen later or go on for a while."},
    {"random", false, rows_random, nullptr, "Random numbers, seeded by the game."},
    {"draw", false, rows_draw, nullptr, "Lines and marks in the world, for one tick (from frame: one frame)."},
    {"ui", false, rows_ui, nullptr, kUiDoc},
    {"storage", false, rows_storage, nullptr, "What a game keeps from one run to the next, such as high scores and settings."},
    {"log", false, rows_log, nullptr, "Lines for the author."},
    {"game", false, rows_game, nullptr, "The game itself: its report, its end."},
    {"property", false, rows_property_module, nullptr, "Declared properties of a behaviour, where a plain default says too little."},
    {"property", true, rows_property, nullptr, "A declared property."},
    {"vec3", true, rows_vec3, nullptr, "A point or direction; values do not change."},
    {"quat", true, rows_quat, nullptr, "A rotation; values do not change."},
    {"color", true, rows_color, nullptr, "A colour; values do not change."},
};

std::deque<Area>& areas() {
  static std::deque<Area> list;
  if (list.empty())
    for (const Entry& entry : kEntries) {
      Area& area = list.emplace_back();
      area.name = entry.name;
      area.doc = entry.doc;
      area.object = entry.object;
      area.described = entry.described ? entry.described() : nullptr;
      entry.rows(area);
    }
  return list;
}

}  // namespace

const std::vector<Area*>& all_areas() {
  static std::vector<Area*> list;
  if (list.empty())
    for (Area& area : areas()) list.push_back(&area);
  return list;
}

Area& area(const char* name) {
  for (Area& area : areas())
    if (area.object && area.name == name) return area;
  for (Area& area : areas())
    if (area.name == name) return area;
  fail("no area '", name, "'");
}

}  // namespace tumble

// Staging: files declare into an engine of their own; commit() applies to the game what differs from the last run.
#include <algorithm>
#include <set>

#include "base/text.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

namespace {

// Paths and values where two runs of the text differ, as deep as both have tables: "body.mass" rather than "body".
void differences(const std::string& path, const Value& before, const Value& now, std::vector<std::pair<std::string, Value>>& list) {
  if (before == now) return;
  const Map *a = before.get<Map>(), *b = now.get<Map>();
  if (!a || !b) {
    list.emplace_back(path, now);
    return;
  }
  const std::string prefix = path.empty() ? "" : path + ".";
  for (const auto& [key, value] : *b) {
    const Value* old = before.find(key);
    differences(prefix + key, old ? *old : Value{}, value, list);
  }
  for (const auto& [key, value] : *a)
    if (!now.find(key)) list.emplace_back(prefix + key, Value{});
}

// By key, for runs that declare thousands.
template <class T>
std::map<std::string, const T*> by_key(const std::vector<T>& list) {
  std::map<std::string, const T*> map;
  for (const T& one : list) map[one.key] = &one;
  return map;
}

void erase_key(Value& value, const std::string& key) {
  if (Map* map = value.get<Map>()) std::erase_if(*map, [&](const auto& entry) { return entry.first == key; });
}

}  // namespace

void Script::begin_staging() {
  staging_ = std::make_unique<Engine>(live_.settings, false);
  staging_settings_ = first_settings_;
  staged_ = {};
  key_counts_.clear();
  refused_ = false;
  outer_phase_ = phase_;
  phase_ = Phase::declare;
}

void Script::drop_staging() {
  for (const DeclaredNode& node : staged_.nodes)
    if (!declared_.node_keys.count(node.key)) live_.scene.release(node.handle);
  staged_ = {};
  staging_.reset();
  phase_ = outer_phase_;
}

// The final state of what was declared: later lines and other files may have written to it.
void Script::capture_declarations() {
  for (DeclaredNode& node : staged_.nodes) {
    NodeDef def = staging_->def(node.handle);
    def.behaviours.clear();
    def.children.clear();
    def.joints.clear();
    def.id.clear();
    node.def = to_value(def);
    for (const char* key : {"children", "behaviours", "joints", "prefab", "id", "color"}) erase_key(node.def, key);
  }
  for (DeclaredJoint& joint : staged_.joints)
    if (const JointRecord* record = staging_->joint(joint.handle)) joint.options = record->options;
  staged_.settings = to_value(staging_settings_);
}

CommitResult Script::commit(bool partial) {
  capture_declarations();
  staging_.reset();
  phase_ = outer_phase_;
  CommitResult result;
  commit_nodes(partial, result);
  commit_joints(partial, result);
  if (!partial) commit_settings(result);
  if (partial) {
    declared_.nodes.insert(declared_.nodes.end(), staged_.nodes.begin(), staged_.nodes.end());
    declared_.joints.insert(declared_.joints.end(), staged_.joints.begin(), staged_.joints.end());
    declared_.node_keys.merge(staged_.node_keys);
    declared_.joint_keys.merge(staged_.joint_keys);
  } else {
    declared_ = std::move(staged_);
  }
  staged_ = {};
  lists_changed_ = true;
  return result;
}

void Script::commit_nodes(bool partial, CommitResult& result) {
  const auto before = by_key(declared_.nodes);
  std::set<std::string> still;
  for (const DeclaredNode& node : staged_.nodes) {
    still.insert(node.key);
    const auto old = before.find(node.key);
    if (old == before.end()) {
      try {
        NodeDef def;
        assign(def, node.def, "scene.add");
        live_.add(def, node.parent, Origin::declared, "scene.add", node.handle);
        result.added.push_back({node.handle, {}, node.behaviours});
        if (loaded_) result.log.push_back("new node " + def.name);
      } catch (const Error& error) {
        result.log.push_back(error.what());
      }
      continue;
    }
    std::vector<std::pair<std::string, Value>> changes;
    differences("", old->second->def, node.def, changes);
    const std::string name = live_.scene.get(node.handle) ? live_.scene[node.handle].name : "";
    for (const auto& [path, value] : changes) {
      live_.update_first_state(node.handle, path, value);
      if (!live_.alive(node.handle)) {
        result.log.push_back("a declared node was destroyed in play: its change waits for scene.restart()");
        break;
      }
      try {
        live_.set_field(node.handle, path, value, "reload");
        result.log.push_back(name + "." + path + " = " + text(value));
      } catch (const Error& error) {
        result.log.push_back(error.what());
      }
    }
    if (!(old->second->behaviours == node.behaviours) && live_.alive(node.handle))
      result.changed.push_back({node.handle, old->second->behaviours, node.behaviours});
  }
  if (partial) return;
  int removed = 0;
  for (const DeclaredNode& node : declared_.nodes) {
    if (still.count(node.key)) continue;
    if (live_.alive(node.handle)) {
      ++removed;
      result.log.push_back("node " + live_.scene[node.handle].name + " removed");
      destroy_node(node.handle);
    }
    live_.forget_first_state(node.handle);
  }
}

void Script::commit_joints(bool partial, CommitResult& result) {
  const auto before = by_key(declared_.joints);
  std::set<std::string> still;
  for (const DeclaredJoint& joint : staged_.joints) {
    still.insert(joint.key);
    const auto old = before.find(joint.key);
    const bool same_ends = old != before.end() && old->second->a == joint.a && old->second->b == joint.b && old->second->type == joint.type;
    try {
      if (same_ends && live_.joint(joint.handle)) {
        std::vector<std::pair<std::string, Value>> changes;
        differences("", old->second->options, joint.options, changes);
        for (const auto& [path, value] : changes) {
          live_.set_joint_field(joint.handle, path, value, "reload");
          result.log.push_back((joint.name.empty() ? "joint" : joint.name) + "." + path + " = " + text(value));
        }
        if (!changes.empty()) live_.update_first_state(joint.handle, joint.options);
      } else if (old == before.end()) {
        live_.add_joint(joint.type, joint.name, joint.a, joint.b, joint.options, Origin::declared, "joint", joint.handle);
      } else if (!same_ends) {
        result.log.push_back("joint " + joint.name + " holds other nodes now: F5 makes it anew");
      }
    } catch (const Error& error) {
      result.log.push_back(error.what());
    }
  }
  if (partial) return;
  for (const DeclaredJoint& joint : declared_.joints)
    if (!still.count(joint.key)) {
      live_.forget_first_state(joint.handle);
      if (live_.joint(joint.handle)) live_.destroy_joint(joint.handle);
    }
}

void Script::commit_settings(CommitResult& result) {
  const Value before = declared_.settings.is_nil() ? to_value(first_settings_) : declared_.settings;
  std::vector<std::pair<std::string, Value>> changes;
  differences("", before, staged_.settings, changes);
  if (changes.empty()) return;
  Value now = to_value(live_settings_);
  for (const auto& [path, value] : changes) {
    const std::size_t dot = path.find('.');
    if (dot == std::string::npos) now[path] = value;
    else now[path.substr(0, dot)][path.substr(dot + 1)] = value;
    if (loaded_) result.log.push_back(path + " = " + text(value));
  }
  assign(live_settings_, now, "reload");
  live_.configure_physics(live_settings_.physics);
}

}  // namespace tumble

// What the frame calls in each tick, in the order of app/frame.cpp.
#include "engine/ui/ui.h"
#include "script/bind.h"
#include "script/script.h"

namespace tumble {

namespace {
const char* notice_name(InputNotice::Kind kind) {
  switch (kind) {
    case InputNotice::Kind::press: return "on_press";
    case InputNotice::Kind::release: return "on_release";
    case InputNotice::Kind::pointer_move: return "on_pointer_move";
    case InputNotice::Kind::wheel: return "on_wheel";
    case InputNotice::Kind::text: return "on_text";
  }
  return "";
}
}  // namespace

void Script::take_ui_input(std::vector<InputEvent>& events) { ui_->take_input(events, 1 / live_.settings.tick_rate); }

void Script::deliver_input(const std::vector<InputNotice>& notices) {
  if (const auto heard = live_.input.take_heard()) {
    if (*heard == "escape") lua_pushnil(L_);
    else lua_pushlstring(L_, heard->data(), heard->size());
    call_boot("heard", 1, 0, Phase::run);
  }
  for (const InputNotice& notice : notices) {
    lua_pushboolean(L_, live_settings_.paused);
    lua_pushstring(L_, notice_name(notice.kind));
    int arguments = 3;
    if (notice.kind == InputNotice::Kind::pointer_move) {
      lua_pushnumber(L_, notice.x);
      lua_pushnumber(L_, notice.y);
      ++arguments;
    } else if (notice.kind == InputNotice::Kind::wheel) {
      lua_pushnumber(L_, notice.x);
    } else {
      lua_pushlstring(L_, notice.name.data(), notice.name.size());
    }
    call_boot("input", arguments, 0, Phase::run);
  }
}

bool Script::wants_text() {
  if (ui_->is_writing()) return true;
  lua_pushliteral(L_, "on_text");
  if (!call_boot("handles", 1, 1, Phase::run)) return false;
  const bool wanted = lua_toboolean(L_, -1);
  lua_pop(L_, 1);
  return wanted;
}

void Script::run_tasks(double) { call_boot("tasks", 0, 0, Phase::run); }

void Script::update(double dt) {
  lua_pushnumber(L_, dt);
  call_boot("update", 1, 0, Phase::run);
}

void Script::late_update(double dt) {
  lua_pushnumber(L_, dt);
  call_boot("late_update", 1, 0, Phase::run);
}

void Script::draw_ui() {
  ui_->begin(live_settings_.ui);
  lua_pushboolean(L_, live_settings_.paused);
  call_boot("draw_ui", 1, 0, Phase::run);
  ui_->end(kUiHeight * aspect, tick_drawing_.ui);
}

void Script::frame(double dt) {
  frame_drawing_ = {};
  lua_pushnumber(L_, dt);
  call_boot("frame", 1, 0, Phase::frame);
}

void Script::send(const std::string& message, const std::vector<Value>& arguments) {
  lua_pushnil(L_);
  lua_pushlstring(L_, message.data(), message.size());
  for (const Value& value : arguments) push_value(L_, value);
  call_boot("send", 2 + static_cast<int>(arguments.size()), 0, Phase::run);
}

void Script::event(NodeId node, const char* name, const std::function<void()>& push_argument) {
  if (!live_.scene.get(node)) return;
  push_node(node);
  lua_pushstring(L_, name);
  int arguments = 2;
  if (push_argument) {
    push_argument();
    ++arguments;
  }
  call_boot("event", arguments, 0, Phase::run);
}

void Script::physics_events(const Events& events, double began) {
  static const char* const names[2][3] = {{"on_collision_exit", "on_collision_enter", "on_collision_stay"},
                                          {"on_trigger_exit", "on_trigger_enter", "on_trigger_stay"}};
  for (const ContactEvent& contact : events.contacts) {
    const auto [a, b] = live_.nodes_of(contact);
    // A handler may have destroyed a partner meanwhile: its enters and stays are dropped, its exit is told.
    if (contact.kind != EventKind::exit && !(live_.alive(a) && live_.alive(b))) continue;
    const char* name = names[contact.trigger][static_cast<int>(contact.kind)];
    const auto push = [&](BodyId self) {
      HitData hit = hit_of(contact, self);
      hit.time = began + contact.time;
      push_hit(L_, hit);
    };
    event(a, name, [&] { push(contact.a); });
    if (contact.kind != EventKind::exit && !(live_.alive(a) && live_.alive(b))) continue;
    event(b, name, [&] { push(contact.b); });
  }
  for (const JointEvent& broken : events.breaks) {
    const JointRef id = live_.joint_of(broken.joint);
    JointRecord* joint = live_.joint(id);
    if (!joint) continue;
    joint->broken = true;
    const NodeId a = joint->a, b = joint->b;
    event(a, "on_joint_break", [&] { push_joint(id); });
    if (b) event(b, "on_joint_break", [&] { push_joint(id); });
  }
  for (const SleepEvent& sleep : events.sleeps) event(live_.node_of(sleep.body), sleep.asleep ? "on_sleep" : "on_wake", {});
}

void Script::animation_events(const std::vector<AnimationEnd>& ends) {
  for (const AnimationEnd& end : ends) event(end.node, "on_animation_end", [&] { lua_pushlstring(L_, end.clip.data(), end.clip.size()); });
}

void Script::run_bot(std::vector<InputEvent>& events) {
  ++bot_ticks_;
  bot_events_ = &events;
  call_boot("bot", 0, 0, testing_ ? Phase::run : Phase::watch);
  bot_events_ = nullptr;
}

}  // namespace tumble
